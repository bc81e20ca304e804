// How soon the page notices that images have stopped, and how seldom it is wrong:
// node silence_test.mjs VIEWER_SOURCES VIEWER_WORK TELEPALP_IMAGE_ARRIVALS
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';
import {imageArrivals, watchWith} from './image_arrivals.mjs';

const {ImageGaps} = await bundled('link/image_gaps.ts');
const {LeastAge} = await bundled('link/least_age.ts');
const {SilenceWatch} = await bundled('link/silence_watch.ts');
const arrivals = process.argv[4];

const watchOn = () => watchWith(SilenceWatch);
const over = (profile, kilobytes, seconds = 600) => imageArrivals(arrivals, profile, kilobytes, seconds);

/** Images each 33 ms from `from_ms` to `to_ms`. */
function regular(image, from_ms, to_ms) {
  for (let at_ms = from_ms; at_ms <= to_ms; at_ms += 33) image(at_ms);
}

for (const [profile, kilobytes] of [['lte', 60], ['satellite', 20], ['satellite', 180]])
  test(`ten minutes over ${profile} with images of ${kilobytes} kB: at most one false mark`, () => {
    const {seen, image} = watchOn();
    const times = over(profile, kilobytes);
    assert.ok(times.length > 25 * 600, `${times.length} images`);
    times.forEach(image);
    assert.ok(seen.marks.length <= 1, `${seen.marks.length} false marks, at ${seen.marks} ms`);
  });

test('a second without images is marked on the worst path, too', () => {
  const {seen, image} = watchOn();
  over('hostile', 60).forEach(image);  // which is cut off for 1 s in every 20 s
  assert.ok(seen.marks.length > 10, `${seen.marks.length} marks`);
});

for (const [profile, most_ms] of [['lan', 300], ['lte', 300], ['satellite', 1000]])
  test(`a server that stops is noticed within ${most_ms} ms over ${profile}`, () => {
    const {seen, watch, image, passTo} = watchOn();
    const times = over(profile, 60, 60);
    times.forEach(image);
    const last_ms = times.at(-1);
    const limit_ms = watch.usual_ms <= 100 ? 300 : watch.usual_ms + 200;
    passTo(last_ms + 2000);
    assert.equal(seen.marks.length, 1);
    assert.ok(seen.marks[0] - last_ms <= Math.min(most_ms, limit_ms), `${seen.marks[0] - last_ms} ms, usual gap ${watch.usual_ms} ms`);
    assert.equal(watch.since_ms, last_ms);
  });

test('one outage a minute does not teach the page to wait longer, and slower images do', () => {
  const gaps = new ImageGaps();
  for (let images = 0; images < 1800; ++images) gaps.add(33);
  gaps.add(60_000);
  assert.equal(gaps.limit_ms, 270);
  for (let images = 0; images < 10; ++images) gaps.add(333);
  assert.equal(gaps.usual_ms, 340);
  assert.equal(gaps.limit_ms, 540);
});

test('a path that is not known yet gets a second', () => {
  const {seen, image, passTo} = watchOn();
  regular(image, 0, 1000);
  passTo(1900);
  assert.deepEqual(seen.marks, []);
  passTo(2100);
  assert.equal(seen.marks.length, 1);
});

test('the silence ends with the next image', () => {
  const {seen, watch, image, passTo} = watchOn();
  regular(image, 0, 20_000);
  passTo(21_000);
  assert.notEqual(watch.since_ms, undefined);
  image(21_001);
  assert.equal(watch.since_ms, undefined);
  assert.equal(seen.changes, 2);
});

test('a paused session is not silent, and a step in it begins no silence', () => {
  const {seen, watch, image, passTo} = watchOn();
  regular(image, 0, 20_000);
  watch.rest(true);
  passTo(30_000);
  image(30_001);
  passTo(40_000);
  assert.deepEqual(seen.marks, []);
  watch.rest(false);
  passTo(40_500);
  assert.equal(seen.marks.length, 1, 'a session that goes on, and gives no image');
});

test('a page that was held up looks again once the waiting images have been read', () => {
  const {seen, image} = watchOn();
  regular(image, 0, 20_000);
  seen.now_ms = 21_000;  // the computer slept; the timer was due at about 20.3 s
  seen.due_ms = Infinity;
  seen.call();
  assert.deepEqual(seen.marks, []);
  assert.equal(seen.due_ms, 21_010, 'behind the messages that have arrived');
  image(21_005);
  assert.deepEqual(seen.marks, []);
});

test('the delay of a path is the least of a minute: a queue does not raise it, another path does', () => {
  const least = new LeastAge();
  assert.equal(least.value_ms, 0);
  for (let at_ms = 0; at_ms < 20_000; at_ms += 33) least.note(20 + at_ms / 10, at_ms);
  assert.equal(least.value_ms, 20);
  for (let at_ms = 20_000; at_ms < 90_000; at_ms += 33) least.note(330, at_ms);
  assert.equal(least.value_ms, 330);
});
