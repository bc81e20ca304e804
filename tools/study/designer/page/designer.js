// The designer's page: joins the parts. All physics is computed by telepalp-study; the page draws.
import {axes, mark, polyline, svg} from './chart.js';
import {Comparison, fromAddress, toAddress} from './compare.js';
import {Drawing} from './drawing.js';
import {openLink} from './link.js';
import {lineOf, presets, same, short, Sliders} from './parameters.js';
import {SearchCard} from './search.js';

const RESTS_MS = 450;       // a linkage is judged after it has stayed the same for so long
const ADDRESS_MS = 300;     // browsers limit how often the address may change
const PUSH_RAD = 0.012;     // of the handle in each frame of a push
const MOST_TRACE = 6000;

const byId = (id) => document.getElementById(id);
const length = ([x, y]) => Math.hypot(x, y);
const DEGREE = Math.PI / 180;
const degrees = (rad) => `${(rad / DEGREE).toFixed(0)}°`;

const address = fromAddress(location.hash);
const firsts = presets();
let design;           // the survey of the linkage that the program has
let frame;
let trace = [];
let prediction;       // of the linkage as it is
let asked = false;    // the program has not yet answered the last design
let waiting = false;  // another design waits for that answer
let pushing = 0;      // +1 in, -1 out
let restTimer, addressTimer, drawTimer;
/** What tests see. */
window.designer = {get design() { return design; }, get frame() { return frame; }, get trace() { return trace; }, get prediction() { return prediction; }};

const send = openLink(hear, (state, text) => {
  byId('state').dataset.state = state;
  byId('state-text').textContent = text;
  asked = waiting = false;
  if (state === 'live') askDesign();
});
const drawing = new Drawing(byId('drawing'), (part, [x, y]) => send(`take ${part} ${x.toFixed(3)} ${y.toFixed(3)}`), aim,
                            (rad) => send(`turn ${rad.toFixed(6)}`));
const sliders = new Sliders(byId('sliders'), address.values ?? firsts[0].values, changed);
const comparison = new Comparison(address.kept, load, keepAddress);
const search = new SearchCard(() => sliders.values, send, load);

let aimed;  // the newest place of a dragged part; sent once for each frame of the screen
function aim(place) {
  if (!aimed) requestAnimationFrame(() => {
    send(`hand ${aimed[0].toFixed(3)} ${aimed[1].toFixed(3)}`);
    aimed = undefined;
  });
  aimed = place;
}

/** One design is under way at a time, so that a slider never runs ahead of the program. */
function askDesign() {
  if (asked) return void (waiting = true);
  asked = true;
  send(`design ${lineOf(sliders.values)}`);
}

function changed() {
  choosePreset();
  askDesign();
  keepAddress();
  pushing = 0;
  prediction = undefined;
  byId('predicting').value = 0;
  oldPrediction(true);
  clearTimeout(restTimer);
}

function load(values) {
  sliders.set(values);
  changed();
}

function keepAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, '', location.pathname + location.search + toAddress(sliders.values, comparison.kept)), ADDRESS_MS);
  byId('line').textContent = lineOf(sliders.values);
}

function choosePreset() {
  const found = firsts.findIndex(({values}) => same(values, sliders.values));
  byId('preset').value = String(found);
}

function hear(message) {
  ({design: hearDesign, frame: hearFrame, device: hearDevice, refused: hearRefused, predicting: hearPredicting, prediction: hearPrediction,
    searching: (state) => search.progress(state), found: (state) => search.found(state)})[message.kind]?.(message);
}

/** After the program's answer to a design. */
function answered() {
  asked = false;
  if (waiting) {
    waiting = false;
    askDesign();
  }
}

function hearDesign(message) {
  const first = design === undefined;
  design = message;
  trace = message.frame.trace.slice(-MOST_TRACE);
  byId('refused').hidden = true;
  drawing.survey(message);
  showFacts();
  showFrame(message.frame);
  if (first && !asked) return;  // the program's own first linkage
  answered();
  clearTimeout(restTimer);
  if (!prediction) restTimer = setTimeout(() => send('predict'), RESTS_MS);
}

function hearFrame(message) {
  for (const point of message.trace) trace.push(point);
  if (trace.length > MOST_TRACE) trace = trace.slice(-MOST_TRACE);
  const wasInside = frame.layers.sac === 'inside';
  showFrame(message);
  if (pushing > 0 && (message.dead_point || (!wasInside && message.layers.sac === 'inside'))) pushing = 0;
  if (pushing < 0 && -message.tip[1] < -5) pushing = 0;
  if (pushing !== 0) push();
}

/** A haptic device moves the linkage: the pointer and the arrow keys no longer do. */
function hearDevice({ours, trouble}) {
  drawing.atDevice = true;
  document.body.classList.toggle('at-device', ours);
  byId('turn-how').textContent = 'touch a part with the device, then press its button, or hold Space here, to grasp it';
  for (const id of ['push', 'back']) byId(id).disabled = true;
  byId('device').hidden = trouble === '';
  byId('device').textContent = trouble && `${trouble[0].toUpperCase()}${trouble.slice(1)}.`;
}

/** The space bar is the button of a device that has none. */
function pressSpace(event) {
  if (!drawing.atDevice || event.code !== 'Space' || event.repeat || event.target.matches?.('input, select, button')) return;
  event.preventDefault();
  send(`press ${event.type === 'keydown' ? 1 : 0}`);
}

function hearRefused(message) {
  if (message.of === 'search') return search.refused(message);
  if (message.of === 'prediction') {
    byId('prediction-note').textContent = `No prediction: ${message.what}. ${message.fix}.`;
    byId('predicting').value = 0;
    return;
  }
  byId('refused').hidden = false;
  byId('refused').textContent = `${message.what}. ${message.fix[0].toUpperCase()}${message.fix.slice(1)}. The drawing shows the last linkage that can be built.`;
  byId('prediction-note').textContent = 'No prediction: this linkage cannot be built.';
  answered();
}

function oldPrediction(old) {
  byId('overshoot').closest('.card').dataset.old = String(old);
  if (old && byId('overshoot').textContent !== '–') byId('prediction-note').textContent = 'For the linkage as it was.';
}

function hearPredicting({done, all}) {
  byId('predicting').value = done / all;
  byId('prediction-note').textContent = `Operator ${done + 1} of ${all} works` + (byId('overshoot').textContent === '–' ? '.' : '; the numbers are for the linkage as it was.');
}

function hearPrediction(message) {
  prediction = message;
  oldPrediction(false);
  byId('predicting').value = 1;
  const [mean, low, high] = message.overshoot;
  byId('overshoot').textContent = mean.toFixed(1);
  const scale = Math.max(20, 1.2 * high);
  const [bar, point] = byId('interval').children;
  bar.style.left = `${100 * low / scale}%`;
  bar.style.width = `${100 * (high - low) / scale}%`;
  point.style.left = `${100 * mean / scale}%`;
  facts(byId('prediction-facts'), [
    ['95 % interval', `${low.toFixed(1)} to ${high.toFixed(1)} mm`],
    ['largest force at the hand', `${message.hand[0].toFixed(2)} N (${message.hand[1].toFixed(2)} to ${message.hand[2].toFixed(2)})`],
    ['puncture noticed', `${(100 * message.noticed).toFixed(0)} %`],
  ]);
  byId('prediction-note').textContent = `${message.operators} simulated operators, each with an own body and tissue, 5 penetrations each.` +
      (message.failed > 0 ? ` In ${message.failed} the sac stayed whole.` : '');
}

function facts(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value]) => {
    const [term, said] = [document.createElement('dt'), document.createElement('dd')];
    term.textContent = name;
    said.textContent = value;
    return [term, said];
  }));
}

function showFacts() {
  const {reach} = design;
  const tips = reach.map(([, , , x, y]) => [x, y]);
  const depths = tips.map(([, y]) => -y);
  const inside = reach.filter(([link3, , , , y]) => y <= 0 && link3 <= design.sac_link3 + 0.02).map(([, , , x]) => x);
  const [shape, meaning] = design.grashof.split(': ');
  const mm = (value) => `${short(value, 0)} mm`;
  facts(byId('facts'), [
    ['Grashof', `${shape}: ${meaning}`],
    ['link 3 turns', design.whole_turn ? 'fully' : `${degrees(reach[0][0])} to ${degrees(reach.at(-1)[0])}`],
    ['dead points', design.whole_turn ? 'none' : 'at both ends'],
    ['tip reaches', `${mm(Math.max(0, -Math.min(...depths)))} above to ${mm(Math.max(...depths))} below the skin`],
    ['sideways, skin to sac', inside.length > 1 ? `${short(Math.max(...inside) - Math.min(...inside), 1)} mm` : '–'],
  ]);
}

function showFrame(next) {
  if (next.touched) next.hand_N = next.contact_N;  // a part that nobody holds pushes the hand by itself
  frame = next;
  const [needle, hand, depth] = [length(next.needle_N), length(next.hand_N), -next.tip[1]];
  byId('needle-N').textContent = needle.toFixed(2);
  byId('hand-N').textContent = hand.toFixed(2);
  byId('depth').textContent = Math.abs(depth).toFixed(1);
  byId('depth-word').textContent = depth >= 0 ? 'below the skin' : 'above the skin';
  for (const item of byId('layers').children) {
    item.dataset.state = next.layers[item.dataset.layer];
    item.lastElementChild.textContent = next.layers[item.dataset.layer];
  }
  const said = next.punctures.at(-1);
  const sentence = said
    ? `${said.layer[0].toUpperCase()}${said.layer.slice(1)} punctured at ${said.depth.toFixed(1)} mm: the force at the hand fell from ${said.before.toFixed(2)} to ${said.after.toFixed(2)} N.`
    : next.dead_point ? 'At a dead point: links 1 and 2 lie on one line, and link 3 turns no further.' : '';
  if (byId('puncture').textContent !== sentence) byId('puncture').textContent = sentence;
  drawing.pose(next);
  drawing.describe(next, `tip ${Math.abs(depth).toFixed(1)} mm ${depth >= 0 ? 'below' : 'above'} the skin, ${hand.toFixed(2)} newton at the hand`);
  drawTimer ??= requestAnimationFrame(drawCharts);
}

function drawCharts() {
  drawTimer = undefined;
  if (!design) return;
  const chart = byId('force-chart');
  const deepest = Math.max(design.sac_depth + 22, ...trace.map(([depth]) => depth + 4));
  const most = Math.max(1, ...trace.map(([, needle, hand]) => 1.1 * Math.max(needle, hand)));
  const scale = axes(chart, {least: -6, most: deepest, title: 'depth of the tip, mm'}, {least: 0, most, title: 'N'});
  mark(chart, scale, 0, 'skin');
  mark(chart, scale, design.sac_depth, 'sac');
  chart.append(polyline(trace.map(([depth, needle]) => [Math.max(depth, -6), needle]), scale, 'needle'),
               polyline(trace.map(([depth, , hand]) => [Math.max(depth, -6), hand]), scale, 'hand'),
               svg('circle', {class: 'now', r: 4, cx: scale.x(Math.max(-frame.tip[1], -6)), cy: scale.y(length(frame.hand_N))}));
  const gain = byId('gain-chart');
  const {reach} = design;
  const across = axes(gain, {least: reach[0][0] / DEGREE, most: reach.at(-1)[0] / DEGREE, title: 'angle of link 3, °'},
                      {least: 0, most: 1.08 * Math.max(0.5, ...reach.map((point) => point[5])), title: ''});
  mark(gain, across, design.sac_link3 / DEGREE, 'sac');
  gain.append(polyline(reach.map((point) => [point[0] / DEGREE, point[5]]), across, 'hand'));
  const nearest = reach.reduce((best, point) => (Math.abs(point[0] - frame.link3) < Math.abs(best[0] - frame.link3) ? point : best));
  gain.append(svg('circle', {class: 'now', r: 4, cx: across.x(frame.link3 / DEGREE), cy: across.y(nearest[5])}));
}

/** The next piece of a push, when the one before has arrived. */
function push() {
  send(`turn ${(pushing * PUSH_RAD * 0.5).toFixed(6)}`);
}

function setUp() {
  for (const type of ['keydown', 'keyup']) addEventListener(type, pressSpace);
  addEventListener('blur', () => drawing.atDevice && send('press 0'));
  const preset = byId('preset');
  preset.append(new Option('own values', '-1'), ...firsts.map(({name}, at) => new Option(name, String(at))));
  preset.addEventListener('change', () => firsts[Number(preset.value)] && load(firsts[Number(preset.value)].values));
  choosePreset();
  for (const layer of ['skin', 'muscle', 'sac']) {
    const item = document.createElement('li');
    item.dataset.layer = layer;
    const [name, state] = [document.createElement('b'), document.createElement('span')];
    name.textContent = layer;
    item.append(name, state);
    byId('layers').append(item);
  }
  for (const [id, way] of [['push', 1], ['back', -1]])
    byId(id).addEventListener('click', () => {
      pushing = way;
      push();
    });
  byId('renew').addEventListener('click', () => {
    pushing = 0;
    trace = [];
    send('renew');
  });
  byId('save').addEventListener('click', () => comparison.keep(sliders.values, prediction));
  byId('copy').addEventListener('click', () => navigator.clipboard?.writeText(lineOf(sliders.values)));
  new ResizeObserver(drawCharts).observe(byId('force-chart'));
  keepAddress();
}
setUp();
