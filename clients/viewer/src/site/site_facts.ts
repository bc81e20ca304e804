import {type DepthFidelity, depthFidelity} from '../depth/depth_fidelity';
import {
  type CaptureStatus, type DepthImage, type HandHolder, Phase, type ServerStats, type StationEvent, type StationState,
  type SurfaceReport,
} from '../messages/generated';
import {NOBODY} from '../messages/nobody';
import {type ChangedStates, STATE_TOPICS, type StateTopic, type StateTopics} from '../messages/topics';
import type {News} from './worker_messages';

const LINK_SMOOTHING = 0.1;
const MOST_EVENTS = 32;  // the page takes them ten times a second

/**
 * Collects facts about the link and the patient's site from the messages. It uses no sockets and no clock: times are
 * arguments.
 */
export class SiteFacts {
  capture: CaptureStatus | undefined;
  lateTicks: number | undefined;
  untaken_ms: number | undefined;
  unopened: string | undefined;
  holder: HandHolder = NOBODY;
  stats: ServerStats | undefined;
  surfaceReport: SurfaceReport | undefined;
  events: StationEvent[] = [];

  private states: ChangedStates = {};
  private everConnected = false;
  private depth: DepthFidelity | undefined;
  private dropped = 0;
  private lastSequence: bigint | undefined;
  private station: StationState | undefined;
  private stationHeard_ms: number | undefined;
  private link_ms: number | undefined;
  private heard: News['heard'];
  private heardAny_ms: number | undefined;

  connected(): void {
    this.everConnected = true;
    this.lastSequence = undefined;  // frames missed without a connection are no drops of the link
    this.holder = NOBODY;
    this.station = this.stationHeard_ms = this.link_ms = this.heard = this.heardAny_ms = this.stats = this.surfaceReport = undefined;
    this.unopened = undefined;
    this.events = [];
    for (const topic of STATE_TOPICS) this.states[topic] = undefined;  // the server may be another one
  }

  stateCame<Topic extends StateTopic>(topic: Topic, message: StateTopics[Topic], published_ns: bigint): void {
    (this.states as {[Topic in StateTopic]?: unknown})[topic] = {message, published_ns};
  }

  /** The server no longer offers a topic to this visitor. */
  topicWent(topic: string): void {
    const state = STATE_TOPICS.find((one) => one === topic);
    if (state !== undefined) this.states[state] = undefined;
  }

  /** The states that have changed since the last call. */
  takeStates(): ChangedStates {
    const {states} = this;
    this.states = {};
    return states;
  }

  /** A message of any topic came. `published_ms` on this computer's clock; undefined while the session clock is unknown. */
  came(published_ms: number | undefined, now_ms: number): void {
    this.heardAny_ms = now_ms;
    if (published_ms === undefined) return;
    this.heard = {published_ms, received_ms: now_ms};
    const age_ms = now_ms - published_ms;
    this.link_ms = this.link_ms === undefined ? age_ms : this.link_ms + LINK_SMOOTHING * (age_ms - this.link_ms);
  }

  /** A depth image came. A gap in the sequence numbers means frames that were dropped on the way. */
  depthCame(image: DepthImage): void {
    const {sequence} = image;
    this.depth = depthFidelity(image);
    const last = this.lastSequence;
    if (last !== undefined && sequence > last) this.dropped += Number(sequence - last - 1n);
    this.lastSequence = sequence;
  }

  stationCame(state: StationState, now_ms: number): void {
    this.station = state;
    this.stationHeard_ms = now_ms;
  }

  eventCame(event: StationEvent): void {
    this.events.push(event);
    if (this.events.length > MOST_EVENTS) this.events.shift();
  }

  get news() {
    const {everConnected, link_ms, heard, capture, depth, stationHeard_ms, lateTicks, untaken_ms, holder, dropped} = this;
    const {stats, surfaceReport, events, heardAny_ms, unopened} = this;
    return {
      everConnected, link_ms, heard, heardAny_ms, capture, depth, stationHeard_ms, lateTicks, untaken_ms, holder, dropped,
      stats, surfaceReport, events, unopened,
      touching: this.station?.sender ?? 0,
      phase: this.station?.phase ?? Phase.UNSPECIFIED,
      surfaceStale: this.station?.surfaceStale ?? false,
    } satisfies Partial<News>;
  }
}
