// What the page is given to draw when it asks: node instants_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {Instants} = await bundled('present/instants.ts');

const ms = (value) => BigInt(value) * 1_000_000n;
const KEY = 3;
const DEPENDENT = 4;

/** Instants whose decoder answers only when `answer` is called, as a worker does. */
function bench() {
  const seen = {presented: [], decoding: [], decodings: 0, keys: 0, now_ms: 0};
  const instants = new Instants({
    now_ms: () => seen.now_ms,
    decode: (packet) => {
      ++seen.decodings;
      seen.decoding.push(packet);
    },
    present: (chosen) => seen.presented.push(chosen),
    requestKeyFrame: () => ++seen.keys,
  });
  return {
    seen,
    instants,
    depth: (at_ms, coding = KEY) => instants.depthCame({
      bytes: Uint8Array.of(84, 80, 68, 50, 2, coding), captured_ns: ms(at_ms), published_ns: ms(at_ms + 10),
    }),
    station: (at_ms, force_N = 1) => instants.stationCame(
        {stampNs: ms(at_ms), forceN: {x: 0, y: force_N, z: 0}, indentationM: 0.001 * at_ms}),
    answer: () => {
      const packet = seen.decoding.shift();
      instants.decoded({frame: Number(packet.captured_ns / 1_000_000n), summary: {}, decode_ms: 1});
    },
  };
}

test('picture and numbers of one capture time are presented together', () => {
  const {seen, instants, depth, station, answer} = bench();
  for (const at of [980, 990, 1000, 1010]) station(at);
  depth(1002);
  instants.ask();
  answer();
  assert.equal(seen.presented[0].decoded.frame, 1002);
  assert.equal(seen.presented[0].station.stampNs, ms(1000));
  assert.equal(seen.presented[0].hand, 'new');
  assert.deepEqual(seen.presented[0].trail.map(({at_s}) => at_s), [0.98, 0.99, 1]);
});

test('a picture waits for the numbers of its instant, and that is counted as its way here', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000);
  depth(1000);
  instants.ask();
  answer();
  instants.ask();
  seen.now_ms = 20;
  depth(1033);
  assert.equal(seen.decodings, 1);
  seen.now_ms = 50;
  station(1040);
  answer();
  assert.equal(seen.presented[1].station.stampNs, ms(1033), 'between those of 1000 and 1040');
  assert.equal(seen.presented[1].arrival.complete_ms, 50);
});

test('a page that does not ask is given nothing, and when it asks, one picture is decoded: the newest', () => {
  const {seen, instants, depth, station, answer} = bench();
  for (let at = 1000; at < 11_000; at += 10) {
    station(at);
    if (at % 30 === 0) depth(at);
  }
  assert.equal(seen.decodings, 0);
  instants.ask();
  answer();
  assert.equal(seen.presented.length, 1);
  assert.equal(seen.presented[0].decoded.frame, 10_980);
  assert.equal(seen.presented[0].station.stampNs, ms(10_980));
  assert.equal(instants.overtaken, 332, 'all but the newest of 333, before they were decoded');
  assert.ok(seen.presented[0].trail.length <= 256);
});

test('a group is decoded in order while the page draws, and only its newest picture is presented', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000);
  depth(1000);
  for (let at = 1030; at < 2000; at += 30) {
    station(at);
    depth(at, DEPENDENT);
    while (seen.decoding.length > 0) answer();
  }
  instants.ask();
  assert.equal(seen.presented[0].decoded.frame, 1990);
  assert.equal(seen.decodings, 34);
  assert.equal(instants.overtaken, 0);
  assert.equal(seen.keys, 0);
});

test('numbers go on alone when no picture comes, and not while one is on its way', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000);
  depth(1000);
  instants.ask();
  answer();
  instants.ask();
  for (let at = 1010; at <= 1250; at += 10) station(at);
  assert.equal(seen.presented.length, 1);
  station(1260, 7);
  assert.equal(seen.presented.length, 2);
  assert.equal(seen.presented[1].decoded, undefined);
  assert.equal(seen.presented[1].station.forceN.y, 7);
  assert.equal(seen.presented[1].hand, 'kept', 'the hand stays with the picture');
});

test('a picture in a gap of the numbers is skipped, and the next that has numbers is presented', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000);
  depth(1000);
  instants.ask();
  answer();
  instants.ask();
  depth(1070);
  station(1136);
  answer();
  assert.equal(seen.presented.length, 1, '66 ms to the nearest numbers on either side');
  depth(1133);
  answer();
  assert.equal(seen.presented[1].decoded.frame, 1133);
  assert.equal(seen.presented[1].station.stampNs, ms(1136));
});

test('a picture between numbers that are 40 ms apart comes with estimates for its instant', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000, 1);
  depth(1010);
  instants.ask();
  station(1040, 5);
  answer();
  assert.equal(seen.presented[0].station.stampNs, ms(1010));
  assert.equal(seen.presented[0].station.forceN.y, 2);
});

test('a station that is far behind does not lend its old numbers to a picture, and the page is told how late it is', () => {
  const {seen, instants, depth, station, answer} = bench();
  station(1000);
  depth(1700);
  instants.ask();
  answer();
  assert.equal(seen.presented[0].decoded.frame, 1700);
  assert.equal(seen.presented[0].station, undefined);
  assert.equal(seen.presented[0].hand, 'none');
  assert.equal(seen.presented[0].late_ms, 700);
});

test('numbers that come seldom do not stop the pictures, which come without a hand', () => {
  const {seen, instants, depth, station, answer} = bench();
  for (let at = 1000; at <= 5000; at += 200) {
    station(at);
    depth(at - 100);
    instants.ask();
    while (seen.decoding.length > 0) answer();
  }
  const pictures = seen.presented.filter(({decoded}) => decoded !== undefined);
  assert.deepEqual(pictures.map(({decoded}) => decoded.frame), Array.from({length: 21}, (_, i) => 900 + 200 * i));
  for (const {station: values, hand} of pictures) assert.deepEqual([values, hand], [undefined, 'none']);
});

test('a picture of a paused session, whose numbers never come, is presented after half a second', () => {
  const {seen, instants, depth, station, answer} = bench();
  instants.ask();
  station(992);
  depth(1000);
  seen.now_ms = 400;
  instants.timePassed();
  assert.equal(seen.decodings, 0, 'its numbers may still come');
  seen.now_ms = 501;
  instants.timePassed();
  answer();
  assert.equal(seen.presented[0].decoded.frame, 1000);
  assert.deepEqual([seen.presented[0].station, seen.presented[0].hand], [undefined, 'none']);
});

test('what was being decoded when the connection ended is not presented by the next one', () => {
  const {seen, instants, depth, answer} = bench();
  instants.ask();
  depth(1000);
  instants.restart();
  answer();
  assert.equal(seen.presented.length, 0);
  depth(2000);
  answer();
  assert.equal(seen.presented[0].decoded.frame, 2000);
});

test('a frame of video is closed when it is not shown, and given away when it is', () => {
  const {seen, instants, depth, station, answer} = bench();
  const closed = [];
  const frame = (at_ms) => instants.colorCame({data: {close: () => closed.push(at_ms)}, captured_ns: ms(at_ms)});
  station(1010);
  for (const at of [900, 950, 1000, 1050]) frame(at);
  depth(1000);
  instants.ask();
  answer();
  assert.equal(seen.presented[0].color.captured_ns, ms(1000));
  assert.deepEqual(closed, [900, 950]);
  instants.restart();
  assert.deepEqual(closed, [900, 950, 1050]);
});
