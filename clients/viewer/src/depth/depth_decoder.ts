import type {DepthFrame} from './decode_depth';
import type {DepthSummary} from './depth_summary';

export interface DecodedDepth {
  frame: DepthFrame;
  summary: DepthSummary;
  decode_ms: number;
}

type Reply = DecodedDepth | {problem: string};

/** Decodes depth in a worker of its own, one packet at a time. */
export class DepthDecoder {
  undecodable = 0;

  private readonly worker = new Worker('depth_worker.js', {type: 'module'});

  constructor(onDecoded: (decoded: DecodedDepth) => void, onProblem: () => void) {
    this.worker.onmessage = ({data}: MessageEvent<Reply>) => {
      if (!('problem' in data)) return onDecoded(data);
      if (this.undecodable++ === 0) console.error(data.problem);
      onProblem();
    };
  }

  decode(bytes: Uint8Array): void {
    const own = bytes.slice().buffer;  // a copy, since the packet is part of a WebSocket message
    this.worker.postMessage({packet: own}, [own]);
  }
}
