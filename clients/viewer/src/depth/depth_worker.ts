import {decodeDepth} from './decode_depth';
import {summarise} from './depth_summary';

/** What the worker posts for each packet: a frame with its summary, or why there is none. */
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
