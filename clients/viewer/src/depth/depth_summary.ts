import type {DepthFrame} from './decode_depth';

/** The facts about a frame that the scene needs besides its samples. */
export interface DepthSummary {
  measured: number;  // number of measured samples
  near_m: number;    // 5th, 50th and 95th percentile of the middle half of the picture
  middle_m: number;
  far_m: number;
}

const LEVELS = 65536;
const SAMPLE_EVERY = 7;  // enough for percentiles, whatever the width

/** Counts and percentiles of `frame`; the percentiles are 0 when the middle of the picture is all holes. */
export function summarise({width, height, unit_m, samples}: DepthFrame): DepthSummary {
  let measured = 0;
  for (let i = 0; i < samples.length; ++i) if (samples[i] !== 0) ++measured;
  const seen = new Uint32Array(LEVELS);  // a histogram, because sorting took as long as decoding
  let total = 0;
  for (let row = height >> 2; row < height - (height >> 2); ++row)
    for (let column = width >> 2; column < width - (width >> 2); column += SAMPLE_EVERY) {
      const sample = samples[row * width + column] ?? 0;
      if (sample === 0) continue;
      seen[sample] = (seen[sample] ?? 0) + 1;
      ++total;
    }
  const at = (share: number) => {
    let left = Math.max(0, Math.floor(share * (total - 1)));
    const level = seen.findIndex((count) => (left -= count) < 0);
    return Math.max(0, level) * unit_m;
  };
  return {measured, near_m: at(0.05), middle_m: at(0.5), far_m: at(0.95)};
}
