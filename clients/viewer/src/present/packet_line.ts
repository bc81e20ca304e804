export interface Packet {
  bytes: Uint8Array;
  captured_ns: bigint;
}

/** Bounds of what waits: a camera at 60 Hz may run a second ahead of the station's numbers. */
const MOST_WAITING = 64;
const MOST_BYTES = 16 * 1024 * 1024;

/** As codec/depth_packet.h has it: byte 5 names the coding, and 4 is the one that depends on the frame before. */
const CODING_AT = 5;
const DEPENDENT = 4;

const standsAlone = ({bytes}: Packet) => bytes[CODING_AT] !== DEPENDENT;

/**
 * The depth packets that wait to be decoded. What is too old to draw is dropped here, before it is decoded: when a packet
 * is asked for, one that stands alone replaces all before it. A packet that depends on the one before keeps its place,
 * and is of no use once that one is lost. No page, no worker: packets in, packets out.
 */
export class PacketLine {
  overtaken = 0;

  private waiting: Packet[] = [];
  private bytes = 0;
  private lost = true;  // from the start: what comes first may depend on what was sent to others

  /** False: the packet is of no use, for want of the one before it, and so is all until one stands alone. */
  push(packet: Packet): boolean {
    while (this.isFull(packet)) this.dropFirst(this.firstAlone(1) ?? this.waiting.length, !standsAlone(packet));
    if (this.lost && !standsAlone(packet)) {
      ++this.overtaken;
      return false;
    }
    this.lost = false;
    this.waiting.push(packet);
    this.bytes += packet.bytes.byteLength;
    return true;
  }

  /**
   * The packet to decode next, of those captured until `until_ns`. `wanted`: a picture is to be drawn now. Otherwise only
   * packets that a later one depends on are decoded ahead.
   */
  next(until_ns: bigint, wanted: boolean): Packet | undefined {
    let last = this.waiting.length - 1;
    while (last >= 0 && this.waiting[last]!.captured_ns > until_ns) --last;
    if (last < 0) return undefined;
    let from = last;
    while (from > 0 && !standsAlone(this.waiting[from]!)) --from;
    this.dropFirst(from, false);
    if (!wanted && last === from && standsAlone(this.waiting[0]!)) return undefined;
    const next = this.waiting.shift()!;
    this.bytes -= next.bytes.byteLength;
    return next;
  }

  /** The packet that was last taken could not be decoded. */
  failed(): void {
    this.dropFirst(this.firstAlone(0) ?? this.waiting.length, true);
  }

  /** Forgets all: another connection begins. */
  clear(): void {
    this.dropFirst(this.waiting.length, true);
  }

  private isFull({bytes}: Packet): boolean {
    return this.waiting.length >= MOST_WAITING ||
        (this.waiting.length > 0 && this.bytes + bytes.byteLength > MOST_BYTES);
  }

  private firstAlone(from: number): number | undefined {
    const found = this.waiting.findIndex((packet, at) => at >= from && standsAlone(packet));
    return found < 0 ? undefined : found;
  }

  /** `loses`: when nothing is left, what comes next has lost the packet that it depends on. */
  private dropFirst(count: number, loses: boolean): void {
    for (const {bytes} of this.waiting.splice(0, count)) this.bytes -= bytes.byteLength;
    this.overtaken += count;
    if (loses && this.waiting.length === 0) this.lost = true;
  }
}
