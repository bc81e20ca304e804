const STEPS_S = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20];
const MOST_STEPS = 4;

/** The times to mark between `from_s` and `to_s`: round distances from `end_s`, the newest time. */
export function timeMarks(from_s: number, to_s: number, end_s: number): number[] {
  const step_s = STEPS_S.find((step) => to_s - from_s <= MOST_STEPS * step) ?? to_s - from_s;
  const marks: number[] = [];
  for (let at = Math.ceil((from_s - end_s) / step_s); end_s + at * step_s <= to_s + 1e-9; ++at) marks.push(end_s + at * step_s);
  return marks;
}

/** "−5 s": the time before the newest value. */
export function sinceNow(at_s: number, end_s: number): string {
  const past_s = Math.round(10 * (end_s - at_s)) / 10;
  return past_s === 0 ? '0 s' : `${past_s > 0 ? '−' : ''}${Math.abs(past_s)} s`;
}
