// Where the time went that a picture is old: node time_account_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {accountFor, slowest, total_ms, WorstOfSecond} = await bundled('present/time_account.ts');

const frame = (captured_ms, published_ms, complete_ms) => ({captured_ms, published_ms, complete_ms});
/**
 * A frame captured at 0, published at 10, here at 40, drawn at 60; without other values, the link receives messages.
 */
const account = (now_ms, {shown = {...frame(0, 10, 40), drawn_ms: 60}, next, heard} = {}) =>
    accountFor({shown, next, heard: heard ?? {published_ms: now_ms - 40, received_ms: now_ms - 10}}, now_ms);

const CASES = [
  {name: 'drawn just now', of: account(60), is: {site: 10, network: 30, computer: 20}},
  {name: 'nothing newer came, the link is heard', of: account(2060), is: {site: 2010, network: 30, computer: 20}},
  {
    name: 'nothing at all is heard since a word just after the picture',
    of: account(5060, {heard: {published_ms: 40, received_ms: 70}}),
    is: {site: 40, network: 5000, computer: 20},
  },
  {
    name: 'newer ones came while this one was drawn',
    of: account(3000, {shown: {...frame(0, 10, 40), drawn_ms: 1500}, next: frame(33, 43, 73)}),
    is: {site: 10, network: 30, computer: 2960},
  },
  {
    name: 'the next one was late from the patient\'s site, and is drawn now',
    of: account(1100, {next: frame(1000, 1010, 1060)}),
    is: {site: 1010, network: 30, computer: 60},
  },
  {
    name: 'the next one was published at once and took a second to come',
    of: account(1100, {next: frame(33, 43, 1060)}),
    is: {site: 43, network: 997, computer: 60},
  },
  {
    name: 'the link is slow, from queues on the way',
    of: account(2000, {shown: {...frame(0, 10, 1900), drawn_ms: 1950}}),
    is: {site: 60, network: 1890, computer: 50},
  },
];

for (const {name, of, is} of CASES)
  test(name, () => {
    assert.deepEqual(of, is);
    assert.equal(slowest(of), Object.entries(is).sort((a, b) => b[1] - a[1])[0][0]);
  });

test('the parts add up to the age', () => {
  let seed = 20260731;
  const upTo = (most) => (seed = (seed * 48271) % 2147483647) % most;
  for (let times = 0; times < 1000; ++times) {
    const captured = upTo(1000);
    const published = captured + upTo(500);
    const complete = published + upTo(3000);
    const drawn_ms = complete + upTo(3000);
    const now = drawn_ms + upTo(3000);
    const next = upTo(2) === 0 ? undefined : frame(captured + 33, published + upTo(3000), complete + upTo(4000));
    const heard = {published_ms: published + upTo(100), received_ms: now - upTo(3000)};
    const parts = accountFor({shown: {...frame(captured, published, complete), drawn_ms}, next, heard}, now);
    assert.ok(Object.values(parts).every((part) => part >= 0), `seed 20260731, ${times}`);
    assert.equal(total_ms(parts), now - captured, `seed 20260731, ${times}`);
  }
});

test('the oldest picture of the last second is shown', () => {
  const worst = new WorstOfSecond();
  const of = (computer) => ({site: 0, network: 0, computer});
  assert.equal(worst.note(of(900), 0).computer, 900);
  assert.equal(worst.note(of(100), 500).computer, 900);
  assert.equal(worst.note(of(1200), 600).computer, 1200);
  assert.equal(worst.note(of(100), 1700).computer, 100);
});
