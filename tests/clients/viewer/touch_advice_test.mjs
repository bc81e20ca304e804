// When a hand is drawn, and what a user who wants to touch is told: node touch_advice_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {shownHand} = await bundled('present/shown_hand.ts');
const {touchAdvice} = await bundled('panel/touch_advice.ts');

const at = {x: 0, y: 0, z: 0.7};
const station = (stamp_ms, sampled_ms) => (
    {stampNs: BigInt(stamp_ms * 1e6), handSampledNs: BigInt(sampled_ms * 1e6), displayedHandCamera: at});

test('a hand is shown only while its tracker sees one', () => {
  assert.equal(shownHand(station(5000, 4990)), at);
  assert.equal(shownHand(station(5000, 5010)), at, 'sampled after the published tick');
  assert.equal(shownHand(station(5000, 4000)), undefined, 'a second ago');
  assert.equal(shownHand(station(5000, 0)), undefined, 'never');
});

test('Touch without a station that takes a hand says what to start', () => {
  const {title, text} = touchAdvice({handShown: true, holdsHand: true, untaken: true, role: 'local'});
  assert.equal(title, 'Touch reaches no station');
  assert.match(text, /deploy\/demo --hand browser.*--tracker browser/);
});

test('a visitor who may not touch is told so once Touch is on', () => {
  for (const role of ['viewer', 'technician', 'qa'])
    assert.equal(touchAdvice({handShown: undefined, holdsHand: true, untaken: false, role}).title, 'Only doctors may touch');
  assert.equal(touchAdvice({handShown: undefined, holdsHand: false, untaken: false, role: 'viewer'}), undefined);
});

test('without a hand the page says how to hold one; with one, or without a station, it is silent', () => {
  assert.match(touchAdvice({handShown: false, holdsHand: false, untaken: false, role: 'doctor'}).text, /press Touch/);
  assert.match(touchAdvice({handShown: false, holdsHand: true, untaken: false, role: 'doctor'}).text, /Move the pointer/);
  assert.equal(touchAdvice({handShown: true, holdsHand: true, untaken: false, role: 'doctor'}), undefined);
  assert.equal(touchAdvice({handShown: undefined, holdsHand: false, untaken: false, role: 'doctor'}), undefined);
});

test('an inner object that is not followed is told of, after all that matters more', () => {
  const well = {handShown: true, holdsHand: false, untaken: false, objectUnseen: false, unmodelled: false};
  assert.equal(touchAdvice(well), undefined);
  assert.equal(touchAdvice({...well, objectUnseen: true}).title, 'Inner object not seen');
  assert.equal(touchAdvice({...well, objectSlideUnseen: true}), undefined, 'smooth skin is no news: the details tell of it');
  assert.equal(touchAdvice({...well, objectUnseen: true, handShown: false}).title, 'No hand');
});

test('a patient who moves unlike before is told of, after the inner objects', () => {
  const moves = {handShown: true, holdsHand: false, untaken: false, objectUnseen: false, unmodelled: true};
  assert.equal(touchAdvice(moves).title, 'Unusual motion of the patient');
  assert.equal(touchAdvice({...moves, objectUnseen: true}).title, 'Inner object not seen');
});
