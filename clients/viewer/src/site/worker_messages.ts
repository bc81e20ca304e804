// Messages between page and link worker. The worker sends one message for each request of the page, so that no messages
// queue up for a busy page. Besides, it sends its news at once when the images stop or come
// again, and when a state of the server changes, but then at most once between two requests.

import type {Touch} from '../calibration/offset_fit';
import type {Taking} from '../calibration/touch_taker';
import type {DepthFidelity} from '../depth/depth_fidelity';
import type {
  CaptureStatus, HandHolder, InnerStructures, Phase, ServerStats, StationEvent, SurfaceReport,
} from '../messages/generated';
import type {ChangedStates, OwnTopics, Topics} from '../messages/topics';
import type {ColorCoding} from '../present/color_choice';
import type {DeviceMotion} from '../present/device_watch';
import type {Instant, Light} from '../present/instant';
import type {ProbeView} from '../present/probe_view';
import type {FrameTimes} from '../present/time_account';

/** The present state of the link and the patient's site. Times are on the clock of now_ms(). */
export interface News {
  at_ms: number;                  // when the worker wrote it
  connected: boolean;
  everConnected: boolean;
  retryAt_ms: number | undefined;
  offset_ms: number | undefined;  // of the session clock
  clockError_ms: number | undefined;  // bound on the error of offset_ms
  link_ms: number | undefined;    // from the server's sending to this computer, smoothed
  heard: {published_ms: number; received_ms: number} | undefined;
  heardAny_ms: number | undefined;     // when the newest message of any topic came; undefined: none on this connection
  silentSince_ms: number | undefined;  // when the last image came, while no newer one has come for too long for this path
  silenceLimit_ms: number;             // a longer silence is not explained by this path's gaps
  imageGap_ms: number | undefined;     // during 99 % of the time, the gap between images is shorter; undefined: not known yet
  leastAge_ms: number;                 // of an image on its arrival, in the last minute: what this path always needs
  waiting: FrameTimes | undefined;
  capture: CaptureStatus | undefined;
  depth: DepthFidelity | undefined;
  stationHeard_ms: number | undefined;
  phase: Phase;  // the newest phase, not that of the presented instant
  surfaceStale: boolean;
  motion: DeviceMotion;
  lateTicks: number | undefined;
  untaken_ms: number | undefined;  // when the server last reported that no station uses this viewer's hand
  unopened: string | undefined;    // why the server does not open this page's own session; undefined: it does
  holder: HandHolder;
  viewer: bigint;      // this page's number at the server; 0n until the server has sent it
  role: string;        // of this visitor at the server; empty until the server has sent it
  may: readonly string[];  // paths of the server's resources that this visitor may change
  states: ChangedStates;   // of the server's resources, since the news before
  stats: ServerStats | undefined;
  touching: number;    // number of the station whose state came last; 0: none
  surfaceReport: SurfaceReport | undefined;
  events: readonly StationEvent[];  // the latest, oldest first; only in views that show them
  light: Light | undefined;  // of a recent colour picture; only while it is inspected
  taking: Taking | undefined;  // of a calibration; undefined: the station's tracker needs none, or no station is known
  dropped: number;     // frames dropped on the way to this viewer
  overtaken: number;   // frames that this viewer skipped before decoding
  undecodable: number;
  colorSaid: string;   // which coding of colour the page takes, in one sentence; empty: pictures, the default
}

/** What only some views need: topics that are not always subscribed, and the brightness of the colour picture. */
export interface Extra {
  topics: readonly (keyof Topics)[];
  light: boolean;
}

export type Asked = 'instant' | 'news' | 'probe';
export type ToWorker = {ask: Asked} | {hand: OwnTopics['/viewer/hand']} | {extra: Extra} |
    {ultrasound: OffscreenCanvas} | {color: ColorCoding} | {takePlace: number | undefined};
/**
 * An answer to each request. The layers below the skin come without a request, once for a station; so do the touches of
 * a place once it is taken.
 */
export type FromWorker =
    {instant: Instant} | {news: News} | {probe: ProbeView} | {inside: InnerStructures} | {touches: Touch[]};
