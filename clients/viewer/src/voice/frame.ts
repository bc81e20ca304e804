/** A frame of speech: 20 ms of one channel at 48 kHz, as on the topics /patient/voice and /doctor/voice. */
export const RATE_HZ = 48_000;
export const FRAME_SAMPLES = 960;
export const FRAME_MS = 20;
/** How many packets before its own a message repeats. */
export const MOST_EARLIER = 6;

/** A decoded frame. `number`: by the talker's clock, one more for each 20 ms. */
export interface SpokenFrame {
  talker: bigint;
  number: number;
  begun: number;  // number of the first frame since the talker opened the microphone
  spoken_ms: number;  // session time at which its first sample was at the microphone
  samples: Float32Array<ArrayBuffer>;
}
