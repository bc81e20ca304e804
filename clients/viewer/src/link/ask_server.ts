import {ownQuery} from './own_session';

/** The server's answer; undefined: it did not answer. */
export type Answer = {status: number; text: string} | undefined;

const PATIENCE_MS = 3000;

/** Sends the page's server a GET for the state at `path`, or a POST of `command`. `playback…` is of the page's own session. */
export const askServer = (path: string) => async (command?: object): Promise<Answer> => {
  const options = command === undefined ? {} : {method: 'POST', body: JSON.stringify(command)};
  try {
    const reply = await fetch(path.startsWith('playback') ? path + ownQuery() : path, {...options, cache: 'no-store', signal: AbortSignal.timeout(PATIENCE_MS)});
    return {status: reply.status, text: await reply.text()};
  } catch {
    return undefined;
  }
};
