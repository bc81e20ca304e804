// Which depth packets the viewer decodes, and in which order: node packet_line_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {PacketLine} = await bundled('present/packet_line.ts');

const packet = (number, coding, bytes = 6) => {
  const packet = {bytes: new Uint8Array(bytes), captured_ns: BigInt(number)};
  packet.bytes[5] = coding;
  return packet;
};
const key = (number, bytes) => packet(number, 3, bytes);
const dependent = (number) => packet(number, 4);
const LAST = 1_000_000n;

/** The numbers of the packets that are decoded for a picture, in order. */
function drained(line, until = LAST) {
  const numbers = [];
  for (let next = line.next(until, true); next !== undefined; next = line.next(until, true))
    numbers.push(Number(next.captured_ns));
  return numbers;
}

test('packets that depend on one another are all decoded, in order', () => {
  const line = new PacketLine();
  assert.ok([key(1), dependent(2), dependent(3)].every((next) => line.push(next)));
  assert.deepEqual(drained(line), [1, 2, 3]);
  assert.equal(line.overtaken, 0);
});

test('what is too old to draw is dropped before it is decoded', () => {
  const line = new PacketLine();
  [key(1), dependent(2), key(3), dependent(4), key(5)].forEach((next) => line.push(next));
  assert.deepEqual(drained(line), [5]);
  assert.equal(line.overtaken, 4);
});

test('a picture whose numbers have not come is neither decoded nor does it overtake one whose have', () => {
  const line = new PacketLine();
  [key(1), key(2), key(3)].forEach((next) => line.push(next));
  assert.deepEqual(drained(line, 2n), [2]);
  assert.deepEqual(drained(line), [3]);
  assert.equal(line.overtaken, 1);
});

test('a page that is busy decodes ahead only what a later packet depends on', () => {
  const line = new PacketLine();
  line.push(key(1));
  assert.equal(line.next(LAST, false), undefined);
  line.push(dependent(2));
  assert.equal(line.next(LAST, false).captured_ns, 1n);
  assert.equal(line.next(LAST, false).captured_ns, 2n);
  line.push(dependent(3));
  assert.equal(line.next(LAST, false).captured_ns, 3n);
  assert.equal(line.next(LAST, false), undefined);
});

test('who joins mid-group says so and waits for a key frame', () => {
  const line = new PacketLine();
  assert.equal(line.push(dependent(7)), false);
  assert.equal(line.push(dependent(8)), false);
  assert.equal(line.push(key(9)), true);
  assert.deepEqual(drained(line), [9]);
});

test('after one that could not be decoded, nothing is shown until the next key frame', () => {
  const line = new PacketLine();
  [key(1), dependent(2), dependent(3)].forEach((next) => line.push(next));
  assert.equal(line.next(LAST, true).captured_ns, 1n);
  line.failed();
  assert.deepEqual(drained(line), []);
  assert.equal(line.push(dependent(4)), false);
  assert.equal(line.push(key(5)), true);
  assert.equal(line.next(LAST, true).captured_ns, 5n);
  line.failed();
  assert.equal(line.push(dependent(6)), false);
  assert.equal(line.push(key(7)), true);
  assert.deepEqual(drained(line), [7]);
});

test('a failure is forgotten when a key frame waits', () => {
  const line = new PacketLine();
  line.push(key(1));
  assert.equal(line.next(LAST, true).captured_ns, 1n);
  [dependent(2), key(3)].forEach((next) => line.push(next));
  line.failed();
  assert.equal(line.push(dependent(4)), true);
  assert.deepEqual(drained(line), [3, 4]);
});

test('a group that grows too long is let go of, and nothing of it is kept', () => {
  const line = new PacketLine();
  line.push(key(0));
  let kept = 0;
  for (let number = 1; number < 100; ++number) kept += line.push(dependent(number)) ? 1 : 0;
  assert.equal(kept, 63);
  assert.deepEqual(drained(line), []);
  assert.equal(line.overtaken, 100);
  assert.equal(line.push(key(100)), true);
});

test('packets that stand alone are bounded in number and in bytes, the newest are kept', () => {
  const line = new PacketLine();
  for (let number = 0; number < 1000; ++number) assert.ok(line.push(key(number)));
  assert.equal(line.overtaken, 1000 - 64);
  for (let number = 0; number < 40; ++number) line.push(key(1000 + number, 1 << 20));
  assert.equal(line.overtaken, 1040 - 16);
  assert.deepEqual(drained(line), [1039]);
});
