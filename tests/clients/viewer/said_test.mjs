// What was said lately, and in which words it stands on the picture: node said_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {inWords, standing} = await bundled('said/standing.ts');
const {Pointed} = await bundled('scene/pointed.ts');
const {fromCamera} = await bundled('scene/frames.ts');

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

test('an arrow moves with the breathing body, and not to a hand that comes between', () => {
  const pointed = new Pointed();
  pointed.show([fromCamera({x: 0, y: 0, z: 0.8})]);
  const end_m = () => pointed.group.children[0].position.length() + 0.09;  // an arrow of 90 mm begins towards the camera
  for (const [measured_m, expected_m] of [[0.8, 0.8], [0.79, 0.79], [0.77, 0.77], [0.5, 0.77], [0, 0.77], [0.78, 0.78]]) {
    pointed.follow(() => measured_m);
    assert.ok(Math.abs(end_m() - expected_m) < 1e-9, `${measured_m}: ${end_m()}`);
  }
});
