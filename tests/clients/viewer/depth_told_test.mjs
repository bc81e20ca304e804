// What the viewer says of depth that may be off: node depth_told_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {depthTold, inWords} = await bundled('depth/depth_told.ts');

const told = (format, leastM, perM) => {
  const depth = depthTold({format, bound: leastM === undefined ? undefined : {leastM, perM}});
  return {...depth, words: inWords(depth)};
};

test('depth without loss is as measured', () => {
  for (const mode of ['fast', 'intra', 'temporal']) {
    assert.equal(told(mode).moved, false);
    assert.equal(told(mode).words, `${mode}, as measured`);
  }
  assert.equal(told('').words, 'not told');
});

test('bounded depth says how far it may be off, and how that grows', () => {
  const {moved, words, more} = told('bounded', 0.001, 0.00285);
  assert.equal(moved, true);
  assert.equal(words, 'bounded, off by up to 2.85 mm at 1 m');
  assert.match(more, /2\.85 mm times z squared.* 1 mm where that is more/);
  assert.equal(told('bounded', 0.004, 0.00285).words, 'bounded, off by up to 4 mm at 1 m');
  assert.equal(told('fast', 0.001, 0.00285).words, 'fast, off by up to 2.85 mm at 1 m');
});

test('an absurd bound is as good as none, but the loss is believed', () => {
  for (const absurd of [NaN, Infinity, -0.001, 1.5])
    for (const {moved, words} of [told('bounded', absurd, 0.003), told('bounded', 0.001, absurd)]) {
      assert.equal(moved, true);
      assert.equal(words, 'bounded, off by an unknown amount');
    }
  assert.equal(told('bounded').words, 'bounded, off by an unknown amount');
});

test('the name of a mode is shown only as far as one may be long', () => {
  assert.equal(told('x'.repeat(100_000)).words, `${'x'.repeat(32)}, as measured`);
});
