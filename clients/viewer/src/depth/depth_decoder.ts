import type {DepthFrame} from './decode_depth';
import type {DepthSummary} from './depth_summary';

export interface DecodedDepth {
  frame: DepthFrame;
  summary: DepthSummary;
  decode_ms: number;
}

type Reply = DecodedDepth | {problem: string};

/** Decodes depth beside the page's own thread. One packet at a time; of those that wait, the newest wins. */
export class DepthDecoder {
  overtaken = 0;
  undecodable = 0;

  private readonly worker = new Worker('depth_worker.js', {type: 'module'});
  private waiting: {packet: Uint8Array; captured_ns: bigint} | undefined;
  private decoding_ns: bigint | undefined;

  constructor(onDecoded: (decoded: DecodedDepth, captured_ns: bigint) => void) {
    this.worker.onmessage = ({data}: MessageEvent<Reply>) => {
      const captured_ns = this.decoding_ns ?? 0n;
      this.decoding_ns = undefined;
      if ('problem' in data) {
        if (this.undecodable++ === 0) console.error(data.problem);
      } else {
        onDecoded(data, captured_ns);
      }
      const next = this.waiting;
      this.waiting = undefined;
      if (next !== undefined) this.send(next.packet, next.captured_ns);
    };
  }

  decode(packet: Uint8Array, captured_ns: bigint): void {
    if (this.decoding_ns === undefined) return this.send(packet, captured_ns);
    if (this.waiting !== undefined) ++this.overtaken;
    this.waiting = {packet, captured_ns};
  }

  private send(packet: Uint8Array, captured_ns: bigint): void {
    this.decoding_ns = captured_ns;
    const own = packet.slice().buffer;  // the packet lies inside a whole WebSocket message, which is not ours to give
    this.worker.postMessage({packet: own}, [own]);
  }
}
