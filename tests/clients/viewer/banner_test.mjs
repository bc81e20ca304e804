// What the banner says first: node banner_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {bannerFor} = await bundled('panel/banner.ts');

const WELL = {
  connected: true, everConnected: true, retryIn_ms: undefined, capture: undefined, phase: 3, picture_ms: 60,
  account: {site: 10, network: 30, computer: 20}, late_ms: undefined, station_ms: 10, surfaceStale: false, surface_ms: 40,
  handShown: true, holdsHand: false, role: 'doctor', untaken: false, yields_s: undefined, graphicsLost: false, paused: false,
  stale: false, silence_ms: undefined, heardAny_ms: 10, unsteady: undefined,
};
const banner = (changes) => bannerFor({...WELL, ...changes});

test('all is well: no banner', () => assert.equal(banner({}), undefined));

for (const [place, says] of [['site', /^The picture is 2\.\d s old\. Patient’s site: .* 2\.0 s/],
                             ['network', /^The picture is 2\.\d s old\. Network: images need 2\.0 s/],
                             ['computer', /^The picture is 2\.\d s old\. This computer: .* 2\.0 s/]])
  test(`an old picture names the place where the time went: ${place}`, () => {
    const {title, text} = banner({stale: true, account: {...WELL.account, [place]: 2000}});
    assert.equal(title, 'Stale picture');
    assert.match(text, says);
  });

test('while the session clock is not known, an old picture blames nobody', () => {
  assert.equal(banner({stale: true, account: undefined, picture_ms: 1500}).text, 'The picture is 1.5 s old.');
});

test('numbers that are much older than the picture are a warning', () => {
  assert.match(banner({late_ms: 600}).text, /come 0\.6 s after the picture, and are not shown/);
  assert.equal(banner({late_ms: 300}), undefined);
});

test('a fault comes before a slow picture', () => {
  assert.equal(banner({phase: 9, stale: true, account: {...WELL.account, computer: 5000}}).title, 'Station faulted');
});

test('a fault is ended in the page by whoever moves the station\'s hand there, and else at its terminal', () => {
  const moves = {phase: 9, holdsHand: true};
  assert.equal(banner(moves).rearms, true);
  assert.doesNotMatch(banner(moves).text, /terminal/);
  for (const other of [{phase: 9}, {...moves, untaken: true}, {...moves, role: 'qa'}]) {
    assert.notEqual(banner(other).rearms, true, JSON.stringify(other));
    assert.match(banner(other).text, /telepalp-station rearm/);
  }
});

test('lost graphics are said, though numbers go on', () => {
  assert.equal(banner({graphicsLost: true}).title, 'No picture');
  assert.equal(banner({graphicsLost: true, phase: 9}).title, 'Station faulted');
});

test('an object over the touched place is said before that nothing is felt there', () => {
  const covered = banner({objectOverPlace: true, surfaceStale: true});
  assert.equal(covered.title, 'Something lies over the place');
  assert.match(covered.text, /remembered/);
  assert.match(covered.text, /lift 3 cm clear/);
  assert.equal(covered.acceptsObject, undefined, 'beside a device, nobody at this page sees its hand');
  assert.equal(banner({objectOverPlace: true, station_ms: 2000}).title, 'Station silent', 'an old word is no warning');
});

test('a hand that outran the exact part of the image is said before that nothing is felt there', () => {
  assert.equal(banner({handOutsideWindow: true, surfaceStale: true}).title, 'No exact depth at the hand');
  assert.equal(banner({handOutsideWindow: true, station_ms: 2000}).title, 'Station silent', 'an old word is no warning');
});

test('warm motors are announced seconds before they lower the force', () => {
  assert.match(banner({yields_s: 2.34}).text, /^In 2\.3 s /);
  assert.equal(banner({yields_s: 2.34}).title, 'The device is warm');
  assert.equal(banner({yields_s: 9}), undefined);
  assert.equal(banner({yields_s: 2.34, station_ms: 2000}).title, 'Station silent', 'an old word is no warning');
  assert.equal(banner({yields_s: 2.34, phase: 9}).title, 'Station faulted');
});

test('the picture of a paused session is paused, not stale', () => {
  const old = {account: {...WELL.account, site: 60_000}, silence_ms: 60_000};
  assert.equal(banner({...old, paused: true}).title, 'Paused');
  assert.equal(banner({...old, paused: true, graphicsLost: true}).title, 'No picture');
});

test('without a picture, a camera is waited for, and a played session says that it has none', () => {
  const from = (source) => banner({picture_ms: undefined, capture: {state: 0, source, detail: ''}}).title;
  assert.equal(from('openni2'), 'Waiting for the camera');
  assert.equal(from('session:run.mcap'), 'No picture');
});

test('a silence says whether anything else still comes, and its text changes once a second', () => {
  const silent = (silence_ms, heardAny_ms, station_ms) => banner({stale: true, silence_ms, heardAny_ms, station_ms}).text;
  assert.equal(silent(300, 290, 290), 'Nothing has come from the server. The picture is the last one received.');
  assert.equal(silent(3210, 3200, 3200), silent(3900, 3890, 3890));
  assert.match(silent(3210, 3200, 3200), /^Nothing has come from the server for 3 s\./);
  assert.equal(silent(300, 5, 5), 'No image has come. The connection works. The numbers go on.');
  assert.equal(silent(2500, 5, undefined), 'No image has come for 2 s. The connection works.');
});

test('a stopped server comes before warm motors', () => {
  assert.equal(banner({yields_s: 2.34, stale: true, silence_ms: 300}).title, 'Stale picture');
});

test('a device that swings, and a drive at its limit, are told to whom they concern', () => {
  const swing = {swing_mm: 5.6, hertz: 4.3};
  assert.equal(banner({unsteady: swing}).text, 'It swings by 6 mm, 4 times a second, and the hand rests. Take the hand off the device.');
  assert.match(banner({unsteady: swing, holdsHand: true}).text, /Your press is let go: release the button/);
  assert.equal(banner({unsteady: 'full drive'}).title, 'Drive at its limit');
  assert.equal(banner({unsteady: swing, stale: true, silence_ms: 300}).title, 'Stale picture');
});

test('who moves the hand in the page accepts an object there as skin; others lift clear of it', () => {
  const moves = {objectOverPlace: true, holdsHand: true};
  assert.equal(banner(moves).acceptsObject, true);
  assert.match(banner(moves).text, /This is skin now/);
  for (const other of [{...moves, untaken: true}, {...moves, role: 'qa'}])
    assert.equal(banner(other).acceptsObject, undefined, JSON.stringify(other));
});

test('other traffic on the line is said with what it leaves, after everything that is worse', () => {
  const shared = banner({lineLeft_B_per_s: 1.2e6});
  assert.equal(shared.title, 'Something else uses this line');
  assert.match(shared.text, /^About 9\.6 Mbit\/s are left for the station\./);
  assert.equal(banner({lineLeft_B_per_s: 1.2e6, phase: 9}).title, 'Station faulted');
  assert.equal(banner({lineLeft_B_per_s: 1.2e6, handShown: false}).title, 'No hand');
});
