import type {ComparedRuns, ComparisonState} from '../../../playback/comparison_state';
import {clock} from '../../../playback/timeline_words';
import {lookOf} from '../../../words/phases';

const newtons = (force_N: number | null | undefined) => `${(force_N ?? 0).toFixed(2)} N`;

/** The state of the comparison as a sentence. */
export function comparisonSays({with: other, complete, problem, runs}: ComparisonState): string {
  if (other === '') return 'A is the played session.';
  if (!complete) return 'Reading both sessions…';
  if (problem !== '' || runs === undefined) return problem;
  const aligned = runs.same_time ? 'Both runs are shown at their session times.' : 'Recorded at different times: B is shifted, so that both begin together.';
  if (runs.first === undefined) return `The hand feels no difference between A and B. ${aligned}`;
  const {force_a_N, force_b_N, apart_N} = runs.first;
  return `At the first difference, ${newtons(force_a_N)} in A, ${newtons(force_b_N)} in B; the force vectors differ by ${newtons(apart_N)}. ${aligned}`;
}

/** What both runs are at `at_s`; empty outside the time axis. */
export function momentSays({at_s, a, b, apart_N}: ComparedRuns, moment_s: number): string {
  const first_s = at_s[0] ?? 0;
  const bin_s = (at_s[1] ?? first_s + 1) - first_s;
  const bin = Math.round((moment_s - first_s) / bin_s);
  if (bin < 0 || bin >= at_s.length) return '';
  const run = (name: string, {force_N, indentation_mm, phase}: typeof a) => phase[bin]
    ? `${name} ${newtons(force_N[bin])}, ${(indentation_mm[bin] ?? 0).toFixed(0)} mm, ${lookOf(phase[bin]).name}`
    : `${name} has no state`;
  const apart = apart_N[bin] === null ? '' : `; the force vectors differ by ${newtons(apart_N[bin])}`;
  return `${clock(at_s[bin] ?? 0)}: ${run('A', a)}; ${run('B', b)}${apart}`;
}
