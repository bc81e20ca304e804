import {decodeDepth} from './decode_depth';
import {summarise} from './depth_summary';

/** The worker's answer to each packet: a frame with its summary, or the reason why there is none. */
onmessage = ({data}: MessageEvent<{packet: ArrayBuffer}>) => {
  try {
    const began_ms = performance.now();
    const frame = decodeDepth(new Uint8Array(data.packet));
    const summary = summarise(frame);
    postMessage({frame, summary, decode_ms: performance.now() - began_ms}, {transfer: [frame.samples.buffer]});
  } catch (problem) {
    postMessage({problem: String(problem)});
  }
};
