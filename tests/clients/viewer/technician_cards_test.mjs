// node technician_cards_test.mjs VIEWER_SOURCES VIEWER_WORK: what is wrong with the picture, and what the network does.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {summarise, HISTOGRAM_BIN_M} = await bundled('depth/depth_summary.ts');
const {pictureRows} = await bundled('panel/technician/picture_problems.ts');
const {NetworkRates, subscriberRows} = await bundled('panel/technician/network_rows.ts');
const {lightOf} = await bundled('present/light_meter.ts');
const {depthColor} = await bundled('scene/depth_color.ts');
const {sourceSays} = await bundled('panel/technician/source_card.ts');
const {placeAt, valueAt} = await bundled('panel/technician/exposure_card.ts');

const [width, height] = [160, 120];
/** A picture whose pixels have the depth `depth_mm(column, row)`; 0 is a hole. */
function picture(depth_mm) {
  const samples = new Uint16Array(width * height);
  for (let row = 0; row < height; ++row)
    for (let column = 0; column < width; ++column) samples[row * width + column] = depth_mm(column, row);
  return {width, height, unit_m: 0.001, samples};
}
const GOOD = {mean: 130, clipped: 0};
const row = (rows, name) => rows.find((one) => one.name === name);
const rowsOf = (depth_mm, light = GOOD) => pictureRows(summarise(picture(depth_mm)), light, 30);
const flat = (column, row) => 900 + 2 * ((column + row) % 10);

test('a good picture has no problem', () => {
  for (const {name, level} of rowsOf(flat)) assert.equal(level, 'good', name);
});

test('holes are counted in the middle, where the patient is', () => {
  assert.equal(row(rowsOf((column, at) => (column % 3 === 0 ? 0 : flat(column, at))), 'Holes').level, 'alarm');
  assert.equal(row(rowsOf((column, at) => (column < 20 ? 0 : flat(column, at))), 'Holes').value, '0.0 %');
});

test('a picture of holes alone has no distance and no depth step', () => {
  const rows = rowsOf(() => 0);
  assert.deepEqual(['Distance', 'Depth step'].map((name) => row(rows, name).value), ['–', '–']);
});

test('too near and too far say which way to move the camera, and without a depth the row Holes is named', () => {
  assert.match(row(rowsOf(() => 400), 'Distance').says, /away/);
  assert.match(row(rowsOf(() => 2100), 'Distance').says, /nearer\.$/);
  assert.match(row(rowsOf(() => 0), 'Distance').says, /The middle is not measured: see Holes\.$/);
});

test('the depth step is the distance of levels that a disparity sensor leaves', () => {
  assert.equal(row(rowsOf((column) => 900 + 5 * (column % 9)), 'Depth step').value, '5.0 mm');
  assert.equal(row(rowsOf((column, at) => 900 + ((column + at) % 30)), 'Depth step').value, '1.0 mm');
});

test('a patient at the side is said to be there', () => {
  const at = (inside) => row(rowsOf((column, at) => (inside(column, at) ? 800 : 1200)), 'Framing').value;
  assert.equal(at((column) => column > 110 && column < 150), 'at the right');
  assert.equal(at((column, row) => row < 40), 'at the top');
  assert.equal(at((column, row) => Math.hypot(column - 80, row - 60) < 30), 'centred');
});

test('light: dark, bright, burnt out, and none', () => {
  const light = (value) => row(rowsOf(flat, lightOf(new Uint8ClampedArray(400).fill(value))), 'Light').value;
  assert.match(light(20), /too dark/);
  assert.match(light(120), /good/);
  assert.match(light(240), /too bright/);
  assert.equal(row(rowsOf(flat, {mean: 150, clipped: 0.3}), 'Overexposed').level, 'alarm');
  assert.equal(row(pictureRows(summarise(picture(flat)), undefined, 30), 'Light').value, 'no colour');
});

test('the histogram is of the whole picture and has its peak at the patient', () => {
  const {histogram} = summarise(picture(() => 810));
  assert.ok(Math.abs(histogram.reduce((sum, share) => sum + share, 0) - 1) < 1e-9);
  assert.equal(histogram[Math.floor(0.81 / HISTOGRAM_BIN_M)], 1);
});

test('near is bright and far is dark; a depth outside the range has the colour of its end', () => {
  const brightness = (share) => depthColor(share).match(/\d+/g).map(Number).reduce((a, b) => a + b);
  const shares = [0, 0.2, 0.4, 0.6, 0.8, 1];
  const sorted = shares.map(brightness).sort((a, b) => b - a);
  assert.deepEqual(shares.map(brightness), sorted);
  assert.equal(depthColor(-3), depthColor(0));
  assert.equal(depthColor(7), depthColor(1));
});

test('rates are those between two statistics; one of another server begins anew', () => {
  const stats = (second, images) => ({stampNs: BigInt(second) * 1_000_000_000n, subscribers: [], topics: [
    {topic: '/camera/depth', published: BigInt(images), sent: 0n, dropped: BigInt(images), bytes: BigInt(images) * 50_000n}]});
  const rates = new NetworkRates();
  assert.equal(rates.show(stats(10, 300))[0].value, '–');
  const rows = rates.show(stats(12, 360));
  assert.equal(row(rows, '/camera/depth').value, '12.00 Mbit/s');
  assert.equal(row(rows, '/camera/depth').says, '30.0 messages/s');
  assert.equal(row(rows, 'Dropped').level, 'warn');
  assert.deepEqual(rates.show(stats(12, 360)), rows, 'the same statistics change nothing');
  assert.deepEqual(rates.show(stats(1, 5)), rows, 'a restarted server counts from 0');
});

test('the card says what all see, what is on its way, and why it did not come', () => {
  const says = (more) => sourceSays({sources: [], present: 'synthetic', opening: '', read_share: 0, problem: '', ...more});
  assert.equal(says({}), 'All see synthetic.');
  assert.equal(says({opening: 'openni2:usb1'}), 'openni2:usb1 is being opened…');
  assert.equal(says({opening: 'session:a.mcap', read_share: 0.42}), 'session:a.mcap is being opened: 42 %');
  assert.equal(says({problem: 'no camera can be opened.'}), 'All still see synthetic. no camera can be opened.');
});

test('a slider reaches both ends of the camera\'s range, and each place leads back to itself', () => {
  for (const [least, most] of [[0.5, 33], [0.25, 16], [0, 65535]]) {
    for (let place = 0; place <= 100; ++place) assert.equal(placeAt(valueAt(place, least, most), least, most), place, `${place} of ${least} to ${most}`);
    assert.ok(Math.abs(valueAt(100, least, most) / most - 1) < 0.01);
  }
});

test('a subscriber whose line something else uses has a row with what is left', () => {
  const station = {name: 'telepalp-station', address: '10.0.0.2:5000', sent: 9n, dropped: 0n, byDatagram: true};
  assert.equal(subscriberRows({subscribers: [station]}).length, 1);
  const [, line] = subscriberRows({subscribers: [{...station, shareBPerS: 1.2e6}]});
  assert.deepEqual([line.name, line.value, line.level], ['its line', '9.6 Mbit/s left', 'warn']);
  assert.match(line.says, /^Something else uses this line/);
});

test('who sees the patient is one row for each key, whatever number of streams it has', async () => {
  const {peopleSay, readPeople} = await bundled('panel/technician/people_card.ts');
  const stream = (name, key, program) => ({name, role: 'viewer', key, program, from: '10.0.0.7:4711', since: '2026-11-27T10:00:00Z'});
  const state = readPeople({
    people: [stream('vera', '07', 'browser'), stream('vera', '07', 'telepalp-view'), stream('walt', '08', 'browser')],
    holdsTouch: 'anna', sentOut: [{...stream('eve', '09', ''), from: '', since: ''}], anchor: 'anchor time=…', alarm: '',
  });
  assert.deepEqual(state.present.map(({who, key}) => [who, key]), [['viewer vera (2)', '07'], ['viewer walt', '08']]);
  assert.match(state.present[0].says, /^browser from 10\.0\.0\.7:4711 since .*\ntelepalp-view from /);
  assert.deepEqual(state.sentOut.map(({who, key}) => [who, key]), [['viewer eve', '09']]);
  assert.equal(peopleSay(state), 'Doctor anna holds the touch.');
  assert.equal(peopleSay({...state, holdsTouch: ''}), 'Nobody holds the touch.');
  assert.equal(peopleSay({...state, alarm: 'the audit log was cut'}), 'Alarm: the audit log was cut');
});
