// node calibration_test.mjs VIEWER_SOURCES VIEWER_WORK: the touches of a calibration, their fit and their file.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {fitOffset, pairsFile, MOST_MOVED_M} = await bundled('calibration/offset_fit.ts');
const {TouchTaker, TOUCHES_OF_A_PLACE} = await bundled('calibration/touch_taker.ts');
const {verdict} = await bundled('panel/technician/calibration_rows.ts');
const {Phase} = await bundled('messages/generated.ts');

const T = {x: 0.03, y: 0.31, z: -0.02};
const point = (x, y, z) => ({x, y, z});
/** The hand in the tracker's frame, for an end-effector at `haptic` and a tracker that is turned by `turn_rad` about y. */
function seen(haptic, turn_rad = 0) {
  const [x, y, z] = [haptic.x - T.x, T.y - haptic.y, T.z - haptic.z];
  const [cos, sin] = [Math.cos(turn_rad), Math.sin(turn_rad)];
  return point(cos * x + sin * z, y, cos * z - sin * x);
}
const rest = (place, haptic, turn_rad) =>
  Array.from({length: 10}, () => ({place, haptic, tracker: seen(haptic, turn_rad)}));
const threePlaces = (turn_rad) =>
  [point(0, 0.05, 0), point(0.1, 0.05, 0), point(0, 0.08, 0.1)].flatMap((at, index) => rest(index + 1, at, turn_rad));

test('the offset of S1 eq. (2) is found from touches', () => {
  const fit = fitOffset(threePlaces());
  for (const axis of ['x', 'y', 'z']) assert.ok(Math.abs(fit.translation[axis] - T[axis]) < 1e-12, axis);
  assert.ok(fit.largest_m < 1e-12);
  assert.equal(verdict(fit), 'Good: the places agree.');
});

test('too few touches give no fit', () => assert.equal(fitOffset(threePlaces().slice(0, 9)), undefined));

test('a tracker that is turned otherwise than eq. (4) is found by more than one place, and not by one', () => {
  assert.match(verdict(fitOffset(threePlaces(0.2))), /^The places disagree/);
  assert.match(verdict(fitOffset(rest(1, point(0, 0.05, 0), 0.2))), /^Good so far\. Measure three places/);
});

test('a hand that moved at one place is named', () => {
  const touches = threePlaces();
  touches[12].tracker.x += 2 * MOST_MOVED_M;
  assert.match(verdict(fitOffset(touches)), /^The hand moved at place 2/);
});

test('the file has the header and the columns of point pairs', () => {
  assert.equal(pairsFile([{place: 2, haptic: point(0.1, -0.2, 0.3), tracker: point(1, 2, 3)}]),
      'place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m\n2,0.100000,-0.200000,0.300000,1.000000,2.000000,3.000000\n');
});

/** A station that places hands by a rotation of 120 degrees about (1, 1, 1) (x to y, y to z, z to x) and a translation. */
const MOTION = {rotation: {x: 0.5, y: 0.5, z: 0.5, w: 0.5}, translationM: point(0.1, 0.2, 0.3)};
const state = (sample, more = {}) => ({
  phase: Phase.RELEASED, forceN: point(0, 0, 0), handSampledNs: BigInt(sample), device: point(0, 0.05, 0),
  hand: point(0.1 + 3, 0.2 + 1, 0.3 + 2), ...more,
});
function taken(states, motion = MOTION) {
  let done;
  const taker = new TouchTaker((touches) => (done = touches));
  taker.inUse = motion ?? undefined;
  taker.take(4);
  for (const one of states) taker.stateCame(one);
  return {done, taking: taker.taking};
}
const samples = (count, more) => Array.from({length: count}, (_, index) => state(index + 1, more));

test('a place is done after its number of new samples of the hand, in the frames of tracker and device', () => {
  const {done} = taken(samples(TOUCHES_OF_A_PLACE, {workspaceShift: point(0.5, 0, 0), hand: point(3.6, 1.2, 2.3)}));
  assert.equal(done.length, TOUCHES_OF_A_PLACE);
  const [{place, tracker, haptic}] = done;
  assert.equal(place, 4);
  [[tracker.x, 1], [tracker.y, 2], [tracker.z, 3], [haptic.x, -0.5], [haptic.y, 0.05]].forEach(([is, wanted]) =>
    assert.ok(Math.abs(is - wanted) < 1e-12, `${is} is not ${wanted}`));
});

test('repeated states of one sample count once', () => {
  const {done, taking} = taken([...samples(3), ...samples(3).slice(2)]);
  assert.equal(done, undefined);
  assert.equal(taking.taken, 3);
});

test('nothing is taken in a fault, while the device pushes, without a hand, or without the calibration in use', () => {
  for (const [more, says] of [[{phase: Phase.FAULTED}, /rearm/], [{forceN: point(0, 1.2, 0)}, /1\.2 N/], [{handSampledNs: 0n}, /no hand/],
    [{forceN: point(0, Number.NaN, 0)}, /pushes/]]) {
    const {taking} = taken(samples(TOUCHES_OF_A_PLACE, more));
    assert.equal(taking.taken, 0);
    assert.match(taking.problem, says);
  }
  const uncalibrated = taken(samples(TOUCHES_OF_A_PLACE), null);
  assert.deepEqual([uncalibrated.done, uncalibrated.taking.taken], [undefined, 0]);
});
