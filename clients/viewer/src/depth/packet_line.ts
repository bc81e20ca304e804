export interface Packet {
  bytes: Uint8Array;
  captured_ns: bigint;
}

/** A second of frames that each depend on the one before: a page further behind begins anew with a key frame. */
const MOST_WAITING = 30;

/** As codec/depth_packet.h has it: byte 5 names the coding, and 4 is the one that depends on the frame before. */
const CODING_AT = 5;
const DEPENDENT = 4;

const standsAlone = ({bytes}: Packet) => bytes[CODING_AT] !== DEPENDENT;

/**
 * The depth packets that wait to be decoded. One that stands alone overtakes all that wait; one that depends on the one
 * before keeps its place, and is of no use once that one is lost. No page, no worker: packets in, packets out.
 */
export class PacketLine {
  overtaken = 0;

  private waiting: Packet[] = [];
  private lost = true;  // from the start: what comes first may depend on what was sent to others

  /** False: the packet is of no use, for want of the one before it, and so is all until one stands alone. */
  push(packet: Packet): boolean {
    if (standsAlone(packet)) {
      this.overtaken += this.waiting.length;
      this.waiting = [packet];
      this.lost = false;
      return true;
    }
    if (!this.lost && this.waiting.length < MOST_WAITING) {
      this.waiting.push(packet);
      return true;
    }
    if (!this.lost) this.loseAllWaiting();
    ++this.overtaken;
    return false;
  }

  shift(): Packet | undefined {
    return this.waiting.shift();
  }

  /** The packet that was last taken could not be decoded. */
  failed(): void {
    const next = this.waiting[0];
    if (next === undefined) this.lost = true;
    else if (!standsAlone(next)) this.loseAllWaiting();
  }

  /** A packet that stands alone is always the first that waits, so that all here depend on what is gone. */
  private loseAllWaiting(): void {
    this.overtaken += this.waiting.length;
    this.waiting = [];
    this.lost = true;
  }
}
