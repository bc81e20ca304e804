import {type ReadingState, ReadingState_Phase, type SessionList} from '../messages/generated';

/** A recorded session in the server's folder. */
export interface Recorded {
  name: string;
  bytes: number;
  written_ms: number;  // since 1970
}

/** A part of a session file: the body of POST /sessions. */
export interface SessionPart {
  name: string;
  from: number;
  data: string;  // in base64
  complete: boolean;
}

export const PART_BYTES = 600_000;

export const readSessions = ({sessions}: SessionList): Recorded[] =>
    sessions.map(({name, bytes, writtenS}) => ({name, bytes: Number(bytes), written_ms: 1000 * Number(writtenS)}));

/** How much of a session's index the server has read; undefined: the session is open, or cannot be opened. */
export const openingShare = ({phase, readShare}: ReadingState) => (phase === ReadingState_Phase.OPENING ? readShare : undefined);

/** Sends `file` to the server in parts. `send` resolves with the reason why a part was refused; empty: it was taken. */
export async function bring(
    file: File, send: (part: SessionPart) => Promise<string>, told: (share: number) => void): Promise<string> {
  for (let from = 0; from < file.size; from += PART_BYTES) {
    const bytes = new Uint8Array(await file.slice(from, from + PART_BYTES).arrayBuffer());
    const complete = from + bytes.length === file.size;
    const refused = await send({name: file.name, from, data: base64(bytes), complete});
    if (refused !== '') return refused;
    told((from + bytes.length) / file.size);
  }
  return file.size === 0 ? 'The file is empty.' : '';
}

function base64(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}

/** The address that opens the recording for the page alone. */
export const addressOfSession = (name: string) => `?${new URLSearchParams({view: 'qa', session: name}).toString()}`;

/** "2026-03-01 12:00 UTC, 12.5 MB" */
export function recordedSays({bytes, written_ms}: Recorded): string {
  const written = new Date(written_ms).toISOString();
  return `${written.slice(0, 10)} ${written.slice(11, 16)} UTC, ${(bytes / 1e6).toFixed(1)} MB`;
}
