import type {Phase} from '../../messages/generated';
import type {Forces} from '../../present/instant';
import {lookOf} from '../../words/phases';

/** What a snapshot says below its picture: all of the picture's instant. */
export interface SnapshotFacts {
  forces: Forces | undefined;       // undefined: not known, as the next two
  indentation_m: number | undefined;
  phase: Phase | undefined;
  exposed_ms: number | undefined;   // of the exposure, since 1970; of a played session, as recorded
  source: string;                   // as the server names it
  moment_s: number | undefined;     // of the played session; undefined: live
  stale: boolean;
}

/** 2026-03-01 12:00:00.250 UTC */
const utc = (ms: number) => new Date(ms).toISOString().replace('T', ' ').replace('Z', ' UTC');

/** "session:/data/2026/anna.mcap" becomes "session anna.mcap". */
const named = (source: string) => source.replace(/^session:(.*\/)?/, 'session ');

function valuesLine({forces, indentation_m, phase}: SnapshotFacts): string {
  if (forces === undefined || indentation_m === undefined) return 'Force and indentation are not known';
  const drive = forces.drive_N < 0.05 ? '' : `, drive ${forces.drive_N.toFixed(1)} N`;
  return `Force ${forces.force_N.toFixed(1)} N${drive}, indentation ${(1000 * indentation_m).toFixed(0)} mm, ${lookOf(phase).name}`;
}

/** The lines below the picture: force, time and session, and what telepalp is not. */
export function snapshotLines(facts: SnapshotFacts): string[] {
  const {exposed_ms, source, moment_s, stale} = facts;
  const at = moment_s === undefined ? '' : ` at ${Math.floor(moment_s / 60)}:${(moment_s % 60).toFixed(2).padStart(5, '0')}`;
  return [
    valuesLine(facts),
    `${exposed_ms === undefined ? '' : `${utc(exposed_ms)}, `}${named(source)}${at}`,
    `${stale ? 'Stale picture. ' : ''}telepalp is not a medical device`,
  ];
}
