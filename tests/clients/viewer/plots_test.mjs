// node plots_test.mjs VIEWER_SOURCES VIEWER_WORK: what the plots show, and what is looked up for an instant.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {TouchHistory} = await bundled('panel/plots/touch_history.ts');
const {PlotWindow} = await bundled('panel/plots/window.ts');
const {sinceNow, timeMarks} = await bundled('panel/plots/time_axis.ts');
const {StationPast} = await bundled('present/station_past.ts');

const IN_BODY = 1, OUT_BODY = 3;
const touch = (at_s, force_N = 1, phase = IN_BODY, drive_N = 0) => ({at_s, force_N, drive_N, indentation_m: 0.02, phase});

test('missing messages are a gap in the curve, and end a phase', () => {
  const history = new TouchHistory();
  for (const at_s of [0, 0.1, 0.2, 1.2, 1.3]) history.add(touch(at_s));
  const {at_s, force_N} = history.columns(0, 2);
  assert.deepEqual(force_N, [1, 1, 1, null, 1, 1]);
  assert.deepEqual(at_s, [...at_s].sort((a, b) => a - b));
  assert.deepEqual(history.phases(0, 2).map(({from_s, to_s}) => [from_s, to_s]), [[0, 0.2], [1.2, 1.3]]);
});

test('the drive has a curve of its own, which ends where a contact begins', () => {
  const history = new TouchHistory();
  history.add(touch(0, 0, OUT_BODY, 2.5));
  history.add(touch(0.1, 1.5, IN_BODY, 0));
  const {force_N, drive_N} = history.columns(0, 1);
  assert.deepEqual([force_N, drive_N], [[0, 1.5], [2.5, null]]);
});

test('phases follow each other without a hole', () => {
  const history = new TouchHistory();
  for (const [at_s, phase] of [[0, OUT_BODY], [0.1, OUT_BODY], [0.2, IN_BODY], [0.3, IN_BODY]]) history.add(touch(at_s, 1, phase));
  assert.deepEqual(history.phases(0, 1), [{phase: OUT_BODY, from_s: 0, to_s: 0.2}, {phase: IN_BODY, from_s: 0.2, to_s: 0.3}]);
});

test('a restarted station begins a new history, and an old one is bounded', () => {
  const history = new TouchHistory();
  for (let tick = 0; tick < 20_000; ++tick) history.add(touch(tick / 100));
  assert.ok(history.end_s - history.begin_s < 70, `${history.end_s - history.begin_s} s`);
  history.add(touch(3));
  assert.deepEqual([history.begin_s, history.end_s], [3, 3]);
});

test('the value under the pointer is that of a message nearby, or none', () => {
  const history = new TouchHistory();
  for (const at_s of [0, 0.1, 2]) history.add(touch(at_s, at_s));
  assert.equal(history.at(0.09).force_N, 0.1);
  assert.equal(history.at(1), undefined);
});

test('the window follows, until it is zoomed or moved; then it stands still', () => {
  const window = new PlotWindow();
  assert.deepEqual(window.range(0, 100), {from_s: 85, to_s: 100});
  window.hold({from_s: 90, to_s: 92});
  assert.deepEqual(window.range(0, 130), {from_s: 90, to_s: 92});
  assert.equal(window.isLive, false);
  window.zoom(0.5);
  assert.deepEqual(window.range(0, 130), {from_s: 90.5, to_s: 91.5});
  window.live();
  assert.equal(window.range(0, 130).to_s, 130);
});

test('a held window that the history has left is live again, and a click is no zoom', () => {
  const window = new PlotWindow();
  window.hold({from_s: 10, to_s: 10.1});
  assert.equal(window.isLive, true);
  window.hold({from_s: 10, to_s: 12});
  assert.deepEqual(window.range(13, 60), {from_s: 45, to_s: 60});
});

test('moving stops at the ends of the history', () => {
  const window = new PlotWindow();
  window.move(-0.25, 0, 40);
  assert.deepEqual(window.range(0, 40), {from_s: 21.25, to_s: 36.25});
  for (let step = 0; step < 20; ++step) window.move(-0.25, 0, 40);
  assert.deepEqual(window.range(0, 40), {from_s: 0, to_s: 15});
  for (let step = 0; step < 20; ++step) window.move(0.25, 0, 40);
  assert.deepEqual(window.range(0, 40), {from_s: 25, to_s: 40});
});

test('phase and compensation are those of the presented instant', () => {
  const past = new StationPast();
  past.stateCame({stampNs: 1_000_000_000n, phase: OUT_BODY});
  past.stateCame({stampNs: 1_500_000_000n, phase: IN_BODY});
  assert.deepEqual([0.9, 1.2, 1.5, 9].map((at_s) => past.phaseAt(at_s)), [undefined, OUT_BODY, IN_BODY, IN_BODY]);
  for (const stampNs of [1_000_000_000n, 1_010_000_000n, 1_020_000_000n]) past.compensationCame({stampNs});
  assert.equal(past.compensationAt(1_012_000_000n).stampNs, 1_010_000_000n);
  assert.equal(past.compensationAt(1_100_000_000n), undefined, 'that of another instant is not shown');
});

test('the axis of time has round distances from the newest value', () => {
  const marks = (from_s, to_s, end_s) => timeMarks(from_s, to_s, end_s).map((at_s) => sinceNow(at_s, end_s));
  assert.deepEqual(marks(100.3, 115.3, 115.3), ['−15 s', '−10 s', '−5 s', '0 s']);
  assert.deepEqual(marks(90.5, 91.5, 100), ['−9.5 s', '−9 s', '−8.5 s']);
  assert.deepEqual(marks(40, 100, 100), ['−60 s', '−40 s', '−20 s', '0 s']);
});
