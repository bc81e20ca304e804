// Which picture and which numbers belong together: node presented_instant_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {presentableUntil, fallsInGap, continuesWithoutPicture, nearest} = await bundled('present/presented_instant.ts');

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

test('a picture falls in a gap when numbers on both sides are too far from it, for a second at most', () => {
  assert.equal(fallsInGap(ms(1000), ms(1031), ms(1031), ms(900)), true);
  assert.equal(fallsInGap(ms(1000), ms(969), ms(1200), ms(900)), true);
  assert.equal(fallsInGap(ms(1000), ms(1030), ms(1030), ms(900)), false, 'near enough');
  assert.equal(fallsInGap(ms(1000), ms(900), ms(900), ms(900)), false, 'no later numbers: not a gap, but a silent station');
  assert.equal(fallsInGap(ms(1000), ms(1031), ms(1031), ms(0)), false, 'no picture for a second');
  assert.equal(fallsInGap(ms(1000), ms(1031), ms(1031), undefined), false, 'the first picture');
});

test('the nearest item is found on either side', () => {
  const at = (items, time) => nearest(items.map(ms), (item) => item, ms(time));
  assert.equal(at([10, 20, 30], 24), ms(20));
  assert.equal(at([10, 20, 30], 26), ms(30));
  assert.equal(at([], 26), undefined);
});
