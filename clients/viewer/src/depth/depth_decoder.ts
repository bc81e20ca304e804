import type {DepthFrame} from './decode_depth';
import type {DepthSummary} from './depth_summary';
import {PacketLine} from './packet_line';

export interface DecodedDepth {
  frame: DepthFrame;
  summary: DepthSummary;
  decode_ms: number;
}

type Reply = DecodedDepth | {problem: string};

const ASK_AGAIN_MS = 500;

/** Decodes depth beside the page's own thread, one packet at a time. */
export class DepthDecoder {
  undecodable = 0;

  private readonly worker = new Worker('depth_worker.js', {type: 'module'});
  private readonly line = new PacketLine();
  private decoding_ns: bigint | undefined;
  private asked_ms = -ASK_AGAIN_MS;

  /** `onLost`: nothing can be shown until a frame comes that stands alone; ask for one. At most twice a second. */
  constructor(onDecoded: (decoded: DecodedDepth, captured_ns: bigint) => void, private readonly onLost: () => void) {
    this.worker.onmessage = ({data}: MessageEvent<Reply>) => {
      const captured_ns = this.decoding_ns ?? 0n;
      this.decoding_ns = undefined;
      if ('problem' in data) {
        if (this.undecodable++ === 0) console.error(data.problem);
        this.line.failed();
      } else {
        onDecoded(data, captured_ns);
      }
      this.decodeNext();
    };
  }

  get overtaken(): number {
    return this.line.overtaken;
  }

  decode(bytes: Uint8Array, captured_ns: bigint): void {
    if (!this.line.push({bytes, captured_ns})) this.ask();
    this.decodeNext();
  }

  private ask(): void {
    const now_ms = performance.now();
    if (now_ms - this.asked_ms < ASK_AGAIN_MS) return;
    this.asked_ms = now_ms;
    this.onLost();
  }

  private decodeNext(): void {
    if (this.decoding_ns !== undefined) return;
    const next = this.line.shift();
    if (next === undefined) return;
    this.decoding_ns = next.captured_ns;
    const own = next.bytes.slice().buffer;  // the packet lies inside a whole WebSocket message, which is not ours to give
    this.worker.postMessage({packet: own}, [own]);
  }
}
