// node qa_test.mjs VIEWER_SOURCES VIEWER_WORK: the moment in an address, and the events of a session.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {addressOfMoment} = await bundled('playback/moment.ts');
const {momentInAddress, ownSessionIn, queryOf} = await bundled('link/own_session.ts');
const {bring, PART_BYTES, readSessions, recordedSays} = await bundled('playback/recorded_sessions.ts');
const {snapshotLines} = await bundled('panel/qa/snapshot_words.ts');
const {EventLog} = await bundled('panel/qa/event_log.ts');
const {toneOf} = await bundled('words/event_tone.ts');

const PHASE = 1, FAULT = 3, DEADLINE = 4;
const second = (s) => BigInt(Math.round(1000 * s)) * 1_000_000n;
const event = (at_s, text, kind = DEADLINE) => ({stampNs: second(at_s), kind, text, from: 0, to: 0});

test('a shared address shows QA the same moment', () => {
  const address = new URL(addressOfMoment('https://site.example:8765/?view=doctor#x', 12.345));
  assert.equal(address.origin, 'https://site.example:8765');
  assert.equal(address.hash, '');
  assert.equal(address.searchParams.get('view'), 'qa');
  assert.equal(momentInAddress(address.search), 12.35);
});

test('what is no moment is none', () => {
  for (const search of ['', '?at_s=', '?at_s=-3', '?at_s=1e9', '?at_s=NaN', '?at_s=3;4'])
    assert.equal(momentInAddress(search), undefined, search);
});

test('an address opens a session for its page alone, and a shared moment keeps the session', () => {
  assert.equal(ownSessionIn('?view=qa'), undefined);
  assert.equal(queryOf(undefined, 'id'), '');
  const own = ownSessionIn('?view=qa&session=a_1.mcap&at_s=2.5');
  assert.deepEqual(own, {session: 'a_1.mcap', at_s: 2.5});
  assert.equal(queryOf(own, 'id'), '?reading=id&session=a_1.mcap&at_s=2.5');
  assert.equal(queryOf(ownSessionIn('?at_s=3'), 'id'), '?reading=id&at_s=3');
  for (const wrong of ['?session=', '?session=../x', '?session=a b']) assert.equal(ownSessionIn(wrong), undefined, wrong);
  assert.equal(new URL(addressOfMoment('https://site.example/?session=a_1.mcap', 5)).searchParams.get('session'), 'a_1.mcap');
});

test('a recording is listed with its time and size; a server without recordings lists none', () => {
  const [one] = readSessions({sessions: [{name: 'a.mcap', bytes: 12_500_000n, writtenS: 1_772_366_400n}]});
  assert.equal(one.name, 'a.mcap');
  assert.equal(recordedSays(one), '2026-03-01 12:00 UTC, 12.5 MB');
});

test('a file is brought in parts, the last one complete, until one is refused', async () => {
  const file = new File([new Uint8Array(PART_BYTES + 3).fill(7)], 'a.mcap');
  const parts = [], shares = [];
  assert.equal(await bring(file, async (part) => (parts.push(part), ''), (share) => shares.push(share)), '');
  assert.deepEqual(parts.map(({name, from, complete}) => [name, from, complete]), [['a.mcap', 0, false], ['a.mcap', PART_BYTES, true]]);
  assert.equal(Buffer.from(parts[1].data, 'base64').toString('hex'), '070707');
  assert.equal(shares.at(-1), 1);
  assert.equal(await bring(file, async () => 'no', () => assert.fail('nothing was taken')), 'no');
});

test('an event is placed by the speed at which the session plays', () => {
  const log = new EventLog();
  log.add([event(100, 'contact')], {at_ns: second(103), position_s: 20, speed: 2});
  assert.equal(log.events[0].position_s, 14);
});

test('the same events, heard again or played again, are listed once', () => {
  const log = new EventLog();
  const heard = [event(100, 'contact'), event(101, 'release')];
  log.add(heard, {at_ns: second(102), position_s: 10, speed: 1});
  log.add(heard, {at_ns: second(102.1), position_s: 10.1, speed: 1});
  log.add([event(200, 'contact')], {at_ns: second(202), position_s: 10.2, speed: 1});
  assert.deepEqual(log.events.map(({text}) => text), ['release', 'contact'], 'the newest first');
  log.add([event(300, 'contact')], {at_ns: second(302), position_s: 30, speed: 1});
  assert.equal(log.events.length, 3, 'a second contact, elsewhere, is another one');
});

test('events of a live patient have no place, and all are kept', () => {
  const log = new EventLog();
  log.add([event(1, 'contact'), event(2, 'contact')], undefined);
  assert.deepEqual(log.events.map(({position_s}) => position_s), [undefined, undefined]);
});

test('after a new connection events of an earlier clock count again, and the list is bounded', () => {
  const log = new EventLog();
  for (let at = 1; at <= 700; ++at) log.add([event(at, `event ${at}`)], undefined);
  assert.equal(log.events.length, 500);
  log.forget();
  log.add([event(3, 'contact')], undefined);
  assert.equal(log.events.length, 1);
});

test('faults matter most, then what went wrong, then phases', () => {
  assert.deepEqual([FAULT, DEADLINE, PHASE].map(toneOf), ['alarm', 'warn', 'plain']);
});

const SNAPSHOT = {
  forces: {force_N: 1.24, drive_N: 0}, indentation_m: 0.0091, phase: 1, exposed_ms: Date.UTC(2026, 2, 1, 12, 0, 0, 250),
  source: 'session:/data/2026/anna.mcap', moment_s: 75.254, stale: false,
};

test('a snapshot says force, time and session of its picture', () => {
  const [values, where, what] = snapshotLines(SNAPSHOT);
  assert.match(values, /^Force 1\.2 N, indentation 9 mm, ./);
  assert.equal(where, '2026-03-01 12:00:00.250 UTC, session anna.mcap at 1:15.25');
  assert.equal(what, 'telepalp is not a medical device');
});

test('a snapshot of a live or silent site says so', () => {
  const [values, where, what] = snapshotLines(
      {...SNAPSHOT, forces: {force_N: 0, drive_N: 2.5}, source: 'synthetic', moment_s: undefined, stale: true});
  assert.match(values, /^Force 0\.0 N, drive 2\.5 N, /);
  assert.equal(where, '2026-03-01 12:00:00.250 UTC, synthetic');
  assert.equal(what, 'Stale picture. telepalp is not a medical device');
  assert.equal(snapshotLines({...SNAPSHOT, forces: undefined})[0], 'Force and indentation are not known');
});
