// The whole played session at a glance: node session_overview_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {marksOf, readOverview, spansOf} = await bundled('playback/session_overview.ts');
const {EventLog} = await bundled('panel/qa/event_log.ts');

const KIND = {PHASE: 1, LINK: 2, FAULT: 3, DEADLINE: 4, SCENE: 5};
const event = (atS, kind, to = 0, text = '') => ({atS, kind: KIND[kind], text, from: 0, to});
const SESSION = readOverview({complete: true, events: [
  event(0.5, 'LINK', undefined, 'link connected'), event(1, 'PHASE', 8), event(2, 'PHASE', 3),
  event(2.5, 'SCENE'), event(3, 'DEADLINE', undefined, '2 ticks late'), event(7, 'PHASE', 9), event(7, 'FAULT'),
]});

test('phases follow one another to the session\'s end; nothing is claimed before the first', () => {
  assert.deepEqual(spansOf(SESSION, 10), [
    {phase: 8, from_s: 1, to_s: 2}, {phase: 3, from_s: 2, to_s: 7}, {phase: 9, from_s: 7, to_s: 10}]);
});

test('links, missed deadlines and faults are marked; scenes and phases are not', () => {
  assert.deepEqual(marksOf(SESSION).map(({at_s, kind}) => [at_s, kind]), [[0.5, 2], [3, 4], [7, 3]]);
});

test('the list of events is that of the whole session, the newest first, and what is played adds nothing', () => {
  const log = new EventLog();
  const heard = {stampNs: 5n, kind: 1, text: 'heard while it played', from: 0, to: 3};
  log.add([heard], {at_ns: 10n, position_s: 2, speed: 1});
  log.know(SESSION.events);
  log.add([{...heard, stampNs: 9n}], {at_ns: 10n, position_s: 3, speed: 1});
  assert.deepEqual(log.events.map(({position_s}) => position_s), [7, 7, 3, 2.5, 2, 1, 0.5]);
  log.forget();
  assert.deepEqual(log.events, []);
});

test('while the events of another session are read, those of the last one are forgotten', () => {
  const log = new EventLog();
  log.know(undefined);
  log.add([{stampNs: 5n, kind: 1, text: 'heard', from: 0, to: 3}], undefined);
  log.know(undefined);
  assert.equal(log.events.length, 1, 'without a session, what is heard stays');
  log.know(SESSION.events);
  log.know(undefined);
  assert.deepEqual(log.events, []);
});
