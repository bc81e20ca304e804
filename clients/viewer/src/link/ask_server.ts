import {ownQuery} from './own_session';

/**
 * The server's answer; undefined: it did not answer. `published_ns`: session time at which the state after a command was
 * published on the topic of the path; 0n: it was not.
 */
export type Answer = {status: number; text: string; published_ns: bigint} | undefined;

const PATIENCE_MS = 3000;
/** The server answers the last part of a session file when it has read the file's index. */
const OF_FILES_MS = 60_000;

/** Sends the page's server a POST of `command` to the resource at `path`. `/playback…` is of the page's own session. */
export const askServer = (path: string) => async (command: object): Promise<Answer> => {
  const patience_ms = path === '/sessions' ? OF_FILES_MS : PATIENCE_MS;
  const address = path.slice(1) + (path.startsWith('/playback') ? ownQuery() : '');
  try {
    const reply = await fetch(address, {method: 'POST', body: JSON.stringify(command), cache: 'no-store', signal: AbortSignal.timeout(patience_ms)});
    return {status: reply.status, text: await reply.text(), published_ns: BigInt(reply.headers.get('State-Published') ?? 0)};
  } catch {
    return undefined;
  }
};
