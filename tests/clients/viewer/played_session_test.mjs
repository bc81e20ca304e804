// node played_session_test.mjs VIEWER_SOURCES VIEWER_WORK: what the page knows of the impaired network and the notes.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {joined, networkRows, placeOf, readNetwork, SLIDERS, textOf} = await bundled('playback/network_state.ts');
const {keyOf, noteInAddress, readNotes} = await bundled('playback/session_notes.ts');
const {addressOfMoment} = await bundled('playback/moment.ts');
const {shownMoment} = await bundled('playback/shown_moment.ts');

const STATE = {
  profile: 'lte', changed: false, delayMs: 25, jitterMs: 8, lossPercent: 0.5, burstPackets: 3, rateMbitPerS: 40,
  packetsSent: 1000n, packetsDelivered: 990n, packetsLost: 8n, imagesArrived: 90n, imagesLate: 4n, imagesLost: 6n,
  imageDelayMs: 31.4,
};
const state = (changes = {}) => readNetwork({...STATE, ...changes});
const slider = (field) => SLIDERS.find((one) => one.field === field);

test('the notes of another session are other notes, though they have the same numbers', () => {
  const note = {number: 1, at_s: 1, text: 'x', who: 'Ada', written: '2026-03-01T12:00:00Z'};
  assert.equal(keyOf([note]), keyOf([{...note}]));
  assert.notEqual(keyOf([note]), keyOf([{...note, written: '2026-03-01T12:00:01Z'}]));
});

test('the card says what is in effect and what it did', () => {
  const said = (changes) => networkRows(state(changes)).map(({name, value}) => `${name}: ${value}`);
  assert.deepEqual(said({}), ['In effect: lte', 'Packets: 1000, 0.8 % lost', 'Images: 90 of 100 arrived',
                              'too late: 4', 'lost: 6', 'Image delay: 31 ms']);
  assert.equal(said({changed: true})[0], 'In effect: lte, changed');
  assert.deepEqual(said({profile: 'none'}), ['In effect: none, as recorded']);
  assert.equal(said({packetsSent: 0n, packetsLost: 0n})[1], 'Packets: 0, 0 % lost');
});

test('a slider stands at the nearest of its values and says it with its unit', () => {
  for (const one of SLIDERS)
    for (const [at, value] of one.values.entries()) assert.equal(placeOf(one, value), at, `${one.field} ${value}`);
  assert.equal(slider('delay_ms').values[placeOf(slider('delay_ms'), 900)], 600);
  assert.equal(textOf(slider('rate_Mbit_per_s'), 0), 'unlimited');
  assert.equal(textOf(slider('burst_packets'), 1), '1 packet');
  assert.equal(textOf(slider('delay_ms'), 0.2), '0.2 ms');
});

test('a profile replaces what waits before it, numbers are joined', () => {
  assert.deepEqual(joined({profile: 'lte', delay_ms: 5}, {delay_ms: 7, loss_percent: 1}), {profile: 'lte', delay_ms: 7, loss_percent: 1});
  assert.deepEqual(joined({delay_ms: 5}, {profile: 'none'}), {profile: 'none'});
});

test('an address names a moment and a note', () => {
  const {search} = new URL(addressOfMoment('https://site.example/?view=doctor&note=1', 5, 17));
  assert.equal(search, '?view=qa&at_s=5.00&note=17');
  assert.equal(noteInAddress(search), 17);
  for (const wrong of ['', '?note=', '?note=-1', '?note=x', '?note=1e3']) assert.equal(noteInAddress(wrong), undefined, wrong);
  const [note] = readNotes({notes: [{number: 3n, atS: 1.5, text: '<b>', who: 'Ada', written: '2026-03-01T12:00:00Z'}]});
  assert.deepEqual(note, {number: 3, at_s: 1.5, text: '<b>', who: 'Ada', written: '2026-03-01T12:00:00Z'});
});

const PLAYER = {position_s: 9, playing: false, shown: {at_ms: 1000, at_s: 4, speed: 0.5}};
const PAGE = {pictureInstant_ms: 1000, picturePublished_ms: 1020, numbersInstant_ms: 1002};

test('the moment of a paused session is the shown picture\'s, and a seek to it shows that picture', () => {
  const {values_s, seek_s} = shownMoment(PLAYER, PAGE);
  assert.equal(values_s, 4);
  assert.ok(seek_s > 4.01 && seek_s < 4.0115, `behind the publication at half speed, at 4.01 s: ${seek_s}`);
});

test('while it plays, the moment is that of the picture on the screen, which is older than the player\'s newest', () => {
  assert.equal(shownMoment({...PLAYER, playing: true}, {...PAGE, pictureInstant_ms: 800, picturePublished_ms: 820}).values_s, 3.9);
});

test('until picture and player agree, the moment is the player\'s position', () => {
  assert.deepEqual(shownMoment(PLAYER, {...PAGE, pictureInstant_ms: 967}), {values_s: 9, seek_s: 9});
  assert.equal(shownMoment({...PLAYER, shown: undefined}, PAGE).values_s, 9);
});

test('in a session without images, the moment is that of the numbers', () => {
  const reading = {pictureInstant_ms: undefined, picturePublished_ms: undefined, numbersInstant_ms: 990};
  assert.equal(shownMoment(PLAYER, reading).values_s, 3.995);
  assert.equal(shownMoment(PLAYER, {...reading, numbersInstant_ms: 900}).values_s, 9);
});
