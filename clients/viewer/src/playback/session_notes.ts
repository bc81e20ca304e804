import type {Resource} from '../link/resource';
import type {SessionNotes} from '../messages/generated';

/** A note at a moment of the played session. */
export interface Note {
  number: number;
  at_s: number;
  text: string;
  who: string;
  written: string;
}

/** The body of POST /playback/notes. */
export type NoteCommand = {at_s: number; text: string} | {remove: number};

/** The played session's notes. */
export type Notes = Resource<SessionNotes, Note[], NoteCommand>;

export const readNotes = ({notes}: SessionNotes): Note[] =>
    notes.map(({number, atS, text, who, written}) => ({number: Number(number), at_s: atS, text, who, written}));

/** A text that changes when the notes change. The numbers alone do not suffice: each session counts its notes from 1. */
export const keyOf = (notes: readonly Note[]) => notes.map(({number, written}) => `${number} ${written}`).join();

/** The note that the address names; undefined: none. */
export function noteInAddress(search: string): number | undefined {
  const asked = new URLSearchParams(search).get('note');
  return asked !== null && /^\d{1,9}$/.test(asked) ? Number(asked) : undefined;
}
