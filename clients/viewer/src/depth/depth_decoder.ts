import type {DepthFrame} from './decode_depth';
import type {DepthSummary} from './depth_summary';
import type {ToDepthWorker} from './depth_worker';

export interface DecodedDepth {
  frame: DepthFrame;
  summary: DepthSummary;
  decode_ms: number;
}

type Reply = DecodedDepth | {problem: string};

/** Decodes depth in a worker of its own, one packet at a time. The decoder is loaded at once, and kept. */
export class DepthDecoder {
  undecodable = 0;

  private readonly worker = new Worker('depth_worker.js', {type: 'module'});
  private loaded: Promise<void> | undefined;

  constructor(private readonly onDecoded: (decoded: DecodedDepth) => void, private readonly onProblem: () => void) {
    this.worker.onmessage = ({data}: MessageEvent<Reply>) => {
      if ('problem' in data) this.fail(data.problem);
      else this.onDecoded(data);
    };
    this.loaded = this.load();
    this.loaded.catch(() => (this.loaded = undefined));
  }

  decode(bytes: Uint8Array): void {
    const own = bytes.slice().buffer;  // a copy, since the packet is part of a WebSocket message
    this.loaded ??= this.load();
    this.loaded.then(() => this.say({packet: own}, [own]), (problem) => {
      this.loaded = undefined;  // the server may be away: the next packet tries again
      this.fail(`depth_decoder.wasm: ${String(problem)}`);
    });
  }

  private async load(): Promise<void> {
    this.say({module: await WebAssembly.compileStreaming(fetch('depth_decoder.wasm'))});
  }

  private fail(problem: string): void {
    if (this.undecodable++ === 0) console.error(problem);
    this.onProblem();
  }

  private say(message: ToDepthWorker, own: Transferable[] = []): void {
    this.worker.postMessage(message, own);
  }
}
