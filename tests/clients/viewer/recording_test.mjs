// The technician's recording at the server: node recording_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {consentText, readRecording, recordingRows, RecordingLink} = await bundled('panel/technician/recording_link.ts');

const RECORDING = '{"phase":"PHASE_RECORDING","file":"session_a.mcap","seconds":75.5,"bytes":"2500000","problem":""}';

/** A link to a server that gives the answers in turn. */
function link(...answers) {
  const asked = [];
  const it = new RecordingLink(async (command) => {
    asked.push(command);
    return answers.shift();
  });
  return {it, asked};
}

test('a server that offers no recording is asked once, and again after a new connection', async () => {
  const {it, asked} = link({status: 200, text: '{}'}, {status: 200, text: RECORDING});
  for (let look = 0; look < 40; ++look) await it.look(true);
  assert.equal(asked.length, 1);
  assert.equal(it.state, undefined);
  await it.look(false);
  await it.look(true);
  assert.equal(it.state.file, 'session_a.mcap');
});

test('the state is read each tenth look, with numbers of 64 bits', async () => {
  const {it, asked} = link({status: 200, text: RECORDING}, {status: 200, text: RECORDING});
  for (let look = 0; look < 20; ++look) await it.look(true);
  assert.equal(asked.length, 2);
  assert.equal(it.state.bytes, 2_500_000);
  assert.deepEqual(recordingRows(it.state).map(({value}) => value), ['recording', 'session_a.mcap', '1:15, 2.5 MB']);
});

test('a refusal is told in the server\'s words, and the next command clears it', async () => {
  const {it} = link({status: 403, text: 'only doctors, technicians and QA may record\n'}, {status: 200, text: RECORDING});
  await it.command({record: true, consent: 'signed'});
  assert.equal(it.problem, 'only doctors, technicians and QA may record');
  await it.command({record: true, consent: 'signed'});
  assert.equal(it.problem, '');
});

test('a failed recorder is told', async () => {
  const {it} = link({status: 200, text: RECORDING.replace('"problem":""', '"problem":"the disk is full"')});
  await it.look(true);
  assert.equal(it.problem, 'the disk is full');
});

test('a command that gets no answer is told, until the server answers', async () => {
  const {it} = link(undefined, undefined, {status: 200, text: RECORDING});
  await it.command({record: false});
  assert.match(it.problem, /does not answer/);
  for (let look = 0; look < 10; ++look) await it.look(true);
  assert.match(it.problem, /does not answer/);
  for (let look = 0; look < 10; ++look) await it.look(true);
  assert.equal(it.problem, '');
  assert.equal(it.state.phase, 'PHASE_RECORDING');
});

test('the consent names who ticked it, and is short', () => {
  assert.equal(consentText('technician', ' study 17 '), 'ticked in the web viewer by technician: study 17');
  assert.equal(consentText('technician', 'study\t17\u0007'), 'ticked in the web viewer by technician: study 17');
  assert.equal(consentText('', ''), 'ticked in the web viewer by a visitor');
  assert.ok(consentText('technician', 'x'.repeat(500)).length <= 200);
  assert.equal(readRecording('no JSON'), undefined);
});
