// What the ticks of two stations say about each other: pure functions over their computing times.
import {atMost, measured} from './rows.mjs';

/** The column of a CSV text with a header line, as numbers. */
export function column(csv, name) {
  const [header, ...lines] = csv.trim().split('\n');
  const at = header.split(',').indexOf(name);
  if (at < 0) throw new Error(`the ticks have no column ${name}`);
  return lines.map((line) => Number(line.split(',')[at]));
}

/** The smallest value that a share of at most 1 - q of `values` exceeds. */
export function quantile(values, q) {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.max(0, Math.ceil(q * sorted.length) - 1))];
}

export function median(values) {
  const sorted = Float64Array.from(values).sort();
  const middle = Math.floor(sorted.length / 2);
  return sorted.length % 2 === 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

/** Greatest over least p99.9 of the base's runs, which are all alike: how much the machine disturbs a run. */
export function disturbance(pairs) {
  const all = pairs.map(({base}) => base.p999);
  return Math.max(...all) / Math.min(...all);
}

/** `pairs`: of runs, each with the quantiles {p50, p999} of a tick's computing time [us]. */
export function ratioRows(pairs, reach) {
  const ratios = (of) => pairs.map(({base, head}) => head[of] / base[of]);
  const rounded = (value) => Number(value.toFixed(3));
  const all = ratios('p999');
  return [
    atMost(`tick's work_us p99.9, of the base's: median of ${pairs.length} ratios`, rounded(median(all)), 'x', reach),
    measured("tick's work_us p99.9, of the base's: least ratio", rounded(Math.min(...all)), 'x'),
    measured("tick's work_us p99.9, of the base's: greatest ratio", rounded(Math.max(...all)), 'x'),
    measured("the base's p99.9: greatest of its runs, of the least", rounded(disturbance(pairs)), 'x'),
    measured("tick's work_us p50, of the base's: median of the ratios", rounded(median(ratios('p50'))), 'x'),
    measured("tick's work_us p99.9: median", rounded(median(pairs.map(({head}) => head.p999))), 'us'),
    measured("tick's work_us p99.9 of the base: median", rounded(median(pairs.map(({base}) => base.p999))), 'us'),
  ];
}
