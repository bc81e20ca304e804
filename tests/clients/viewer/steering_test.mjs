// A hand that is steered by keys or a gamepad: node steering_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {intentOfGamepad, intentOfKeys, isAtRest, rumbleOf, steered} = await bundled('touch/steering.ts');

const BOX = {left: 100, top: 50, width: 900, height: 600};
const pad = (x, y, trigger = 0) => intentOfGamepad(
    {axes: [x, y], buttons: Array.from({length: 8}, (_, at) => ({value: at === 7 ? trigger : 0}))});

test('a stick that rests a little off its middle moves nothing; a full one moves across the picture in 3 s', () => {
  assert.ok(isAtRest(pad(0.12, -0.1)));
  assert.deepEqual(pad(1, -1), {right: 1, down: -1, press: 0});
  let at;
  for (let step = 0; step < 100; ++step) at = steered(at, pad(0, 1), {...BOX, height: 6000, width: 600}, 0.01);
  assert.ok(Math.abs(at.y - (50 + 3000 + 200)) < 1, `${at.y}`);
});

test('the hand begins in the middle of the picture and never leaves it', () => {
  assert.deepEqual(steered(undefined, pad(0, 0, 0.4), BOX, 0.01), {x: 550, y: 350, press: 0.4});
  const far = steered({x: 950, y: 640, press: 0}, {right: 1, down: 1, press: 0}, BOX, 60);
  assert.deepEqual([far.x, far.y], [999, 649]);
});

test('arrows move, Enter presses, opposite arrows cancel', () => {
  assert.deepEqual(intentOfKeys(new Set(['ArrowUp', 'Enter'])), {right: 0, down: -1, press: 1});
  assert.ok(isAtRest(intentOfKeys(new Set(['ArrowLeft', 'ArrowRight']))));
});

test('a gamepad without triggers or axes is at rest, not NaN', () => {
  assert.deepEqual(intentOfGamepad({axes: [], buttons: []}), {right: 0, down: 0, press: 0});
});

test('rumble grows with the force to the device\'s peak, and no force does not shake', () => {
  assert.deepEqual([undefined, 0, 0.1, 5, 10, 50].map((force_N) => rumbleOf(force_N, 10)), [0, 0, 0, 0.5, 1, 1]);
});
