import type {LiveNote, MarksState} from '../messages/generated';

/** How long words stand on the picture [s]. */
export const STANDS_S = 20;

/** What was said in the last STANDS_S, the oldest first. A mark with neither words nor a place says nothing, so it is left out. */
export function standing(state: MarksState | undefined, now_ns: bigint | undefined): LiveNote[] {
  if (state === undefined || now_ns === undefined) return [];
  const since_ns = now_ns - BigInt(STANDS_S) * 1_000_000_000n;
  return state.newest.filter(({atNs, text, atM}) => atNs > since_ns && (text !== '' || atM !== undefined));
}

/** As "doctor Anna: turn him to the left". A page on the server's own computer has neither name nor role. */
export function inWords({who, text}: LiveNote): string {
  const writer = who === 'local local' ? 'At the server' : who;
  return text === '' ? `${writer} points here` : `${writer}: ${text}`;
}
