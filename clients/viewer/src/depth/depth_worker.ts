import {decodeDepth, setDecoder} from './decode_depth';
import {summarise} from './depth_summary';

/** First the decoder, which gets no answer; then packets. */
export type ToDepthWorker = {module: WebAssembly.Module} | {packet: ArrayBuffer};

/** The worker's answer to each packet: a frame with its summary, or the reason why there is none. */
onmessage = ({data}: MessageEvent<ToDepthWorker>) => {
  if ('module' in data) return setDecoder(data.module);
  try {
    const began_ms = performance.now();
    const frame = decodeDepth(new Uint8Array(data.packet));
    const summary = summarise(frame);
    postMessage({frame, summary, decode_ms: performance.now() - began_ms}, {transfer: [frame.samples.buffer]});
  } catch (problem) {
    postMessage({problem: String(problem)});
  }
};
