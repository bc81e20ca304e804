// Which picture and which numbers belong together: node presented_instant_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {presentableUntil, valuesAt, isSkipped, continuesWithoutPicture, handWithoutPicture, nearest} =
    await bundled('present/presented_instant.ts');

const ms = (value) => BigInt(value) * 1_000_000n;

test('a picture waits for the station\'s word of its instant', () => {
  assert.equal(presentableUntil(ms(1000), ms(1033)), ms(1005), 'half a period further than the newest word');
});

test('a station that is silent, far behind or not there is not waited for', () => {
  assert.equal(presentableUntil(undefined, ms(1033)), ms(1033));
  assert.equal(presentableUntil(ms(1000), ms(1501)), ms(1501));
});

test('numbers go on without a picture once none came for a quarter of a second', () => {
  assert.equal(continuesWithoutPicture(ms(1200), ms(1000), ms(0)), false);
  assert.equal(continuesWithoutPicture(ms(1251), ms(1000), ms(0)), true);
});

test('numbers wait a second for the first picture', () => {
  assert.equal(continuesWithoutPicture(ms(1900), undefined, ms(1000)), false);
  assert.equal(continuesWithoutPicture(ms(2001), undefined, ms(1000)), true);
});

/** A state of the station whose values are all multiples of its time. */
const state = (at_ms, more = {}) => ({
  stampNs: ms(at_ms), phase: 3, inBody: false, indentationM: at_ms / 1000, limited: false,
  displayedHandCamera: {x: at_ms, y: 2 * at_ms, z: -at_ms}, forceN: {x: 0, y: at_ms / 100, z: 0},
  torqueCameraNM: {x: 0, y: 0, z: at_ms / 1000},
  handAttitudeCamera: {x: 0, y: 0, z: 0, w: 1}, ...more,
});

test('values of a picture are those of the nearest state within half a period, unchanged', () => {
  const states = [state(990), state(1000), state(1010)];
  assert.equal(valuesAt(states, ms(1004)), states[1]);
  assert.equal(valuesAt(states, ms(1006)), states[2]);
  assert.equal(valuesAt(states, ms(1015)), states[2], 'half a period after the last');
  assert.equal(valuesAt(states, ms(985)), states[0], 'or before the first');
});

test('in a short gap, values are estimated at the very instant of the picture', () => {
  const found = valuesAt([state(1000, {limited: true}), state(1040)], ms(1010));
  assert.equal(found.stampNs, ms(1010));
  assert.deepEqual(found.displayedHandCamera, {x: 1010, y: 2020, z: -1010});
  assert.equal(found.forceN.y, 10.1);
  assert.ok(Math.abs(found.torqueCameraNM.z - 1.01) < 1e-12);
  assert.ok(Math.abs(found.indentationM - 1.01) < 1e-12);
  assert.equal(found.limited, true, 'a value that does not change gradually stays as before the gap');
  assert.equal(found.proxyCamera, undefined, 'nothing is made up');
});

test('an estimate errs by at most a T² / 8 for a hand with the acceleration a', () => {
  const at = (t_ms) => state(t_ms, {displayedHandCamera: {x: 0.05 * Math.sin(t_ms / 100), y: 0, z: 0}});  // 5 m/s²
  for (let t_ms = 1006; t_ms < 1045; ++t_ms) {
    const {displayedHandCamera: {x}} = valuesAt([at(1000), at(1050)], ms(t_ms));
    assert.ok(Math.abs(x - 0.05 * Math.sin(t_ms / 100)) <= 5 * 0.05 ** 2 / 8 + 1e-9);
  }
});

test('an attitude turns along the shorter way and stays a rotation', () => {
  const turned = {x: 0, y: 0, z: -Math.sin(0.1), w: -Math.cos(0.1)};  // 0.2 rad, with the opposite sign
  const {x, y, z, w} = valuesAt([state(1000), state(1040, {handAttitudeCamera: turned})], ms(1020)).handAttitudeCamera;
  assert.ok(Math.abs(Math.hypot(x, y, z, w) - 1) < 1e-12);
  assert.ok(Math.abs(2 * Math.atan2(z, w) - 0.1) < 1e-6, 'half of the turn');
});

test('values are not known in a long gap, beyond the states, and where a contact begins or ends in the gap', () => {
  assert.equal(valuesAt([state(1000), state(1051)], ms(1020)), undefined, 'longer than 50 ms');
  assert.equal(valuesAt([state(1000)], ms(1006)), undefined, 'after the newest');
  assert.equal(valuesAt([state(1000)], ms(994)), undefined, 'before the oldest');
  assert.equal(valuesAt([], ms(1000)), undefined);
  assert.equal(valuesAt([state(1000), state(1040, {inBody: true})], ms(1020)), undefined);
  assert.equal(valuesAt([state(1000), state(1040, {phase: 2})], ms(1020)), undefined);
});

test('whatever states are lost, a picture never gets values that are more than half a period away', () => {
  let seed = 12345;
  const random = () => (seed = (1103515245 * seed + 12345) % 2 ** 31) / 2 ** 31;
  for (let run = 0; run < 200; ++run) {
    const states = [];
    for (let at = 0; at < 2000; at += 10) if (random() < 0.4) states.push(state(at + 1 + 3 * random() | 0));
    for (let at = 0; at < 2000; at += 33) {
      const found = valuesAt(states, ms(at));
      if (found === undefined) continue;
      const off_ns = found.stampNs - ms(at);
      assert.ok(off_ns <= 5_000_000n && off_ns >= -5_000_000n, `run ${run}, ${at} ms: ${off_ns} ns`);
    }
  }
});

test('a picture without known values is skipped for 100 ms at most, and only while later values have come', () => {
  assert.equal(isSkipped(ms(1000), ms(1031), ms(950)), true);
  assert.equal(isSkipped(ms(1000), ms(990), ms(950)), false, 'no later values: not a gap, but a silent station');
  assert.equal(isSkipped(ms(1000), ms(1031), ms(900)), false, 'no picture for 100 ms');
  assert.equal(isSkipped(ms(1000), ms(1031), undefined), false, 'the first picture');
});

test('without new pictures, the hand stays while pictures still come; without any picture, the hand follows the values', () => {
  assert.equal(handWithoutPicture(ms(1300), ms(1000)), 'kept');
  assert.equal(handWithoutPicture(ms(2001), ms(1000)), 'none', 'none has come for a second');
  assert.equal(handWithoutPicture(ms(2001), undefined), 'new');
});

test('the nearest item is found on either side', () => {
  const at = (items, time) => nearest(items.map(ms), (item) => item, ms(time));
  assert.equal(at([10, 20, 30], 24), ms(20));
  assert.equal(at([10, 20, 30], 26), ms(30));
  assert.equal(at([], 26), undefined);
});
