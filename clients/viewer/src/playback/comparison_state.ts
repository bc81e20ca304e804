import type {ComparisonState as ComparisonMessage, ComparisonState_Run, Phase} from '../messages/generated';

/** The body of POST /playback/comparison; `with` is empty to end the comparison. */
export interface ComparisonCommand {
  with?: string;
}

/** One run in equal bins of the common time axis; null where it has no state. */
export interface ComparedRun {
  force_N: readonly (number | null)[];
  indentation_mm: readonly (number | null)[];
  phase: readonly Phase[];
}

/** The first instant in contact at which the forces differ by more than a hand notices. */
export interface FirstDifference {
  at_s: number;  // since the beginning of the played session
  force_a_N: number;
  force_b_N: number;
  apart_N: number;
}

/** Two runs on one time axis; times count from the beginning of A. */
export interface ComparedRuns {
  at_s: readonly number[];  // middle of each bin
  a: ComparedRun;
  b: ComparedRun;
  apart_N: readonly (number | null)[];  // null where one of them has no state
  same_time: boolean;
  first: FirstDifference | undefined;
}

/** What the server compares the played session with. */
export interface ComparisonState {
  sessions: readonly string[];
  with: string;
  complete: boolean;
  problem: string;
  runs: ComparedRuns | undefined;  // undefined: nothing is compared, or not yet
}

const runOf = (run: ComparisonState_Run | undefined): ComparedRun =>
    ({force_N: run?.forceN ?? [], indentation_mm: run?.indentationMm ?? [], phase: run?.phase ?? []});

/** From state to state: they come each 10 ms, two may be missing. Bins of a short session are shorter than that. */
const LONGEST_GAP_S = 0.035;

/** For each bin the bin whose values it shows: itself, or in a short gap between two states the last one before it. */
function heldBins(phase: readonly Phase[], bin_s: number): number[] {
  const held = phase.map((_, bin) => bin);
  let last: number | undefined;
  phase.forEach((now, bin) => {
    if (!now) return;
    if (last !== undefined && (bin - last) * bin_s <= LONGEST_GAP_S) held.fill(last, last + 1, bin);
    last = bin;
  });
  return held;
}

function withoutGaps({force_N, indentation_mm, phase}: ComparedRun, bin_s: number): ComparedRun {
  const held = heldBins(phase, bin_s);
  const shown = (list: typeof force_N) => held.map((bin) => (phase[bin] ? list[bin] ?? 0 : null));
  return {force_N: shown(force_N), indentation_mm: shown(indentation_mm), phase: held.map((bin) => phase[bin] ?? 0)};
}

function readRuns({a: runA, b: runB, apartN, beginS, binS, sameTime, first}: ComparisonMessage): ComparedRuns | undefined {
  if (apartN.length === 0) return undefined;
  const [own, other] = [runOf(runA), runOf(runB)];
  const [a, b] = [withoutGaps(own, binS), withoutGaps(other, binS)];
  return {
    at_s: apartN.map((_, bin) => beginS + (bin + 0.5) * binS),
    a,
    b,
    apart_N: heldBins(own.phase, binS).map((bin, at) => (a.phase[at] && b.phase[at] ? apartN[bin] ?? 0 : null)),
    same_time: sameTime,
    first: first && {at_s: first.atS, force_a_N: first.forceAN, force_b_N: first.forceBN, apart_N: first.apartN},
  };
}

export function readComparison(message: ComparisonMessage): ComparisonState {
  const {sessions, with: other, complete, problem} = message;
  return {sessions, with: other, complete, problem, runs: readRuns(message)};
}
