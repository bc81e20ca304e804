// Two runs on one time axis, as the server sends them and as the page shows them: node comparison_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {readComparison} = await bundled('playback/comparison_state.ts');
const {comparisonSays, momentSays} = await bundled('panel/qa/comparison/comparison_words.ts');

const PHASES = {'.': 0, i: 1, o: 3};
/** A run with a letter for the phase of each bin; bins with a state have the force 1, 2, 3 ... N. */
const run = (phases) => ({
  forceN: [...phases].map((phase, bin) => (phase === '.' ? 0 : bin + 1)),
  indentationMm: [...phases].map((phase, bin) => (phase === '.' ? 0 : 10 * (bin + 1))),
  phase: [...phases].map((phase) => PHASES[phase]),
});
const reply = (a, b, more = {}) => ({
  sessions: ['a.mcap', 'b.mcap'], with: 'b.mcap', complete: true, problem: '', beginS: 2, binS: 0.005, sameTime: true,
  a: run(a), b: run(b), apartN: run(a).forceN.map((force_N) => force_N / 10), ...more,
});
const forces = (a, more) => readComparison(reply(a, a, more)).runs.a.force_N;

test('a bin without a state shows the last state before it, if the next one comes soon', () => {
  const {a, b, apart_N} = readComparison(reply('i.i', 'o..o')).runs;
  assert.deepEqual(a, {force_N: [1, 1, 3], indentation_mm: [10, 10, 30], phase: [1, 1, 1]});
  assert.deepEqual(b.force_N, [1, 1, 1, 4]);
  assert.deepEqual(apart_N, [0.1, 0.1, 0.3]);
});

test('after the end of one run there is no difference', () => {
  const {b, apart_N} = readComparison(reply('iiii', 'oo..', {binS: 0.1})).runs;
  assert.deepEqual(b.force_N, [1, 2, null, null]);
  assert.deepEqual(apart_N, [0.1, 0.2, null, null]);
});

test('a gap is filled as a whole or not at all', () => {
  assert.deepEqual(forces('i......i'), [1, 1, 1, 1, 1, 1, 1, 8], '35 ms from state to state');
  assert.deepEqual(forces('i.......i'), [1, null, null, null, null, null, null, null, 9], '40 ms: the station was silent');
});

test('the length of a gap is a time: in a long session a bin without a state stays empty', () => {
  assert.deepEqual(forces('i.i', {binS: 0.01}), [1, 1, 3]);
  assert.deepEqual(forces('i.i', {binS: 0.1}), [1, null, 3]);
});

test('nothing is claimed before the first state and behind the last', () => {
  assert.deepEqual(forces('.i.i.'), [null, 2, 2, 4, null]);
  assert.deepEqual(forces('...'), [null, null, null]);
});

test('bins lie at their middle, and the words are those of the bin at the moment', () => {
  const {runs} = readComparison(reply('i.i', 'o.o'));
  assert.deepEqual(runs.at_s.map((at_s) => Number(at_s.toFixed(4))), [2.0025, 2.0075, 2.0125]);
  assert.equal(momentSays(runs, 2.0125), '0:02.0: A 3.00 N, 30 mm, Pressing the skin; B 3.00 N, 30 mm, Above the skin; the force vectors differ by 0.30 N');
  assert.equal(momentSays(runs, 2.1), '', 'behind the end');
  assert.equal(momentSays(readComparison(reply('...', 'o.o')).runs, 2.0025),
      '0:02.0: A has no state; B 1.00 N, 10 mm, Above the skin', 'no state is not a force of 0 N');
});

test('the state of a comparison is a sentence', () => {
  const says = (more) => comparisonSays(readComparison(reply('i', 'i', more)));
  assert.equal(says({with: ''}), 'A is the played session.');
  assert.equal(says({complete: false}), 'Reading both sessions…');
  assert.equal(says({problem: 'b.mcap has no station'}), 'b.mcap has no station');
  assert.equal(says({sameTime: false}), 'The hand feels no difference between A and B. Recorded at different times: B is shifted, so that both begin together.');
  assert.equal(says({first: {atS: 2, forceAN: 1, forceBN: 1.25, apartN: 0.3}}),
      'At the first difference, 1.00 N in A, 1.25 N in B; the force vectors differ by 0.30 N. Both runs are shown at their session times.');
});

test('without a bin there is nothing to draw', () => {
  assert.equal(readComparison(reply('', '')).runs, undefined);
});
