// node layout_test.mjs VIEWER_SOURCES VIEWER_WORK: what a browser keeps of the layout, and what is spoken of the phase.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {KeptLayout} = await bundled('views/kept_layout.ts');
const {Voice} = await bundled('panel/voice.ts');
const {lookOf} = await bundled('words/phases.ts');
const [NO_STATION, IN_BODY, LIFT, OUT_BODY, , , , UPPER, RELEASED, FAULTED] = Array.from({length: 10}, (_, at) => at);

function store(text) {
  let kept = text;
  return {getItem: () => kept ?? null, setItem: (_, value) => (kept = value)};
}

test('each view keeps its own folded parts, also for the next page', () => {
  const kept = store();
  const layout = new KeptLayout(kept);
  layout.set('qa', 'Force', true);
  layout.set('qa', 'Force', true);
  layout.set('qa', 'Details', true);
  layout.set('qa', 'Details', false);
  const next = new KeptLayout(kept);
  assert.deepEqual([next.has('qa', 'Force'), next.has('qa', 'Details'), next.has('doctor', 'Force')], [true, false, false]);
});

test('a browser that keeps nothing, is full or kept something else folds for this page alone', () => {
  const full = {getItem: () => null, setItem: () => { throw new Error('full'); }};
  for (const broken of [undefined, full, store('no JSON'), store('{"qa": 3}'), store('null')]) {
    const layout = new KeptLayout(broken);
    assert.equal(layout.has('qa', 'Force'), false);
    layout.set('qa', 'Force', true);
    assert.equal(layout.has('qa', 'Force'), true);
  }
});

/** What is spoken of phases that begin at the given times [ms], looked at ten times a second until `end_ms`. */
function spoken(phases, end_ms) {
  const voice = new Voice();
  const said = [];
  for (let now_ms = 0; now_ms <= end_ms; now_ms += 100) {
    const [, phase] = phases.filter(([from_ms]) => from_ms <= now_ms).at(-1);
    const words = voice.ofPhase(lookOf(phase), now_ms);
    if (words !== undefined) said.push([now_ms, words.split(':')[0]]);
  }
  return said;
}

test('a phase is spoken when it has lasted and means something else', () => {
  assert.deepEqual(spoken([[0, OUT_BODY], [4000, IN_BODY], [9000, LIFT], [10_500, OUT_BODY]], 20_000),
      [[1000, 'Above the skin'], [5000, 'Pressing the skin'], [10_000, 'Lifting off']]);
});

test('a hand that palpates 29 times in 20 s is spoken of at most once in 3 s', () => {
  const phases = Array.from({length: 58}, (_, at) => [345 * at, at % 2 === 0 ? IN_BODY : OUT_BODY]);
  assert.deepEqual(spoken(phases, 20_000), []);
  const slower = Array.from({length: 16}, (_, at) => [1250 * at, at % 2 === 0 ? IN_BODY : UPPER]);
  assert.ok(spoken(slower, 20_000).length <= 7);
});

test('a fault is spoken at once, and a paused force is not a missing station', () => {
  assert.deepEqual(spoken([[0, IN_BODY], [1500, FAULTED]], 3000), [[1000, 'Pressing the skin'], [1500, 'Faulted']]);
  assert.deepEqual(spoken([[0, NO_STATION], [5000, RELEASED]], 9000), [[1000, 'No station'], [6000, 'Force paused']]);
});

test('a warning is spoken once, not each time that its running time changes or that it comes back soon', () => {
  const voice = new Voice();
  const said = [];
  for (let now_ms = 0; now_ms <= 20_000; now_ms += 100) {
    const shown = now_ms % 4000 < 3500 ? {level: 'warn', title: 'Stale picture', text: `${now_ms} ms`} : undefined;
    const words = voice.ofBanner(shown, now_ms);
    if (words !== undefined) said.push(words);
  }
  assert.deepEqual(said, ['Stale picture. 1000 ms']);
  assert.equal(voice.ofBanner({level: 'alarm', title: 'Disconnected', text: 'Trying again.'}, 20_050), 'Disconnected. Trying again.');
});
