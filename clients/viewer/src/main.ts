import {offerAnchor} from './anchor_button';
import {wireControls} from './controls';
import {MarkButton, shownAgo_s} from './mark_button';
import {type MarkCommand, SayBar} from './said/say_bar';
import {ViewerHandInput} from './touch/viewer_hand';
import {offerHeadset} from './headset_button';
import {measureHeight} from './page/layout';
import {browserStore, later} from './page/page';
import {ServerResources} from './link/server_resources';
import {now_ms} from './link/session_clock';
import {SiteLink} from './site/site_link';
import type {Extra} from './site/worker_messages';
import {DoctorPanel} from './panel/doctor/doctor_panel';
import {QaPanel} from './panel/qa/qa_panel';
import {element} from './page/page';
import {SessionsCard} from './panel/sessions_card';
import {Readouts} from './panel/readouts';
import {TechnicianPanel} from './panel/technician/technician_panel';
import {EXPOSURE} from './panel/technician/exposure_card';
import type {MarksState, PeopleState, RoomVoiceState} from './messages/generated';
import type {PeopleCommand} from './panel/technician/people_card';
import {readSource, type SourceCommand, type SourceState} from './panel/technician/source_card';
import {readRecording, type RecordingCommand, type RecordingState} from './panel/technician/recording_state';
import {type ComparisonCommand, type ComparisonState, readComparison} from './playback/comparison_state';
import {joined, type NetworkCommand, type NetworkState, readNetwork} from './playback/network_state';
import {OverviewBand} from './playback/overview_band';
import {PLAYBACK} from './playback/playback_state';
import {openingShare, readSessions} from './playback/recorded_sessions';
import {type Note, type NoteCommand, readNotes} from './playback/session_notes';
import {readOverview} from './playback/session_overview';
import {TimelineBar} from './playback/timeline_bar';
import {InsideView} from './inside/inside_view';
import {ColorSwitch} from './color_switch';
import type {Instant} from './present/instant';
import {showInstant} from './scene/show_instant';
import {SceneView} from './scene/scene_view';
import {publishStatus} from './status';
import {ThemeSwitch} from './theme';
import {type Reading, ViewerState} from './state/viewer_state';
import {HandSteering} from './touch/hand_steering';
import {Details} from './views/details';
import {FoldingCards} from './views/folding_cards';
import {KeptLayout} from './views/kept_layout';
import type {View} from './views/view';
import {ViewSwitch} from './views/view_switch';
import {sideOf, VoiceButton} from './voice_button';

const READOUTS_EVERY_MS = 100;
/** What only one view shows. */
const EXTRA: Record<View, Extra> = {
  doctor: {
    topics: ['/station/compensation', '/station/surface', '/station/ultrasound', '/station/inside'],
    light: false,
  },
  technician: {topics: ['/recording', '/sessions', '/source', '/exposure', '/people', '/room_voice'], light: true},
  qa: {topics: ['/station/events', '/playback/network', '/playback/comparison', '/sessions'], light: false},
};

/** No new picture, and no values: those of a station that is silent are not shown. */
const WITHOUT_STATION: Instant =
    {picture: undefined, station: undefined, hand: 'none', late_ms: undefined, trail: [], times: undefined};

const state = new ViewerState();
const readouts = new Readouts();
const canvas = document.getElementById('scene') as HTMLCanvasElement;
const view = openView();
if (new URLSearchParams(location.search).get('mesh') === 'off') view.surface.hide();  // for tests/bench/viewer/viewer_bench.mjs
const viewerHand = new ViewerHandInput(view, canvas, (hand) => link.publishHand(hand));
const steering = new HandSteering(canvas, () => viewerHand.held, () => document.getElementById('hold-hand')?.click());
viewerHand.steering = steering;
element('rearm').addEventListener('click', () => viewerHand.rearm());
element('accept-object').addEventListener('click', () => viewerHand.acceptObject());
view.headset.onHand = (at) => (viewerHand.tracked = at);

function openView(): SceneView {
  try {
    return new SceneView(canvas);
  } catch (problem) {
    readouts.showBanner({level: 'alarm', title: 'No 3D in this browser', text: 'This browser has no WebGL 2: use another browser, or a newer version.'});
    throw problem;
  }
}

let coming: Instant | undefined;   // in the scene, but not drawn yet
let drawing: Instant | undefined;  // being drawn
let last: Instant | undefined;     // drawn last
let withHand = false;  // the first drawings have no hand: its shape and shaders take 0.3 s without a graphics card

const resources = new ServerResources();
const playback = resources.at('/playback', PLAYBACK);
const parts = {
  notes: resources.at<'/playback/notes', Note[], NoteCommand>('/playback/notes', {read: readNotes}),
  network: resources.at<'/playback/network', NetworkState, NetworkCommand>('/playback/network', {read: readNetwork, join: joined}),
  comparison: resources.at<'/playback/comparison', ComparisonState, ComparisonCommand>(
      '/playback/comparison', {read: readComparison, join: (_, next) => next}),
};
const source = resources.at<'/source', SourceState, SourceCommand>('/source', {read: readSource});
const exposure = resources.at('/exposure', EXPOSURE);
const asItIs = {read: <State>(state: State) => state};
const marks = resources.at<'/marks', MarksState, MarkCommand>('/marks', {...asItIs, mostWaiting: 3});
const recording = resources.at<'/recording', RecordingState, RecordingCommand>('/recording', {read: readRecording});
const people = resources.at<'/people', PeopleState, PeopleCommand>('/people', asItIs);
const room = resources.at<'/room_voice', RoomVoiceState, {open: boolean}>('/room_voice', asItIs);
const laterCards = () => later<typeof import('./panel/technician/later_cards')>('later_cards.js');
people.onChange(() => people.state && laterCards().then(({showPeople}) => showPeople(people) && cards.look()));
room.onChange(() => room.state && laterCards().then(({showRoomVoice}) => showRoomVoice(room) && cards.look()));
const link = new SiteLink({
  instant: (instant) => {
    coming = instant;
    state.taken(instant);
    status.decode_ms = instant.picture?.decode_ms ?? status.decode_ms;
    showInstant(view, withHand ? instant : {...instant, hand: 'none'});
  },
  news: (news) => {
    const changed = state.newsCame(news);
    resources.connected(news.connected);
    resources.changed(news.states, news.may);
    viewerHand.showHolder(news.holder, news.viewer);
    if (changed) showReadings();
  },
  probe: (probe) => inside.showProbe(probe, performance.now()),
  inside: (structures) => inside.showStructures(structures),
  touches: (touches) => technician.addTouches(touches),
});
const inside = new InsideView(view, () => link.ask('probe'), (canvas) => link.drawUltrasoundOn(canvas));

const read = () => {
  state.holdsHand = viewerHand.held;
  state.pointerRests = viewerHand.pointerRests;
  state.paused = playback.state?.playing === false;
  return state.read(now_ms());
};

view.onDraw = () => {
  drawing = coming ?? drawing;
  coming = undefined;
};
view.onShown = () => {
  if (coming === undefined) link.ask('instant');  // the next picture is decoded while this one is presented
  if (drawing === undefined) return;
  state.shown(drawing, now_ms());
  readouts.addTrail(drawing.trail);
  readouts.showNumbers(read());
};
view.onDrawn = () => {
  if (drawing !== undefined) state.drawn(drawing, now_ms());
  if (last === undefined && drawing !== undefined) setTimeout(addHand, 100);
  last = drawing ?? last;
  drawing = undefined;
};
function addHand(): void {
  withHand = true;
  const newest = coming ?? last;
  if (newest !== undefined) showInstant(view, {...newest, picture: undefined});
}
view.onGraphics = (lost) => (state.graphicsLost = lost);
view.onFree = () => {
  if (coming === undefined) link.ask('instant');
};

const anchor = offerAnchor(
    view, () => (coming ?? drawing ?? last)?.station,
    (problem) => readouts.showNotice({level: 'warn', title: 'Headset', text: problem}));
const status = publishStatus(() => ({
  ...read(),
  meshVertices: view.drawnVertices,
  handPosition: view.hand.mesh.visible ? view.hand.mesh.position.toArray() : undefined,
  drawn_ms: view.drawn_ms,
  coarseness: view.coarseness,
  view: views.view,
  probeImages: inside.imagesShown,
  innerTriangles: view.inner.triangles,
  anchor: anchor(),
  voice: voice.counts,
}));

const technician = new TechnicianPanel(view, canvas, {recording, source, exposure}, (place) => link.takePlace(place));
const sessions = new SessionsCard();
const whole = new OverviewBand(playback, parts.notes);
resources.on('/reading', (newest) => (state.opening = newest && openingShare(newest.message)));
resources.on('/sessions', (newest) => sessions.know(newest && readSessions(newest.message)));
resources.on('/playback/events', (newest) => whole.know(newest && readOverview(newest.message)));
const panels: Record<View, {show: (reading: Reading) => void}[]> = {
  doctor: [new DoctorPanel()],
  technician: [technician],
  qa: [new QaPanel(playback, whole, parts, view, () => coming ?? drawing ?? last)],
};
const layout = new KeptLayout(browserStore());
const [cards, details] = [new FoldingCards(layout), new Details(layout)];
const views = new ViewSwitch((chosen) => {
  link.setExtra(EXTRA[chosen]);
  cards.show(chosen);
  details.show(chosen);
});
const pictureAge_s = () => {
  const {pictureInstant_ms, sessionNow_ns} = read();
  return shownAgo_s(pictureInstant_ms, sessionNow_ns);
};
const markButton = new MarkButton(
    marks, pictureAge_s,
    (text) => readouts.showNotice({level: 'warn', title: 'The moment is not marked', text}));
const voice = new VoiceButton(
    () => sideOf(read().role, views.view, playback.state !== undefined), (text) => readouts.showNotice({level: 'warn', title: 'Voice', text}), pictureAge_s);
const sayBar = new SayBar(
    marks, canvas, (x, y) => view.placeUnder(x, y), (places) => view.showPointed(places),
    (text) => readouts.showNotice({level: 'warn', title: 'Nothing is said', text}));
wireControls(view, viewerHand, views, new ThemeSwitch(view), inside, {details, cards, markButton, sayBar, voice});
new TimelineBar(playback);
const colorSwitch = new ColorSwitch(browserStore(), (coding) => link.askForColor(coding));
void offerHeadset(view, (problem) => readouts.showNotice({level: 'warn', title: 'Headset', text: problem}));
measureHeight('tools', '--tools');
measureHeight('readings', '--readings');
measureHeight('banner', '--banner-height');
measureHeight('head', '--head');
link.ask('instant');
link.ask('probe');

/** Shows the newest readings. Hand and force of a silent station leave the picture together with its numbers. */
function showReadings(): Reading {
  const reading = read();
  if (reading.station === undefined && reading.handInstant_ms !== undefined && coming === undefined) {
    coming = WITHOUT_STATION;
    showInstant(view, coming);
  }
  if (reading.unsteady !== undefined) viewerHand.endPress();
  readouts.show(reading);
  return reading;
}

window.setInterval(() => {
  link.ask('news');
  const reading = showReadings();
  views.setRole(reading.role);
  voice.showFor(reading.role);
  sayBar.show(reading.sessionNow_ns, markButton.mayMark);
  steering.feel(reading.force_N);
  readouts.showDetail(view.detail);
  colorSwitch.show(reading.colorSaid);
  inside.look(performance.now());
  for (const panel of panels[views.view]) panel.show(reading);
}, READOUTS_EVERY_MS);
