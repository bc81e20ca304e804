// Starts the link worker, and then the page's large script. The browser cannot start a worker, or give it a message, while
// the page's thread runs a script: the large script would delay the first picture, which the worker decodes meanwhile.
import {linkWorker} from './site/early_worker';

const happens = (at: EventTarget, type: string) => new Promise((done) => at.addEventListener(type, done, {once: true}));

const {worker} = linkWorker();
await Promise.all([
  Promise.race([happens(worker, 'message'), happens(worker, 'error')]),
  document.readyState === 'complete' || happens(window, 'load'),  // the page's elements and styles are there
]);
document.head.append(Object.assign(document.createElement('script'), {type: 'module', src: 'viewer.js'}));
