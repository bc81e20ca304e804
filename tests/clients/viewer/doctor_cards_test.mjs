// node doctor_cards_test.mjs VIEWER_SOURCES VIEWER_WORK: who is here, the way of a frame to the hand, what is compensated.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {presenceRows} = await bundled('panel/presence_rows.ts');
const {delayRows} = await bundled('panel/doctor/delay_rows.ts');
const {compensationRows} = await bundled('panel/doctor/compensation_rows.ts');

const nobody = {viewer: 0n, asking: []};
const subscriber = (name, sender = 0) => ({name, address: '192.0.2.7:5000', sender, sent: 0n, dropped: 0n, byDatagram: false});
const presence = (subscribers, touching, holder = nobody, me = 4n) => ({stats: {stampNs: 1n, topics: [], subscribers}, touching, holder, me, playsSession: false});
const valueOf = (rows, name) => rows.find((row) => row.name === name)?.value;

test('the station whose state comes holds the touch; another one is connected', () => {
  const rows = presenceRows(presence([subscriber('telepalp-station', 7), subscriber('telepalp-station', 8), subscriber('viewer')], 7));
  assert.deepEqual(rows.slice(0, 2).map(({value}) => value), ['holds the touch', 'connected']);
  assert.equal(valueOf(rows, 'Browser'), 'you');
});

test('the maker of Foxglove\'s views is no person', () => {
  const rows = presenceRows(presence([subscriber('views for Foxglove'), subscriber('viewer'), subscriber('viewer')], 0));
  assert.deepEqual(rows.map(({name}) => name), ['Browsers: 2']);
});

test('a station that only a session holds is played, and not connected', () => {
  const gone = presence([subscriber('viewer')], 1003);
  assert.equal(valueOf(presenceRows({...gone, playsSession: true}), 'Recorded station'), 'played');
  assert.equal(valueOf(presenceRows(gone), 'Recorded station'), undefined, 'a live station has left');
});

test('the hand in a browser is mine or another viewer\'s', () => {
  const held = (viewer) => valueOf(presenceRows(presence([subscriber('viewer')], 0, {viewer, asking: []})), 'Hand in a browser');
  assert.deepEqual([held(4n), held(5n), held(0n)], ['yours', 'viewer 5', undefined]);
});

test('the parts of a frame\'s way add up to the whole', () => {
  const rows = delayRows({capturedNs: 0n, encodedNs: 5_000_000n, receivedNs: 12_000_000n, decodedNs: 20_000_000n, touchableNs: 38_000_000n});
  assert.equal(rows[0].value, '38 ms');
  assert.deepEqual(rows.slice(1).map(({value}) => value), ['5.0 ms', '7.0 ms', '8.0 ms', '18.0 ms']);
  assert.equal(delayRows({capturedNs: 1n, touchableNs: 0n})[0].value, '–');
});

test('smooth skin that shows no slide is told of once, in the details, with what it means', () => {
  const still = {stampNs: 0n, support: 1, slewedM: 0, dampingN: 0};
  const object = {effect: 1, unseen: false, slideUnseen: true};
  const rows = compensationRows({...still, objects: [object, object]}, undefined).filter(({name}) => name === 'Inner objects');
  assert.deepEqual(rows.map(({value, level}) => [value, level]), [['up and down only', undefined]]);
  assert.match(rows[0].says, /smooth skin.*sideways/);
  for (const objects of [[], [{...object, slideUnseen: false}], [{...object, unseen: true}]])
    assert.equal(valueOf(compensationRows({...still, objects}, undefined), 'Inner objects'), undefined);
});

test('hand and skin are told with two standard deviations, and damping that acts is marked', () => {
  const still = {
    stampNs: 0n, handAgeS: 0.01, handCarriedM: 0.0042, handSigmaM: 0.0005, surfaceAgeS: 0.05, surfaceCarriedM: -0.00001,
    surfaceSigmaM: 0.0003, slewedM: 0, support: 1, shownOffsetM: 0.02, dampingN: 0, handExcessJ: 0.0011, driveJ: 0, objects: [],
  };
  const rows = compensationRows(still, {passivityJ: -0.00001});
  assert.equal(valueOf(rows, 'Hand predicted'), '4.2 ± 1.0 mm');
  assert.equal(valueOf(rows, 'Skin predicted'), '0.0 ± 0.6 mm');
  assert.equal(valueOf(rows, 'Display: energy balance'), '0.0 mJ');
  assert.equal(rows.find(({name}) => name === 'Damping').level, undefined);
  const drive = (driveJ) => compensationRows({...still, driveJ}, undefined).find(({name}) => name === 'Drive: work');
  assert.deepEqual([drive(0.11).level, drive(2.145).level, drive(-0.3).level], [undefined, 'warn', 'warn']);
  assert.equal(drive(2.145).value, '2145.0 mJ');
  const damped = compensationRows({...still, dampingN: 0.4, support: 0.5, slewedM: 0.002}, undefined);
  assert.equal(damped.find(({name}) => name === 'Damping').level, 'warn');
  assert.equal(valueOf(damped, 'Contact displayed'), '50 %');
  assert.equal(valueOf(damped, 'Skin, gradual change'), '+2.0 mm');
});

test('an uncertainty that is wider than the value is said, not a value of 0.0', () => {
  const lost = {
    stampNs: 0n, handAgeS: 2, handCarriedM: 0, handSigmaM: 0.0555, surfaceAgeS: 0.05, surfaceCarriedM: 0.00001,
    surfaceSigmaM: 0.0555, slewedM: 0, support: 1, shownOffsetM: 0, dampingN: 0, handExcessJ: 0, driveJ: 0, objects: [],
  };
  for (const name of ['Hand predicted', 'Skin predicted']) {
    const row = compensationRows(lost, undefined).find((one) => one.name === name);
    assert.deepEqual([row.value, row.level], ['unknown, ± 111 mm', 'warn']);
  }
});

test('no two rows of the page have one name', () => {
  const names = delayRows({capturedNs: 0n, encodedNs: 1n, receivedNs: 2n, decodedNs: 3n, touchableNs: 4n}).map(({name}) => name);
  const page = readFileSync(join(process.argv[2], 'index.html'), 'utf8');
  names.push(...[...page.matchAll(/<dt>([^<]+)</g)].map(([, name]) => name));
  assert.deepEqual(names.filter((name, at) => names.indexOf(name) !== at), []);
  assert.ok(names.includes('Network to station') && names.includes('Network to here'));
});

test('the delay of the device\'s loop is told where it is measured, and warned of where it softens the patient', () => {
  const still = {stampNs: 0n, support: 1, slewedM: 0, dampingN: 0, objects: [], stiffnessLimitNPerM: 400, effectsNPerM: 300};
  const row = (more) => compensationRows({...still, ...more}, undefined).find(({name}) => name === 'Device: loop delay');
  assert.equal(row({}), undefined);
  assert.deepEqual([row({loopDelayS: 0.001}).value, row({loopDelayS: 0.001}).level], ['1.0 ms', undefined]);
  const softened = row({loopDelayS: 0.001, effectsNPerM: 1200});
  assert.deepEqual([softened.value, softened.level], ['1.0 ms, at most 400 N/m', 'warn']);
  assert.match(softened.says, /asks for 1200 N\/m/);
});
