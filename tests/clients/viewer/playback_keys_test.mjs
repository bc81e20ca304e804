// What a key asks of a played session: node playback_keys_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {commandForKey} = await bundled('playback/playback_keys.ts');

const PLAYING = {position_s: 7, duration_s: 20, speed: 1, loop: true, playing: true};

for (const [what, key, focus, state, command] of [
  ['space pauses what plays', ' ', 'other', {}, {play: false}],
  ['space plays what is paused', ' ', 'scene', {playing: false}, {play: true}],
  ['space on a button presses that button', ' ', 'button', {}, undefined],
  ['right goes five seconds on', 'ArrowRight', 'other', {}, {seek_s: 12}],
  ['left goes five seconds back', 'ArrowLeft', 'button', {}, {seek_s: 2}],
  ['right stops at the end', 'ArrowRight', 'other', {position_s: 18}, {seek_s: 20}],
  ['left stops at the beginning', 'ArrowLeft', 'other', {position_s: 3}, {seek_s: 0}],
  ['home goes to the beginning', 'Home', 'other', {}, {seek_s: 0}],
  ['end goes to the end', 'End', 'button', {}, {seek_s: 20}],
  ['home stays with the view while the picture has the focus', 'Home', 'scene', {}, undefined],
  ['arrows turn the view while the picture has the focus', 'ArrowRight', 'scene', {}, undefined],
  ['arrows choose while the speed has the focus', 'ArrowRight', 'choice', {}, undefined],
  ['period goes one image on', '.', 'other', {}, {step: 1}],
  ['comma goes one image back', ',', 'scene', {}, {step_back: 1}],
  ['up and down stay with the view', 'ArrowUp', 'other', {}, undefined],
  ['letters stay with the view', 'r', 'other', {}, undefined],
])
  test(what, () => assert.deepEqual(commandForKey(key, focus, {...PLAYING, ...state}), command));
