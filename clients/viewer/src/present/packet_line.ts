export interface Packet {
  bytes: Uint8Array;
  captured_ns: bigint;
}

/** Limits of the waiting packets: a camera at 60 Hz may be a second ahead of the station's values. */
const MOST_WAITING = 64;
const MOST_BYTES = 16 * 1024 * 1024;

/** From the depth packet's header: byte 5 is the coding, and coding 4 depends on the previous frame. */
const CODING_AT = 5;
const PREDICTED = 4;

const isKeyFrame = ({bytes}: Packet) => bytes[CODING_AT] !== PREDICTED;

/**
 * The depth packets that wait to be decoded. Packets that are too old to draw are dropped before they are decoded: a
 * key frame replaces all packets before it. A predicted frame keeps its place in the queue, and it is dropped if its
 * reference frame is lost. This class uses neither the page nor a worker.
 */
export class PacketLine {
  overtaken = 0;

  private waiting: Packet[] = [];
  private bytes = 0;
  private lost = true;  // true at the start, because the first packet may depend on an earlier one

  /** False: the packet lacks its reference frame, so it and all packets until the next key frame are dropped. */
  push(packet: Packet): boolean {
    while (this.isFull(packet)) this.dropFirst(this.firstKeyFrame(1) ?? this.waiting.length, !isKeyFrame(packet));
    if (this.lost && !isKeyFrame(packet)) {
      ++this.overtaken;
      return false;
    }
    this.lost = false;
    this.waiting.push(packet);
    this.bytes += packet.bytes.byteLength;
    return true;
  }

  /**
   * The packet to decode next, among those captured until `until_ns`. `wanted`: a picture is needed now. Otherwise only
   * packets on which a later one depends are decoded in advance.
   */
  next(until_ns: bigint, wanted: boolean): Packet | undefined {
    let last = this.waiting.length - 1;
    while (last >= 0 && this.waiting[last]!.captured_ns > until_ns) --last;
    if (last < 0) return undefined;
    let from = last;
    while (from > 0 && !isKeyFrame(this.waiting[from]!)) --from;
    this.dropFirst(from, false);
    if (!wanted && last === from && isKeyFrame(this.waiting[0]!)) return undefined;
    const next = this.waiting.shift()!;
    this.bytes -= next.bytes.byteLength;
    return next;
  }

  /** The packet that was last taken could not be decoded. */
  failed(): void {
    this.dropFirst(this.firstKeyFrame(0) ?? this.waiting.length, true);
  }

  /** Discards all packets, because a new connection begins. */
  clear(): void {
    this.dropFirst(this.waiting.length, true);
  }

  private isFull({bytes}: Packet): boolean {
    return this.waiting.length >= MOST_WAITING ||
        (this.waiting.length > 0 && this.bytes + bytes.byteLength > MOST_BYTES);
  }

  private firstKeyFrame(from: number): number | undefined {
    const found = this.waiting.findIndex((packet, at) => at >= from && isKeyFrame(packet));
    return found < 0 ? undefined : found;
  }

  /** `loses`: if no packet remains, the next packet lacks its reference frame. */
  private dropFirst(count: number, loses: boolean): void {
    for (const {bytes} of this.waiting.splice(0, count)) this.bytes -= bytes.byteLength;
    this.overtaken += count;
    if (loses && this.waiting.length === 0) this.lost = true;
  }
}
