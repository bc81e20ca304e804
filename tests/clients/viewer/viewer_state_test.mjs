// What the page knows of the picture that it draws: node viewer_state_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {ViewerState} = await bundled('state/viewer_state.ts');
const {forcesOf} = await bundled('present/instant.ts');
const {ringRadius_m} = await bundled('scene/torque_ring.ts');
const {BALL_RADIUS_M} = await bundled('scene/drawn_sizes.ts');

const CAPTURED_MS = 1000;
const instantAt = (captured_ms) => ({
  picture: {captured_ns: BigInt(captured_ms) * 1_000_000n, published_ns: BigInt(captured_ms + 5) * 1_000_000n, summary: {}},
  station: undefined, hand: 'none', late_ms: undefined, trail: [],
  times: {captured_ms, published_ms: captured_ms + 5, complete_ms: captured_ms + 10},
});

test('the picture that waits while another is drawn still counts as arrived', () => {
  const state = new ViewerState();
  state.news = {connected: true, offset_ms: 0, heard: {published_ms: 2000, received_ms: 2000}};
  const [first, second] = [instantAt(CAPTURED_MS), instantAt(CAPTURED_MS + 33)];
  state.taken(first);
  state.taken(second);  // decoded while the first is drawn
  state.shown(first, 1040);
  state.drawn(first, 1050);
  const {account, pictureInstant_ms} = state.read(1250);
  assert.equal(pictureInstant_ms, CAPTURED_MS);
  assert.equal(account.computer, 1050 - 1010 + 1250 - 1050, 'since the second arrived, this computer is the slow one');
  state.shown(second, 1255);
  state.drawn(second, 1260);
  assert.equal(state.read(1260).pictureInstant_ms, CAPTURED_MS + 33);
});

const stationAt = (stamp_ms) => ({stampNs: BigInt(stamp_ms) * 1_000_000n, handSampledNs: 0n, surfaceCapturedNs: 0n, phase: 3, indentationM: 0});
const heard = {connected: true, stationHeard_ms: 1000, at_ms: 1500};

test('picture, hand and numbers change together, when the instant comes to the screen', () => {
  const state = new ViewerState();
  state.news = heard;
  const instants = (now) => [now.pictureInstant_ms, now.handInstant_ms, now.numbersInstant_ms];
  const next = {...instantAt(1000), station: stationAt(1002), hand: 'new'};
  state.taken(next);
  assert.deepEqual(instants(state.read(1010)), [undefined, undefined, undefined]);
  state.shown(next, 1020);
  assert.deepEqual(instants(state.read(1020)), [1000, 1002, 1002]);
  assert.equal(state.frames, 0, 'not counted before it is on the screen');
  state.drawn(next, 1036);
  assert.equal(state.frames, 1);
  state.shown({...instantAt(1300), picture: undefined, station: stationAt(1300), hand: 'kept'}, 1310);
  assert.deepEqual(instants(state.read(1310)), [1000, 1002, 1300], 'the hand stays with its picture');
  state.news = {...heard, stationHeard_ms: 2105, at_ms: 2110};
  state.shown({...instantAt(2100), picture: undefined, station: stationAt(2100), hand: 'none'}, 2110);
  assert.deepEqual(instants(state.read(2110)), [1000, undefined, 2100]);
});

test('a torque is known only of a device that gives one', () => {
  const state = new ViewerState();
  state.news = heard;
  state.shown({...instantAt(1000), station: stationAt(1002), hand: 'new'}, 1020);
  assert.equal(state.read(1020).torque_N_m, undefined);
  state.shown({...instantAt(1033), station: {...stationAt(1035), torqueCameraNM: {x: 0.3, y: 0, z: -0.4}}, hand: 'new'}, 1050);
  assert.equal(state.read(1050).torque_N_m, 0.5);
});

test('the ring of a torque lies around the ball, and grows with the torque', () => {
  assert.equal(ringRadius_m(0), 0);
  assert.equal(ringRadius_m(0.004), 0, 'nobody feels it');
  assert.ok(ringRadius_m(0.01) > 1.1 * BALL_RADIUS_M);
  assert.ok(ringRadius_m(0.5) > ringRadius_m(0.1) + 0.02);
});

test('values that are not known are shown as not known, and not as a station that is away', () => {
  const state = new ViewerState();
  state.news = heard;
  state.shown({...instantAt(1000), late_ms: 600}, 1020);
  const {force_N, indentation_mm, phase, late_ms} = state.read(1500);
  assert.deepEqual([force_N, indentation_mm, phase, late_ms], [undefined, undefined, undefined, 600]);
  state.news = {...heard, at_ms: 2500};
  assert.equal(state.read(2500).phase, 0, 'a station that is silent for more than a second is away');
});

test('the way of a frame to the hand is not shown of a station that is silent', () => {
  const state = new ViewerState();
  state.news = {...heard, surfaceReport: {touchableNs: 1n}};
  assert.deepEqual(state.read(1500).surfaceReport, {touchableNs: 1n});
  state.news = {...state.news, at_ms: 2500};
  assert.equal(state.read(2500).surfaceReport, undefined);
  state.news = {...state.news, at_ms: 1500, connected: false};
  assert.equal(state.read(1500).surfaceReport, undefined);
});

test('the force is contact\'s in the phases of the table that the programs share, and the drive\'s in all others', () => {
  const table = readFileSync(new URL('../../proto/golden/contact_phases.tsv', import.meta.url), 'utf8');
  const rows = table.trim().split('\n').slice(1).map((row) => row.split('\t'));
  assert.equal(rows.length, 10);
  const forceN = {x: 0, y: 3, z: 4};
  for (const [phase, force] of rows)
    assert.deepEqual(
        forcesOf({phase: Number(phase), forceN}), force === 'contact' ? {force_N: 5, drive_N: 0} : {force_N: 0, drive_N: 5}, `phase ${phase}`);
  assert.deepEqual(forcesOf({phase: 1, indexing: true, forceN}), {force_N: 0, drive_N: 5});
});

test('a device that is driven in free air shows no force of contact', () => {
  const state = new ViewerState();
  state.news = heard;
  state.shown({...instantAt(1000), station: {...stationAt(1002), forceN: {x: 2, y: 0, z: 0}}, hand: 'new'}, 1020);
  const {force_N, drive_N} = state.read(1020);
  assert.deepEqual([force_N, drive_N], [0, 2]);
});

const LIVE = {state: 1, source: 'synthetic'};
const PAUSED = {state: 2, source: 'session:a.mcap'};

/** A page that shows a picture and numbers of 1000 ms, drawn at 1020 ms. The last message came at 1010 ms. */
function page(news = {}) {
  const state = new ViewerState();
  state.news = {connected: true, everConnected: true, offset_ms: 0, stationHeard_ms: 1010, heardAny_ms: 1010, at_ms: 1020, capture: LIVE,
                heard: {published_ms: 1000, received_ms: 1010}, silentSince_ms: undefined, ...news};
  const shown = {...instantAt(1000), station: {...stationAt(1002), phase: 1, forceN: {x: 0, y: 2, z: 0}, indentationM: 0.01}, hand: 'new'};
  state.taken(shown);
  state.shown(shown, 1020);
  state.drawn(shown, 1020);
  return state;
}

test('a silence that the path does not explain makes the picture stale, marks the numbers, and ends them within 1 s', () => {
  const state = page();
  assert.equal(state.read(1200).stale, false);
  assert.equal(state.newsCame({...state.news, silentSince_ms: 1010, at_ms: 1290}), true);
  assert.equal(state.newsCame({...state.news, at_ms: 1299}), false);
  const marked = state.read(1300);
  assert.deepEqual([marked.stale, marked.numbersOld, marked.force_N], [true, true, 2]);
  assert.equal(marked.silence_ms, 290);
  assert.equal(state.newsCame({...state.news, at_ms: 1900}), true, 'the page shows it at once');
  const gone = state.read(1910);
  assert.deepEqual([gone.stale, gone.force_N, gone.indentation_mm, gone.numbersInstant_ms], [true, undefined, undefined, undefined]);
});

test('while only the images stop, the numbers are those of now', () => {
  const state = page({silentSince_ms: 1010, stationHeard_ms: 1990});
  const {stale, numbersOld, force_N} = state.read(2000);
  assert.deepEqual([stale, numbersOld, force_N], [true, false, 2]);
});

test('a paused session is neither stale nor without numbers, whoever paused it', () => {
  const state = page({capture: PAUSED, silentSince_ms: 1010});
  const {stale, paused, force_N} = state.read(60_000);
  assert.deepEqual([stale, paused, force_N], [false, true, 2]);
  state.news = {...state.news, capture: LIVE};
  assert.equal(state.read(60_000).stale, true);
});

test('the last picture of a recording that has ended stays as it is', () => {
  assert.equal(page({capture: {state: 4, source: 'a.oni'}}).read(60_000).stale, false);
});

test('a picture is stale that is a second older than its path always needs, however regular its images are', () => {
  assert.equal(page().read(2100).stale, true);
  const far = page({leastAge_ms: 330, silenceLimit_ms: 270});
  assert.deepEqual([far.read(2300).stale, far.read(2400).stale], [false, true]);
  const lossy = page({leastAge_ms: 330, silenceLimit_ms: 850});
  assert.deepEqual([lossy.read(2550).stale, lossy.read(2650).stale], [false, true]);
});

test('a swing is told as wide as it was, and as quick as it is: the first rate comes from half a window', () => {
  const state = new ViewerState();
  state.pointerRests = true;
  state.shown({...instantAt(1000), station: stationAt(1002), hand: 'new'}, 1020);
  const toldOf = (width_m, hertz, at_ms) => {
    state.news = {...heard, motion: {swing: {width_m, hertz, hand_m: 0}, driveIsFull: false}};
    return state.read(at_ms).unsteady;
  };
  assert.deepEqual(toldOf(0.006, 2.5, 1000), {swing_mm: 6, hertz: 2.5});
  assert.deepEqual(toldOf(0.0059, 4.2, 1100), {swing_mm: 6, hertz: 4.2});
  state.news = {...heard, motion: {swing: undefined, driveIsFull: true}};
  assert.deepEqual(state.read(1200).unsteady, {swing_mm: 6, hertz: 4.2}, 'the swing brings the drive to its limit');
  state.news = {...heard, motion: {swing: undefined, driveIsFull: false}};
  assert.equal(state.read(4000).unsteady, undefined);
});
