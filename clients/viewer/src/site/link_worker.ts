// Reads the stream in a worker, so that a page that is busy with drawing does not delay it. Sends the page the newest
// instant on request.

import {TouchTaker} from '../calibration/touch_taker';
import {DepthDecoder} from '../depth/depth_decoder';
import {ProbeImages} from '../inside/probe_images';
import {WorkerCanvas} from '../inside/worker_canvas';
import {LeastAge} from '../link/least_age';
import {milliseconds, now_ms, SessionClock} from '../link/session_clock';
import {SilenceWatch} from '../link/silence_watch';
import {Stream} from '../link/stream';
import {isAtRest} from '../messages/capture_rest';
import type {CompressedImage, CompressedVideo, StationState} from '../messages/generated';
import {STATE_TOPICS, type StateTopic, type StateTopics, type Topics} from '../messages/topics';
import {ColorChoice, type ColorCoding} from '../present/color_choice';
import {ColorVideo, decodesVideo} from '../present/color_video';
import {DeviceWatch} from '../present/device_watch';
import {type Arrival, type Chosen, Instants} from '../present/instants';
import {LightMeter} from '../present/light_meter';
import {LONGEST_WAIT_MS} from '../present/presented_instant';
import {StationPast} from '../present/station_past';
import type {FrameTimes} from '../present/time_account';
import {SiteFacts} from './site_facts';
import type {FromWorker, News, ToWorker} from './worker_messages';

const KEY_FRAME_REQUEST_INTERVAL_MS = 500;
const UNOPENED = 'the recorded session is not opened:';

const clock = new SessionClock();
const facts = new SiteFacts();
let leastAge = new LeastAge();
const past = new StationPast();
const device = new DeviceWatch();
const taker = new TouchTaker((touches) => post({touches}));
let cameraMatrix: readonly number[] | undefined;
let waitEnds: ReturnType<typeof setTimeout> | undefined;
let ultrasound: WorkerCanvas | undefined;  // undefined until the page has sent it
let lightMeter: LightMeter | undefined;  // undefined: the present view does not show the light

const post = (message: FromWorker, transfer: Transferable[] = []) => postMessage(message, {transfer});

/** Session time on this computer's clock; undefined while the session clock is not known. */
const local_ms = (at_ns: bigint) => (clock.offset_ms === undefined ? undefined : milliseconds(at_ns) - clock.offset_ms);

function timesOf(arrival: Arrival | undefined): FrameTimes | undefined {
  if (arrival === undefined) return undefined;
  const [captured_ms, published_ms] = [local_ms(arrival.captured_ns), local_ms(arrival.published_ns)];
  if (captured_ms === undefined || published_ms === undefined) return undefined;
  return {captured_ms, published_ms, complete_ms: arrival.complete_ms ?? now_ms()};
}

async function bitmapOf(topic: string, jpeg: Uint8Array): Promise<ImageBitmap | undefined> {
  try {
    return await createImageBitmap(new Blob([jpeg.slice()], {type: 'image/jpeg'}));
  } catch (problem) {
    console.warn(`${topic}: ${String(problem)}`);
    return undefined;
  }
}

const probeImages = new ProbeImages(
    (jpeg) => bitmapOf('/station/ultrasound', jpeg), (image) => ultrasound?.draw(image), (probe) => post({probe}));

async function present({decoded, station, hand, late_ms, color, arrival, trail: touches}: Chosen): Promise<void> {
  const times = timesOf(arrival);
  const trail = touches.map((touch) => ({...touch, phase: past.phaseAt(touch.at_s)}));
  const compensation = station && past.compensationAt(station.stampNs);
  const numbers = {station, hand, late_ms, compensation, trail, times};
  if (decoded === undefined || arrival === undefined) return post({instant: {picture: undefined, ...numbers}});
  const bitmap = color && ('close' in color.data ? color.data : await bitmapOf('/camera/color', color.data));
  if (bitmap !== undefined) lightMeter?.measure(bitmap, now_ms());
  const picture = {...decoded, captured_ns: arrival.captured_ns, published_ns: arrival.published_ns, color: bitmap, cameraMatrix};
  const own: Transferable[] = [decoded.frame.samples.buffer as ArrayBuffer];
  post({instant: {picture, ...numbers}}, bitmap === undefined ? own : [...own, bitmap]);
}

/** Requests key frames of `topic`, at most one in each KEY_FRAME_REQUEST_INTERVAL_MS. */
function keyFrameRequest(topic: keyof Topics): () => void {
  let requested_ms = 0;
  return () => {
    if (now_ms() - requested_ms < KEY_FRAME_REQUEST_INTERVAL_MS) return;
    requested_ms = now_ms();
    stream.subscribeAgain(topic);
  };
}

const decoder = new DepthDecoder((decoded) => instants.decoded(decoded), () => instants.undecodable());
const instants = new Instants({
  now_ms,
  decode: ({bytes}) => decoder.decode(bytes),
  present: (chosen) => void present(chosen),
  requestKeyFrame: keyFrameRequest('/camera/depth'),
});

const colorChoice = new ColorChoice();
let viewTopics: readonly (keyof Topics)[] = [];  // topics on request that the present view needs
const chooseTopics = () => stream.setExtraTopics([...viewTopics, ...colorChoice.topics]);

const video = new ColorVideo({
  picture: (data, captured_ns) => instants.colorCame({data, captured_ns}),
  needsKeyFrame: keyFrameRequest('/camera/color/video'),
});

function askForColor(asked: ColorCoding): void {
  colorChoice.asked = asked;
  colorChoice.restart();
  chooseTopics();
  if (!colorChoice.topics.includes('/camera/color/video')) video.restart();
}

/** Capture time of the picture, or its publishing time if the server does not state the capture time. */
function takenAt({timestamp}: CompressedImage | CompressedVideo, published_ns: bigint): bigint {
  return timestamp === undefined ? published_ns : timestamp.seconds * 1_000_000_000n + BigInt(timestamp.nanos);
}

let silenceTimer: ReturnType<typeof setTimeout> | undefined;
const silence = new SilenceWatch({
  now_ms,
  setTimer: (call, after_ms) => {
    clearTimeout(silenceTimer);
    silenceTimer = setTimeout(call, after_ms);
  },
  changed: () => post({news: news()}),
});

function stationCame(state: StationState): void {
  facts.stationCame(state, now_ms());
  past.stateCame(state);
  device.stateCame(state);
  taker.stateCame(state);
  instants.stationCame(state);
}

let toldStates = false;  // since the page's last request
function stateCame<Topic extends StateTopic>(topic: Topic, message: StateTopics[Topic], published_ns: bigint): void {
  facts.stateCame(topic, message, published_ns);
  if (!toldStates) post({news: news()});
  toldStates = true;
}

type StateReaders = {[Topic in StateTopic]: (state: StateTopics[Topic], published_ns: bigint) => void};
const readerOf = <Topic extends StateTopic>(topic: Topic) => [
  topic, (state: StateTopics[Topic], published_ns: bigint) => stateCame(topic, state, published_ns),
];
const stateReaders = () => Object.fromEntries(STATE_TOPICS.map(readerOf)) as StateReaders;

const stream = new Stream(
    `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/stream${self.name}`,  // the page gave its own session as the worker's name
    {
      '/clock': () => undefined,  // one message a second: the stream treats silence as a lost connection
      '/camera/depth': (image, published_ns) => {
        facts.depthCame(image);
        if (colorChoice.depthCame()) chooseTopics();
        silence.imageCame();
        const captured_ms = local_ms(image.capturedNs);
        if (captured_ms !== undefined) leastAge.note(now_ms() - captured_ms, now_ms());
        instants.depthCame({bytes: image.data, captured_ns: image.capturedNs, published_ns});
        clearTimeout(waitEnds);
        waitEnds = setTimeout(() => instants.timePassed(), LONGEST_WAIT_MS + 1);
      },
      '/camera/color': (image, published_ns) => {
        colorChoice.colorCame();
        instants.colorCame({data: image.data, captured_ns: takenAt(image, published_ns)});
      },
      '/camera/color/video': (image, published_ns) => {
        colorChoice.colorCame();
        video.came(image.data, takenAt(image, published_ns));
      },
      '/camera/info': ({K}) => {
        cameraMatrix = K.length === 9 ? K : undefined;
      },
      '/camera/status': (capture) => {
        facts.capture = capture;
        silence.rest(isAtRest(capture));
      },
      '/station/state': stationCame,
      '/station/stats': (stats) => {
        facts.lateTicks = Number(stats.deadlinesMissed);
        taker.inUse = stats.hapticFromTracker;
      },
      '/station/compensation': (compensation) => past.compensationCame(compensation),
      '/station/surface': (report) => {
        facts.surfaceReport = report;
      },
      '/station/ultrasound': (image) => probeImages.came(image),
      '/station/inside': (inside) => post({inside}),
      '/station/events': (event) => facts.eventCame(event),
      '/server/stats': (stats) => {
        facts.stats = stats;
      },
      '/viewer/hand_holder': (holder) => {
        facts.holder = holder;
      },
      ...stateReaders(),
    },
    {
      publishes: ['/viewer/hand'],
      onRequest: [
        '/camera/color', '/camera/color/video',
        '/station/compensation', '/station/surface', '/station/events', '/station/ultrasound', '/station/inside',
        '/playback/network', '/playback/comparison', '/recording', '/sessions', '/source', '/exposure', '/people',
      ],
    },
    {
      connected: () => {
        clock.restart();
        facts.connected();
        past.forget();
        device.forget();
        taker.inUse = undefined;
        instants.restart();
        video.restart();
        colorChoice.restart();
        chooseTopics();
        silence.restart();
        leastAge = new LeastAge();
      },
      warned: (text) => {
        console.warn('server:', text);
        if (text.startsWith(UNOPENED)) facts.unopened = text.slice(UNOPENED.length).trim();
        if (text.includes('follows the hand of a viewer')) facts.untaken_ms = now_ms();
      },
      withdrawn: (topic) => facts.topicWent(topic),
      heard: (published_ns) => facts.came(local_ms(published_ns), now_ms()),
    });

function news(): News {
  return {
    ...facts.news,
    at_ms: now_ms(),
    connected: stream.connected,
    retryAt_ms: stream.retryAt_ms,
    viewer: stream.viewer,
    role: stream.role,
    may: stream.may,
    states: facts.takeStates(),
    light: lightMeter?.light,
    taking: taker.inUse && taker.taking,
    offset_ms: clock.offset_ms,
    clockError_ms: clock.error_ms,
    silentSince_ms: silence.since_ms,
    silenceLimit_ms: silence.limit_ms,
    imageGap_ms: silence.usual_ms,
    leastAge_ms: leastAge.value_ms,
    motion: device.motion,
    waiting: timesOf(instants.waiting),
    overtaken: instants.overtaken,
    undecodable: stream.undecodable + decoder.undecodable + video.undecodable,
    colorSaid: colorChoice.said,
  };
}

onmessage = ({data}: MessageEvent<ToWorker>) => {
  if ('hand' in data) stream.publish('/viewer/hand', data.hand);
  else if ('extra' in data) {
    viewTopics = data.extra.topics;
    chooseTopics();
    lightMeter = data.extra.light ? lightMeter ?? new LightMeter() : undefined;
  }
  else if ('ultrasound' in data) ultrasound = new WorkerCanvas(data.ultrasound);
  else if ('color' in data) askForColor(data.color);
  else if ('takePlace' in data) taker.take(data.takePlace);
  else if (data.ask === 'instant') instants.ask();
  else if (data.ask === 'probe') probeImages.ask();
  else {
    toldStates = false;
    post({news: news()});
  }
};

chooseTopics();
void decodesVideo().then((offered) => {
  colorChoice.offered = offered;
  chooseTopics();
});
clock.start();
instants.ask();  // for the page, whose own requests wait until its large script has run
post({news: news()});
