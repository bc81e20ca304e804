// The technician's recording at the server: node recording_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {beginRecording, consentText, readRecording, recordingRows} = await bundled('panel/technician/recording_state.ts');

const RECORDING = {phase: 1, file: 'session_a.mcap', seconds: 75.5, bytes: 2_500_000n, problem: ''};
const rows = (changes = {}) => recordingRows(readRecording({...RECORDING, ...changes})).map(({name, value}) => `${name}: ${value}`);

test('the card says what is recorded, and for how long', () => {
  assert.deepEqual(rows(), ['Now: recording', 'File: session_a.mcap', 'Length: 1:15, 2.5 MB']);
  assert.deepEqual(rows({phase: 2}).slice(0, 1), ['Now: completing the file']);
  assert.deepEqual(rows({phase: 0}).slice(0, 2), ['Now: not recording', 'Last file: session_a.mcap']);
  assert.deepEqual(rows({phase: 0, file: ''}), ['Now: not recording']);
});

test('words are recorded only with a consent of their own', () => {
  assert.deepEqual(beginRecording('technician', '', false), {record: true, consent: consentText('technician', '')});
  assert.equal(beginRecording('technician', 'study 17', true).voice_consent, consentText('technician', 'study 17'));
});

test('the consent names who ticked it, and is short', () => {
  assert.equal(consentText('technician', ' study 17 '), 'ticked in the web viewer by technician: study 17');
  assert.equal(consentText('technician', 'study\t17\u0007'), 'ticked in the web viewer by technician: study 17');
  assert.equal(consentText('', ''), 'ticked in the web viewer by a visitor');
  assert.ok(consentText('technician', 'x'.repeat(500)).length <= 200);
});
