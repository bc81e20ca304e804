// Voices on the page: heard with their picture, drawn below the timeline, and the room's microphone:
// node voice_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {JitterBuffer} = await bundled('voice/jitter_buffer.ts');
const {LipSync} = await bundled('voice/lip_sync.ts');
const {newPackets} = await bundled('voice/voice_decoding.ts');
const {lanesOf} = await bundled('playback/voice_lanes.ts');
const {roomVoiceButton, roomVoiceSays} = await bundled('panel/technician/room_voice_card.ts');

const frame = (number, talker = 1n, begun = 0) =>
  ({talker, number, begun, spoken_ms: 20 * number, samples: new Float32Array(960).fill((number % 100) / 1000 + 0.001)});
const numberOf = (block) => Math.round(1000 * (block[0] - 0.001));

/** Frames that arrive 30 ms after they were said, with pictures that are `picture_ms` old: the age of what is heard last. */
function ageHeard(picture_ms) {
  const [buffer, lips] = [new JitterBuffer(), new LipSync()];
  let age;
  for (let number = 0; number < 90; ++number) {
    const arrived = 20 * number + 50;
    buffer.add(frame(number), arrived, 50);
    lips.shown(picture_ms);
    buffer.held_ms = lips.delay_ms(buffer.fastest_ms);
    const block = buffer.pull(arrived + 7);
    if (block !== undefined) age = arrived + 7 - 20 * numberOf(block);
  }
  return age;
}

test('speech waits until it is as old as its picture', () => {
  assert.ok(ageHeard(30) < 80, 'the picture is newer: speech does not wait');
  for (const picture_ms of [90, 130, 200]) assert.ok(Math.abs(ageHeard(picture_ms) - picture_ms) <= 30, `${ageHeard(picture_ms)} ms`);
});

test('single late pictures do not count, and a very slow one is not awaited', () => {
  const lips = new LipSync();
  assert.equal(lips.delay_ms(20), 0);
  for (let i = 0; i < 30; ++i) lips.shown(i % 5 === 0 ? 900 : 80);
  assert.equal(lips.delay_ms(20), 60);
  for (let i = 0; i < 30; ++i) lips.shown(900);
  assert.equal(lips.delay_ms(20), 200);
});

test('after a jump of the played session nothing of the old place is heard', () => {
  const buffer = new JitterBuffer();
  for (let number = 0; number < 10; ++number) buffer.add(frame(number), 20 * number);
  for (let turn = 0; turn < 5; ++turn) buffer.pull(20 * turn + 7);
  buffer.add(frame(40, 2n, 40), 205);  // the player gives the talker a new number
  const heard = [];
  for (let turn = 0; turn < 10; ++turn) {
    if (turn > 0) buffer.add(frame(40 + turn, 2n, 40), 205 + 20 * turn);
    const block = buffer.pull(212 + 20 * turn);
    if (block !== undefined) heard.push(numberOf(block));
  }
  assert.deepEqual(heard, [40, 41, 42, 43, 44, 45, 46, 47, 48, 49]);
});

test('the packets of a message know when each was said', () => {
  const packets = newPackets(
      {number: 12, begun: 10, opus: new Uint8Array(3), earlier: [new Uint8Array(2), new Uint8Array(1)], capturedNs: 1_000_000_000n}, 9);
  assert.deepEqual(packets.map(({number, spoken_ms}) => [number, spoken_ms]), [[10, 960], [11, 980], [12, 1000]]);
});

const SPEECH = [
  {fromS: 0, untilS: 2, doctor: false, loudestDB: -10}, {fromS: 4, untilS: 5, doctor: true, loudestDB: -49},
  {fromS: 9, untilS: 12, doctor: false, loudestDB: -25},
];

test('each side that speaks has a lane: places and widths by time, heights by loudness, within the session', () => {
  const [patient, doctor, ...more] = lanesOf(SPEECH, 10);
  assert.deepEqual(more, []);
  assert.equal(patient.name, 'Patient');
  assert.deepEqual(patient.bars.map(({from, width, height}) => [from, Math.round(100 * width) / 100, height]), [[0, 0.2, 0.8], [0.9, 0.1, 0.5]]);
  assert.equal(doctor.bars[0].height, 0.3, 'quiet speech is seen, too');
  assert.match(doctor.bars[0].title, /^0:04\.0 to 0:05\.0: the doctor speaks$/);
  assert.match(patient.says, /speaks for 0:05\.0 of 0:10\.0/);
  assert.deepEqual(lanesOf([], 10), []);
  assert.deepEqual(lanesOf(SPEECH, 0), []);
  assert.equal(lanesOf(SPEECH.slice(0, 1), 10).length, 1);
});

test('the card of the room says whether it is heard, and why not', () => {
  const room = {device: 'default', open: false, hears: false, microphoneProblem: '', loudspeakerProblem: ''};
  assert.deepEqual(roomVoiceSays(room), ['The microphone is closed: nobody hears the room.', 'The room hears the doctor.']);
  assert.deepEqual(roomVoiceButton(room), {text: 'Open the microphone', light: false, next: true});
  assert.deepEqual(roomVoiceButton({...room, open: true, hears: true}), {text: '● Close the microphone', light: true, next: false});
  assert.equal(roomVoiceSays({...room, open: true})[0], 'The microphone is being opened…');
  assert.match(roomVoiceSays({...room, open: true, microphoneProblem: 'gone'})[0], /not heard: gone$/);
  assert.match(roomVoiceSays({...room, loudspeakerProblem: 'gone'})[1], /does not hear the doctor: gone$/);
});
