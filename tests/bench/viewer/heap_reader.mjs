// The script memory of a page and of its workers, after a forced garbage collection.
import {sleep} from '../../end_to_end/running_program.mjs';

const PATIENCE_MS = 600_000;  // a machine may run something else for minutes

/** Opens the debugger's channel to `page`; the result reads {page_MB, workers_MB} each time it is called. */
export async function heapReader(page) {
  const session = await page.context().newCDPSession(page);
  const workers = new Set();
  const answers = new Map();
  let asked = 0;
  session.on('Target.attachedToTarget', ({sessionId, targetInfo}) => targetInfo.type === 'worker' && workers.add(sessionId));
  session.on('Target.detachedFromTarget', ({sessionId}) => workers.delete(sessionId));
  session.on('Target.receivedMessageFromTarget', ({message}) => {
    const {id, result} = JSON.parse(message);
    answers.get(id)?.(result);
    answers.delete(id);
  });
  const answer = (sessionId, method) => new Promise((answered) => {
    answers.set(++asked, answered);
    void session.send('Target.sendMessageToTarget', {sessionId, message: JSON.stringify({id: asked, method})});
  });
  const ask = (sessionId, method) => Promise.race([answer(sessionId, method), sleep(PATIENCE_MS).then(() => {
    throw new Error(`a worker did not answer ${method} within ${PATIENCE_MS / 1000} s`);
  })]);
  await session.send('Target.setAutoAttach', {autoAttach: true, waitForDebuggerOnStart: false, flatten: false});

  return async () => {
    await session.send('HeapProfiler.collectGarbage');
    const {usedSize} = await session.send('Runtime.getHeapUsage');
    let workers_B = 0;
    for (const worker of workers) {
      await ask(worker, 'HeapProfiler.collectGarbage');
      workers_B += (await ask(worker, 'Runtime.getHeapUsage')).usedSize;
    }
    return {page_MB: usedSize / 1e6, workers_MB: workers_B / 1e6};
  };
}
