// deploy/tick-ratio says what its runs say: node tick_ratio_test.mjs SOURCE_DIR
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {test} from 'node:test';

const sourceDir = process.argv[2];
const {column, disturbance, median, quantile, ratioRows} = await import(join(sourceDir, 'deploy/numbers/tick_rows.mjs'));

test('a column is found by its name', () => {
  assert.deepEqual(column('tick,work_us,phase\n1,2.5,0\n2,3,1\n', 'work_us'), [2.5, 3]);
  assert.throws(() => column('tick\n1\n', 'work_us'), /no column work_us/);
});

test('one value in a thousand lies above p99.9', () => {
  const values = Array.from({length: 1000}, (_, i) => i);
  assert.equal(quantile(values, 0.999), 998);
  assert.equal(quantile([7], 0.999), 7);
  assert.equal(median([3, 1, 2]), 2);
  assert.equal(median([4, 1, 2, 3]), 2.5);
});

const pairs = (ratios) => ratios.map((ratio) => ({base: {p50: 4, p999: 20}, head: {p50: 4, p999: 20 * ratio}}));

test('a slower tick misses, and one disturbed pair does not', () => {
  assert.equal(ratioRows(pairs([1.06, 1.06, 1.06]), 1.05)[0].holds, false);
  assert.equal(ratioRows(pairs([1, 1.02, 9]), 1.05)[0].holds, true);
  assert.equal(ratioRows(pairs([1, 1.02, 9]), 1.05)[0].value, 1.02);
});

test('runs of one program that differ are a disturbed machine', () => {
  assert.equal(disturbance(pairs([1, 1.3])), 1, 'the base alone tells it');
  assert.equal(disturbance([{base: {p999: 10}}, {base: {p999: 35}}]), 3.5);
});

test('a wrong question is answered with what to ask', () => {
  const asked = (...words) => spawnSync(join(sourceDir, 'deploy/tick-ratio'), words, {encoding: 'utf8'});
  assert.equal(asked('--help').status, 0);
  for (const words of [[], ['--base'], ['--base', 'no-such-commit'], ['--pairs', '0', '--base', 'HEAD'], ['--speed', '1']]) {
    const {status, stderr} = asked(...words);
    assert.equal(status, 2, words.join(' '));
    assert.match(stderr, /fix: /);
  }
});
