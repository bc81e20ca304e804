import type {DepthFrame} from './decode_depth';

/** The facts about a frame that the page needs besides its samples. */
export interface DepthSummary {
  measured: number;  // number of measured samples
  near_m: number;    // 5th, 50th and 95th percentile of the middle half of the picture
  middle_m: number;
  far_m: number;
  holes: number;       // share of the middle half that is not measured
  level_m: number;     // usual distance of neighbouring depth levels about middle_m: the step of the sensor; 0: unknown
  histogram: number[]; // share of the whole picture in each HISTOGRAM_BIN_M of depth, from 0; the last one holds the rest
  aside: {x: number; y: number};  // middle of the nearest part, from the picture's middle, in half pictures: -1 to 1
}

export const HISTOGRAM_BIN_M = 0.025;
const BINS = 100;
const LEVELS = 65536;
const SAMPLE_EVERY = 7;  // enough for percentiles, whatever the width
const PATIENT_M = 0.15;  // the patient's front reaches this far behind the nearest 5 %

/** Facts about `frame`; those of an empty middle are 0. */
export function summarise(frame: DepthFrame): DepthSummary {
  const {width, height, unit_m, samples} = frame;
  let measured = 0;
  for (let i = 0; i < samples.length; ++i) if (samples[i] !== 0) ++measured;
  const seen = new Uint32Array(LEVELS);  // a histogram, because sorting took as long as decoding
  let total = 0;
  let looked = 0;
  for (let row = height >> 2; row < height - (height >> 2); ++row)
    for (let column = width >> 2; column < width - (width >> 2); column += SAMPLE_EVERY) {
      ++looked;
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
  const [near_m, middle_m] = [at(0.05), at(0.5)];
  return {
    measured, near_m, middle_m, far_m: at(0.95),
    holes: looked === 0 ? 0 : 1 - total / looked,
    level_m: levelSize(seen, middle_m / unit_m) * unit_m,
    ...spread(frame, near_m + PATIENT_M),
  };
}

/** The median distance of occupied levels within 5 % of `middle`; 0 if there are fewer than three. */
function levelSize(seen: Uint32Array, middle: number): number {
  const gaps: number[] = [];
  let before: number | undefined;
  for (let level = Math.floor(0.95 * middle); level <= 1.05 * middle && level < LEVELS; ++level) {
    if (level < 1 || seen[level] === 0) continue;
    if (before !== undefined) gaps.push(level - before);
    before = level;
  }
  return gaps.length < 2 ? 0 : gaps.sort((a, b) => a - b)[gaps.length >> 1]!;
}

/** The histogram of the whole picture, and where the part nearer than `front_m` lies. */
function spread({width, height, unit_m, samples}: DepthFrame, front_m: number): Pick<DepthSummary, 'histogram' | 'aside'> {
  const histogram = new Array<number>(BINS).fill(0);
  let [count, looked, x, y] = [0, 0, 0, 0];
  for (let row = 0; row < height; row += 4)
    for (let column = row % 8; column < width; column += SAMPLE_EVERY) {
      ++looked;
      const z_m = (samples[row * width + column] ?? 0) * unit_m;
      if (z_m === 0) continue;
      const bin = Math.min(BINS - 1, Math.floor(z_m / HISTOGRAM_BIN_M));
      histogram[bin] = histogram[bin]! + 1;
      if (z_m > front_m) continue;
      ++count;
      x += column;
      y += row;
    }
  const fromMiddle = (sum: number, size: number) => (count === 0 ? 0 : (2 * sum) / count / size - 1);
  return {
    histogram: histogram.map((pixels) => pixels / Math.max(1, looked)),
    aside: {x: fromMiddle(x, width), y: fromMiddle(y, height)},
  };
}
