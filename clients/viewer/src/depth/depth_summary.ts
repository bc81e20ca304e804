import type {DepthFrame} from './decode_depth';

/** What the scene needs to know of a frame beside its samples. */
export interface DepthSummary {
  measured: number;  // samples that are not holes
  near_m: number;    // 5th, 50th and 95th percentile of the middle half of the picture
  middle_m: number;
  far_m: number;
}

const SAMPLE_EVERY = 7;  // enough for percentiles, whatever the width

/** Counts and percentiles of `frame`; the percentiles are 0 when the middle of the picture is all holes. */
export function summarise({width, height, unit_m, samples}: DepthFrame): DepthSummary {
  let measured = 0;
  for (const sample of samples) if (sample !== 0) ++measured;
  const middle: number[] = [];
  for (let row = height >> 2; row < height - (height >> 2); ++row)
    for (let column = width >> 2; column < width - (width >> 2); column += SAMPLE_EVERY) {
      const sample = samples[row * width + column] ?? 0;
      if (sample !== 0) middle.push(sample);
    }
  middle.sort((a, b) => a - b);
  const at = (share: number) => (middle[Math.floor(share * (middle.length - 1))] ?? 0) * unit_m;
  return {measured, near_m: at(0.05), middle_m: at(0.5), far_m: at(0.95)};
}
