// Which depth packets the viewer decodes, and in which order: node packet_line_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {PacketLine} = await bundled('depth/packet_line.ts');

const packet = (number, coding) => ({bytes: Uint8Array.of(84, 80, 68, 50, 2, coding), captured_ns: BigInt(number)});
const key = (number) => packet(number, 3);
const dependent = (number) => packet(number, 4);

/** The numbers of all that waits, in the order in which it would be decoded. */
function drained(line) {
  const numbers = [];
  for (let next = line.shift(); next !== undefined; next = line.shift()) numbers.push(Number(next.captured_ns));
  return numbers;
}

test('packets that depend on one another are all decoded, in order', () => {
  const line = new PacketLine();
  assert.ok([key(1), dependent(2), dependent(3)].every((next) => line.push(next)));
  assert.deepEqual(drained(line), [1, 2, 3]);
  assert.equal(line.overtaken, 0);
});

test('a packet that stands alone overtakes all that wait', () => {
  const line = new PacketLine();
  [key(1), dependent(2), key(3), dependent(4), key(5)].forEach((next) => line.push(next));
  assert.deepEqual(drained(line), [5]);
  assert.equal(line.overtaken, 4);
});

test('who joins mid-group says so and waits for a key frame', () => {
  const line = new PacketLine();
  assert.equal(line.push(dependent(7)), false);
  assert.equal(line.push(dependent(8)), false);
  assert.equal(line.push(key(9)), true);
  assert.deepEqual(drained(line), [9]);
});

test('after one that could not be decoded, nothing is shown until the next that stands alone', () => {
  const line = new PacketLine();
  [key(1), dependent(2), dependent(3)].forEach((next) => line.push(next));
  line.shift();
  line.failed();
  assert.deepEqual(drained(line), []);
  assert.equal(line.push(dependent(4)), false);
  assert.equal(line.push(key(5)), true);
  line.shift();
  line.failed();
  assert.equal(line.push(dependent(6)), false);
  assert.equal(line.push(key(7)), true);
  assert.deepEqual(drained(line), [7]);
});

test('a failure is forgotten when what waits stands alone', () => {
  const line = new PacketLine();
  line.push(key(1));
  line.shift();
  line.push(key(2));
  line.failed();
  assert.equal(line.push(dependent(3)), true);
  assert.deepEqual(drained(line), [2, 3]);
});

test('a page that is a second behind lets go of all that waits, and keeps nothing more', () => {
  const line = new PacketLine();
  line.push(key(0));
  let kept = 0;
  for (let number = 1; number < 100; ++number) kept += line.push(dependent(number)) ? 1 : 0;
  assert.equal(kept, 29);
  assert.deepEqual(drained(line), []);
  assert.equal(line.overtaken, 100);
  assert.equal(line.push(key(100)), true);
});
