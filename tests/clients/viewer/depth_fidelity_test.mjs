// What the viewer says of depth that may be off: node depth_fidelity_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {depthFidelity, inWords} = await bundled('depth/depth_fidelity.ts');

const fidelityOf = (format, leastM, perM) => {
  const depth = depthFidelity({format, bound: leastM === undefined ? undefined : {leastM, perM}});
  return {...depth, words: inWords(depth)};
};

test('depth without loss is lossless', () => {
  for (const mode of ['fast', 'intra', 'temporal']) {
    assert.equal(fidelityOf(mode).moved, false);
    assert.equal(fidelityOf(mode).words, `${mode}, lossless`);
  }
  assert.equal(fidelityOf('').words, 'not stated');
});

test('bounded depth says how far it may be off, and how that grows', () => {
  const {moved, words, more} = fidelityOf('bounded', 0.001, 0.00285);
  assert.equal(moved, true);
  assert.equal(words, 'bounded, off by up to 2.85 mm at 1 m');
  assert.match(more, /2\.85 mm times z squared.* 1 mm where that is larger/);
  assert.equal(fidelityOf('bounded', 0.004, 0.00285).words, 'bounded, off by up to 4 mm at 1 m');
  assert.equal(fidelityOf('fast', 0.001, 0.00285).words, 'fast, off by up to 2.85 mm at 1 m');
});

test('an absurd bound is as good as none, but the loss is believed', () => {
  for (const absurd of [NaN, Infinity, -0.001, 1.5])
    for (const {moved, words} of [fidelityOf('bounded', absurd, 0.003), fidelityOf('bounded', 0.001, absurd)]) {
      assert.equal(moved, true);
      assert.equal(words, 'bounded, off by an unknown amount');
    }
  assert.equal(fidelityOf('bounded').words, 'bounded, off by an unknown amount');
});

test('the name of a mode is shown only as far as one may be long', () => {
  assert.equal(fidelityOf('x'.repeat(100_000)).words, `${'x'.repeat(32)}, lossless`);
});
