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

/** Reads the reply to GET and POST /playback/notes; undefined when it is none. */
export function readNotes(text: string): Note[] | undefined {
  try {
    const {notes} = JSON.parse(text) as {notes?: Record<string, unknown>[]};
    if (!Array.isArray(notes)) return undefined;
    return notes.map(({number, at_s, text: says, who, written}) =>
        ({number: Number(number), at_s: Number(at_s), text: String(says), who: String(who), written: String(written)}));
  } catch {
    return undefined;
  }
}

/** A text that changes when the notes change. The numbers alone do not suffice: each session counts its notes from 1. */
export const keyOf = (notes: readonly Note[]) => notes.map(({number, written}) => `${number} ${written}`).join();

/** The note that the address names; undefined: none. */
export function noteInAddress(search: string): number | undefined {
  const asked = new URLSearchParams(search).get('note');
  return asked !== null && /^\d{1,9}$/.test(asked) ? Number(asked) : undefined;
}
