// What the timeline bar shows of a state: node timeline_words_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {refusal} = await bundled('link/refusal.ts');
const {timelineLook, clock} = await bundled('playback/timeline_words.ts');
const {readState, afterCommand} = await bundled('playback/playback_state.ts');

const STATE = {position_s: 12.34, duration_s: 75.259, speed: 0.5, loop: false, playing: true, shown: undefined, begin_ms: 0.000017, session: 'a.mcap 17'};
const look = (changes) => timelineLook({...STATE, ...changes});

test('the first button offers the other of play and pause', () => {
  assert.equal(look({playing: true}).play, 'Pause');
  assert.equal(look({playing: false}).play, 'Play');
});

test('position and length are written in minutes and tenths, and spoken in words', () => {
  assert.equal(look({}).time, '0:12.3 / 1:15.2');
  assert.equal(look({}).spokenTime, '12.3 s of 1 min 15.2 s');
  assert.equal(clock(59.99), '0:59.9', 'it is not rounded to 60 s');
  assert.equal(clock(3600), '60:00.0');
});

test('the slider cannot be set behind the end, and the position is never shown there', () => {
  assert.equal(look({}).longest_s, 75.25);
  assert.equal(look({position_s: 80}).time, '1:15.2 / 1:15.2');
});

test('a speed that somebody else chose is offered, too', () => {
  assert.equal(look({speed: 0.7}).speed, '0.7');
  assert.deepEqual(look({speed: 0.7}).speeds, ['0.1', '0.25', '0.5', '0.7', '1', '2', '5', '10']);
});

const MESSAGE = {
  file: 'a.mcap', positionS: 12.34, durationS: 75.259, speed: 0.5, loop: false, playing: true, damaged: 0n, beginNs: 17n,
  shownNs: 0n, shownS: 0, shownSpeed: 0, pending: false,
};

test('a state is read, and one from before the last command is none', () => {
  assert.deepEqual(readState(MESSAGE), STATE);
  assert.equal(readState({...MESSAGE, pending: true}), undefined);
  assert.notEqual(readState({...MESSAGE, beginNs: 18n}).session, STATE.session, 'a file that was recorded anew');
});

test('the newest published image is read, and it is not known after a seek or a step', () => {
  const state = readState({...MESSAGE, shownNs: 1700000000123456789n, shownS: 3.25, shownSpeed: 0.5});
  assert.deepEqual(state.shown, {at_ms: 1700000000123.456, at_s: 3.25, speed: 0.5});
  for (const command of [{seek_s: 1}, {step: 1}, {step_back: 1}]) assert.equal(afterCommand(state, command).shown, undefined);
  assert.deepEqual(afterCommand(state, {speed: 2}).shown, state.shown);
  assert.equal(afterCommand(state, {step_back: 1}).playing, false);
});

test('the effect of a command is known before the server reports it', () => {
  assert.deepEqual(afterCommand(STATE, {seek_s: 3, speed: 2, loop: true}), {...STATE, position_s: 3, speed: 2, loop: true});
  assert.equal(afterCommand(STATE, {step: 1}).playing, false, 'a step pauses');
  assert.equal(afterCommand({...STATE, playing: false}, {play: true}).playing, true);
});

test('a refusal is a sentence with the server\'s reason', () => {
  assert.equal(refusal(403, 'only technicians and QA may control a played session\n'),
    'The server refused: only technicians and QA may control a played session.');
  assert.match(refusal(401, ''), /sign in again/);
  assert.match(refusal(500, ''), /status 500/);
});
