import {wireControls} from './controls';
import {type DecodedDepth, DepthDecoder} from './depth/depth_decoder';
import {HeldHand} from './held_hand';
import type {CompressedImage, StationState} from './link/messages';
import {SessionClock} from './link/session_clock';
import {Stream} from './link/stream';
import {Readouts} from './panel/readouts';
import {shownHand} from './panel/touch_advice';
import {forceColor, FULL_SCALE_N} from './scene/force_color';
import {fromCamera} from './scene/frames';
import {SceneView} from './scene/scene_view';
import {publishStatus} from './status';
import {length, ViewerState} from './viewer_state';

const READOUTS_EVERY_MS = 100;

const clock = new SessionClock();
const state = new ViewerState(clock);
const readouts = new Readouts();
const canvas = document.getElementById('scene') as HTMLCanvasElement;
const view = openView();
const heldHand = new HeldHand(view, canvas, (hand) => stream.publish('/viewer/hand', hand));
let cameraMatrix: readonly number[] | undefined;
let decodingPicture = false;

function openView(): SceneView {
  try {
    return new SceneView(canvas);
  } catch (problem) {
    readouts.tell({level: 'alarm', title: 'No 3D here', text: 'This browser has no WebGL 2: use another, or a newer one.'});
    throw problem;
  }
}

function showDepth({frame, summary, decode_ms}: DecodedDepth, captured_ns: bigint): void {
  status.decode_ms = decode_ms;
  view.surface.showDepth(frame, summary, cameraMatrix);
  view.setHome(summary);
  view.invalidate();
  state.depthShown(captured_ns, performance.now());
}

/** The browser decodes beside the page; a picture that comes meanwhile is skipped, the next one is newer. */
async function showPicture({data}: CompressedImage): Promise<void> {
  if (decodingPicture) return;
  decodingPicture = true;
  try {
    view.surface.showPicture(await createImageBitmap(new Blob([data.slice()], {type: 'image/jpeg'})));
    view.invalidate();
  } catch (problem) {
    console.warn(`/camera/color: ${String(problem)}`);
  } finally {
    decodingPicture = false;
  }
}

function showStation(station: StationState): void {
  const force_N = station.forceN === undefined ? 0 : length(station.forceN);
  const color = forceColor(force_N);
  const proxy = station.proxyCamera && fromCamera(station.proxyCamera);
  const hand = shownHand(station);
  view.hand.show(hand && fromCamera(hand), station.indentationM);
  view.probe.show(
      {
        device: station.deviceCamera && fromCamera(station.deviceCamera),
        proxy,
        normal: station.normalCamera && fromCamera(station.normalCamera),
        force_N: station.forceCameraN && fromCamera(station.forceCameraN),
      },
      color);
  view.surface.setTouch(proxy, station.inBody ? 0.35 + 0.65 * Math.min(1, force_N / FULL_SCALE_N) : 0, color);
  view.invalidate();
  const at_s = Number(station.stampNs / 1000n) / 1e6;
  readouts.force.add(at_s, force_N);
  readouts.indentation.add(at_s, 1000 * station.indentationM);
}

const decoder = new DepthDecoder(showDepth, () => stream.subscribeAgain('/camera/depth'));
const stream = new Stream(
    `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/stream`,
    {
      '/clock': () => undefined,  // a word each second, though nothing else may happen: the stream listens for silence
      '/camera/depth': (depth, published_ns) => {
        state.depthCame(depth, published_ns);
        decoder.decode(depth.data, depth.capturedNs);
      },
      '/camera/color': (picture) => void showPicture(picture),
      '/camera/info': ({K}) => {
        cameraMatrix = K.length === 9 ? K : undefined;
      },
      '/camera/status': (capture) => {
        state.capture = capture;
      },
      '/station/state': (station, published_ns) => {
        state.stationCame(station, published_ns, performance.now());
        showStation(station);
      },
      '/station/stats': (stats) => {
        state.lateTicks = Number(stats.deadlinesMissed);
      },
    },
    ['/viewer/hand'],
    () => {
      clock.restart();
      state.connected();
    },
    (warning) => {
      console.warn('server:', warning);
      if (warning.includes('takes a hand')) state.handUntaken(performance.now());
    });

const read = () => {
  state.holdsHand = heldHand.held;
  return state.read(performance.now(), stream.connected, stream.retryAt_ms);
};
const status = publishStatus(() => ({
  ...read(),
  meshVertices: view.drawnVertices,
  handPosition: view.hand.mesh.visible ? view.hand.mesh.position.toArray() : undefined,
  undecodable: stream.undecodable + decoder.undecodable,
  overtaken: decoder.overtaken,
  drawn_ms: view.drawn_ms,
  coarseness: view.coarseness,
}));

clock.start();
wireControls(view, heldHand);
window.setInterval(() => readouts.show(read()), READOUTS_EVERY_MS);
