// The page of the protocol: what the participant is told, and how mouse and keys move the hand.
import {Bench} from './bench.js';
import {openLink} from './link.js';

const MM_PER_PIXEL = 0.4;  // the same for all mechanisms and conditions
const KEY_MM_PER_S = 20;
const SLOW_MM_PER_S = 5;
const FULL_BAR_N = 4;
const KEYS = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1};
const CONDITIONS = {
  force: 'force alone: nothing is seen', vision: 'vision alone: no force is shown', both: 'both: needle and force',
};

const by = (id) => document.getElementById(id);
const bench = new Bench(by('bench'));
const field = by('field');
let state;
let pressed;  // id of the pointer that moves the hand
let moved = [0, 0];  // mm since the last message
const keys = new Map();  // held arrow keys, and whether they are slow
let drawnAt;

/** What a test sees. */
globalThis.protocol = {get state() { return state; }, frame: undefined, taken: false};

const send = openLink(hear, (name, text) => {
  const finished = state?.stage === 'finished';
  by('state').dataset.state = finished ? 'live' : name;
  by('state-text').textContent = finished ? 'finished' : text;
  if (name === 'lost') release();
}, 'telepalp-study protocol');

function hear(message) {
  if (message.kind === 'state') return show((state = message));
  if (message.kind === 'frame') return draw((globalThis.protocol.frame = message));
  if (message.kind === 'taken') return taken();
  by('refused').textContent = `${message.what}. ${message.fix}`;
  by('refused').hidden = false;
}

const moving = () => state?.stage === 'ready' || state?.stage === 'inserting';

function overshoot({what, through, stopped, overshoot: mm}) {
  if (what === 'broken-off') return 'Broken off: this penetration comes again.';
  if (!through) return 'The sac is still whole after 30 s.';
  return `${what === 'training' ? 'Training: ' : ''}${mm.toFixed(1)} mm overshoot${stopped ? '' : ', and the tip has not stopped'}`;
}

function task() {
  if (state.stage === 'finished') return 'Finished. Thank you. You can close this page.';
  if (state.stage === 'inserting') return 'Stop as soon as the sac gives way.';
  if (state.stage === 'ready' && state.device) return 'Hold the end-effector, and push it along the arrow.';
  if (state.stage === 'ready') return 'Press the mouse button in the field and move along the arrow, or hold →.';
  const {done, training, penetration, condition} = state;
  const part = training ? 'Training' : `Mechanism ${state.mechanism} of ${state.mechanisms}`;
  if (done === 0) return `Press Space when you are ready. It begins with ${training ? 'training' : 'the first mechanism'}, ${CONDITIONS[condition]}.`;
  return `${part}, penetration ${penetration}. Press Space when you are ready. A pause is possible.`;
}

function show() {
  const {stage, done, all, last, sees, feels} = state;
  field.dataset.stage = stage;
  by('told').textContent = last && !moving() ? overshoot(last) : '';
  by('told').dataset.what = last?.what ?? '';
  by('do').textContent = task();
  by('begin').disabled = stage !== 'resting';
  by('stop').disabled = !moving();
  by('done').textContent = `${done} of ${all}`;
  by('progress').max = all;
  by('progress').value = done;
  by('part').textContent = state.training ? 'training' : 'it counts';
  by('condition').textContent = CONDITIONS[state.condition];
  by('mechanism').textContent = state.training ? `${state.mechanism} of the training` : `${state.mechanism} of ${state.mechanisms}`;
  by('penetration').textContent = state.penetration;
  by('participant').textContent = state.participant;
  if (stage !== 'resting') by('refused').hidden = true;
  const hint = {resting: 'Space begins the next penetration', finished: 'Finished'}[stage] ?? (sees ? '' : 'In this condition nothing is seen: go by the force');
  by('unseen').textContent = hint;
  by('force').hidden = !feels;
  by('no-force').hidden = feels;
  by('how').closest('.card').hidden = state.device;
  by('field-note').textContent = moving() ? 'Esc lets go' : '';
  if (stage === 'resting' || stage === 'finished') rest();
}

function rest() {
  release();
  bench.clear();
  bar(0);
  globalThis.protocol.frame = undefined;
}

function draw(frame) {
  bench.draw(frame, state.stage === 'ready');
  if (frame.hand_N !== undefined) bar(frame.hand_N);
}

function bar(newtons) {
  by('bar-fill').style.width = `${Math.min(100, 100 * newtons / FULL_BAR_N)}%`;
  by('bar').setAttribute('aria-valuenow', Math.min(FULL_BAR_N, newtons).toFixed(2));
  by('force-N').textContent = `${newtons.toFixed(2)} N`;
}

function taken() {
  globalThis.protocol.taken = true;
  state = {...state, stage: 'taken'};
  rest();
  by('begin').disabled = by('stop').disabled = true;
  by('do').textContent = 'Another page has taken over. Load this page again to take over from it.';
}

function begin() {
  if (state?.stage !== 'resting') return;
  send('begin');
  field.focus({preventScroll: true});
}

function letGo() {
  if (moving()) send('stop');
  release();
}

function release() {
  pressed = undefined;
  moved = [0, 0];
  keys.clear();
}

/** Once in each picture: how far mouse and keys have moved the hand. */
function pump(now) {
  const passed_s = Math.min(0.05, (now - (drawnAt ?? now)) / 1000);
  drawnAt = now;
  if (moving()) {
    if (moved[0] !== 0 || moved[1] !== 0) send(`move ${moved[0].toFixed(3)} ${moved[1].toFixed(3)}`);
    let mm = 0;
    for (const [key, slow] of keys) mm += KEYS[key] * (slow ? SLOW_MM_PER_S : KEY_MM_PER_S) * passed_s;
    if (mm !== 0) send(`push ${mm.toFixed(4)}`);
  }
  moved = [0, 0];
  requestAnimationFrame(pump);
}
requestAnimationFrame(pump);

field.addEventListener('pointerdown', (event) => {
  if (!moving() || state.device || event.button !== 0) return;
  pressed = event.pointerId;
  field.setPointerCapture(pressed);
  field.focus({preventScroll: true});
  event.preventDefault();
});
field.addEventListener('pointermove', (event) => {
  if (event.pointerId !== pressed) return;
  moved = [moved[0] + MM_PER_PIXEL * event.movementX, moved[1] - MM_PER_PIXEL * event.movementY];
});
for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
  field.addEventListener(end, (event) => {
    if (event.pointerId === pressed) pressed = undefined;
  });
addEventListener('keydown', (event) => {
  if (event.key === 'Escape') return letGo();
  if (event.key === ' ' && !['BUTTON', 'A'].includes(event.target.tagName)) {
    event.preventDefault();
    return event.repeat ? undefined : begin();
  }
  if (KEYS[event.key] === undefined || !moving() || state.device) return;
  event.preventDefault();
  keys.set(event.key, event.shiftKey);
});
addEventListener('keyup', (event) => keys.delete(event.key));
addEventListener('blur', () => state?.device || letGo());  // a hand at a device needs no window in front
addEventListener('pagehide', letGo);
document.addEventListener('visibilitychange', () => {
  if (document.hidden && !state?.device) letGo();
});
by('begin').addEventListener('click', begin);
by('stop').addEventListener('click', letGo);
