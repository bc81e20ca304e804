/** A recorded session in the server's folder. */
export interface Recorded {
  name: string;
  bytes: number;
  written_ms: number;  // since 1970
}

/** Reads the reply to GET /sessions: no sessions if the server offers none, or if it cannot be read. */
export function readSessions(text: string): Recorded[] {
  try {
    const {sessions} = JSON.parse(text) as {sessions?: Record<string, unknown>[]};
    if (!Array.isArray(sessions)) return [];
    return sessions.map(({name, bytes, written_s}) =>
        ({name: String(name), bytes: Number(bytes), written_ms: 1000 * Number(written_s)}));
  } catch {
    return [];
  }
}

/** The address that opens the recording for the page alone. */
export const addressOfSession = (name: string) => `?${new URLSearchParams({view: 'qa', session: name}).toString()}`;

/** "2026-03-01 12:00 UTC, 12.5 MB" */
export function recordedSays({bytes, written_ms}: Recorded): string {
  const written = new Date(written_ms).toISOString();
  return `${written.slice(0, 10)} ${written.slice(11, 16)} UTC, ${(bytes / 1e6).toFixed(1)} MB`;
}
