import {ownQuery} from '../link/own_session';
import type {FromWorker} from './worker_messages';

/** The link worker, with the messages that came before the page could take them. */
export interface EarlyWorker {
  worker: Worker;
  early: FromWorker[];
}

/** Starts the link worker, which answers with its news and the first instant. The page's scripts share the worker. */
export function linkWorker(): EarlyWorker {
  const kept = globalThis as {telepalpLink?: EarlyWorker};
  return (kept.telepalpLink ??= begin());
}

function begin(): EarlyWorker {
  const worker = new Worker('link_worker.js', {type: 'module', name: ownQuery()});
  const early: FromWorker[] = [];
  worker.onmessage = ({data}: MessageEvent<FromWorker>) => early.push(data);
  return {worker, early};
}
