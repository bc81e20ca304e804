// What was said lately, and in which words it stands on the picture: node said_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {inWords, standing} = await bundled('said/standing.ts');

const note = (at_s, text, atM) => ({atNs: BigInt(Math.round(at_s * 1e9)), text, who: 'doctor Anna', written: '', atM});
const NOW = 100_000_000_000n;

test('words and places stand for 20 s, and a mark without either is nothing said', () => {
  const state = {count: 5, newest: [note(79.9, 'old'), note(80.1, 'new'), note(99, ''), note(99, '', {x: 0, y: 0, z: 1})]};
  assert.deepEqual(standing(state, NOW).map(inWords), ['doctor Anna: new', 'doctor Anna points here']);
});

test('nothing is shown before the session clock or the first mark is known', () => {
  assert.deepEqual(standing({count: 1, newest: [note(99, 'new')]}, undefined), []);
  assert.deepEqual(standing(undefined, NOW), []);
});

test('a page on the server itself has no name, and says where it is', () => {
  assert.equal(inWords({...note(99, 'turn'), who: 'local local'}), 'At the server: turn');
});
