import type {FromWorker, ToWorker} from './worker_messages';

/** The link worker, with the messages that came before the page could take them. */
export interface EarlyWorker {
  worker: Worker;
  early: FromWorker[];
}

/** Starts the link worker, and asks it for the first instant. The page's scripts share the one that is kept here. */
export function linkWorker(): EarlyWorker {
  const kept = globalThis as {telepalpLink?: EarlyWorker};
  return (kept.telepalpLink ??= begin());
}

function begin(): EarlyWorker {
  const worker = new Worker('link_worker.js', {type: 'module'});
  const early: FromWorker[] = [];
  worker.onmessage = ({data}: MessageEvent<FromWorker>) => early.push(data);
  worker.postMessage({ask: 'instant'} satisfies ToWorker);
  return {worker, early};
}
