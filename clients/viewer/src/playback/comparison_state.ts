import type {Phase} from '../messages/generated';
import {phaseNamed} from './session_overview';

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

/** The reply to GET and POST /playback/comparison. */
export interface ComparisonState {
  sessions: readonly string[];
  with: string;
  complete: boolean;
  problem: string;
  runs: ComparedRuns | undefined;  // undefined: nothing is compared, or not yet
}

const numbers = (list: unknown) => (Array.isArray(list) ? list.map(Number) : []);

function readRun(run: Record<string, unknown> | undefined): ComparedRun {
  return {
    force_N: numbers(run?.['force_N']),
    indentation_mm: numbers(run?.['indentation_mm']),
    phase: Array.isArray(run?.['phase']) ? run['phase'].map(phaseNamed) : [],
  };
}

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

function readRuns(json: Record<string, unknown>): ComparedRuns | undefined {
  const apart_N = numbers(json['apart_N']);
  if (apart_N.length === 0) return undefined;
  const [begin_s, bin_s] = [Number(json['begin_s']), Number(json['bin_s'])];
  const [own, other] = [json['a'], json['b']].map((run) => readRun(run as Record<string, unknown>)) as [ComparedRun, ComparedRun];
  const [a, b] = [withoutGaps(own, bin_s), withoutGaps(other, bin_s)];
  return {
    at_s: apart_N.map((_, bin) => begin_s + (bin + 0.5) * bin_s),
    a,
    b,
    apart_N: heldBins(own.phase, bin_s).map((bin, at) => (a.phase[at] && b.phase[at] ? apart_N[bin] ?? 0 : null)),
    same_time: json['same_time'] === true,
    first: json['first'] === undefined || json['first'] === null ? undefined : json['first'] as FirstDifference,
  };
}

/** Reads the server's reply; undefined if this server compares nothing, or the reply cannot be read. */
export function readComparison(text: string): ComparisonState | undefined {
  try {
    const json = JSON.parse(text) as Record<string, unknown>;
    if (!Array.isArray(json['sessions'])) return undefined;
    return {
      sessions: json['sessions'].map(String), with: String(json['with']), complete: json['complete'] === true,
      problem: String(json['problem']), runs: readRuns(json),
    };
  } catch {
    return undefined;
  }
}
