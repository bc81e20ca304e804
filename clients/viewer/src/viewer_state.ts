import {type DepthTold, depthTold} from './depth/depth_told';
import {type CaptureStatus, type DepthImage, Phase, type StationState, type Vec3} from './link/messages';
import type {SessionClock} from './link/session_clock';
import type {Health} from './panel/banner';
import {shownHand} from './panel/touch_advice';

const UNTAKEN_MS = 2500;

/** All that the page shows in words and numbers, at one instant. */
export interface Reading extends Health {
  force_N: number | undefined;
  indentation_mm: number | undefined;
  limited: boolean;
  depth: DepthTold | undefined;
  link_ms: number | undefined;
  fps: number;
  frames: number;
  dropped: number;
  lateTicks: number | undefined;
}

export const length = ({x, y, z}: Vec3) => Math.hypot(x, y, z);

/** Gathers what the messages say. No page, no sockets: `read` gives the whole of it at a time. */
export class ViewerState {
  capture: CaptureStatus | undefined;
  station: StationState | undefined;
  depth: DepthTold | undefined;
  lateTicks: number | undefined;
  everConnected = false;
  holdsHand = false;
  frames = 0;
  dropped = 0;

  private lastSequence: bigint | undefined;
  private shownAt_ms: number[] = [];
  private shownCaptured_ns: bigint | undefined;
  private stationHeard_ms: number | undefined;
  private link_ms: number | undefined;
  private untaken_ms: number | undefined;

  constructor(private readonly clock: SessionClock) {}

  connected(): void {
    this.everConnected = true;
    this.lastSequence = undefined;  // frames missed while away are not the link's drops
    this.station = undefined;
    this.stationHeard_ms = undefined;
    this.link_ms = undefined;
  }

  /** A depth image came. What the sequence skips was overtaken on the way. */
  depthCame(image: DepthImage, published_ns: bigint): void {
    const {sequence} = image;
    this.depth = depthTold(image);
    const last = this.lastSequence;
    if (last !== undefined && sequence > last) this.dropped += Number(sequence - last - 1n);
    this.lastSequence = sequence;
    this.measureLink(published_ns);
  }

  depthShown(captured_ns: bigint, now_ms: number): void {
    ++this.frames;
    this.shownCaptured_ns = captured_ns;
    this.shownAt_ms.push(now_ms);
    if (this.shownAt_ms.length > 120) this.shownAt_ms.shift();
  }

  stationCame(state: StationState, published_ns: bigint, now_ms: number): void {
    this.station = state;
    this.stationHeard_ms = now_ms;
    this.measureLink(published_ns);
  }

  /** The server says that no station takes the hand that is held here; it repeats this once a second. */
  handUntaken(now_ms: number): void {
    this.untaken_ms = now_ms;
  }

  read(now_ms: number, connected: boolean, retryAt_ms: number | undefined): Reading {
    const {station} = this;
    const heard = connected && station !== undefined;
    return {
      connected,
      everConnected: this.everConnected,
      retryIn_ms: retryAt_ms === undefined ? undefined : Math.max(0, retryAt_ms - now_ms),
      capture: this.capture,
      phase: heard ? station.phase : Phase.Unspecified,
      force_N: heard && station.forceN ? length(station.forceN) : undefined,
      indentation_mm: heard ? 1000 * station.indentationM : undefined,
      limited: heard && station.limited,
      depth: this.depth,
      handShown: heard ? shownHand(station) !== undefined : undefined,
      holdsHand: this.holdsHand,
      untaken: this.untaken_ms !== undefined && now_ms - this.untaken_ms < UNTAKEN_MS,
      surfaceStale: heard && station.surfaceStale,
      surface_ms: heard && station.surfaceCapturedNs !== 0n
          ? Number(station.stampNs - station.surfaceCapturedNs) / 1e6
          : undefined,
      station_ms: this.stationHeard_ms === undefined ? undefined : now_ms - this.stationHeard_ms,
      picture_ms: this.pictureAge_ms(now_ms),
      link_ms: connected ? this.link_ms : undefined,
      fps: this.shownAt_ms.filter((at_ms) => at_ms > now_ms - 1000).length,
      frames: this.frames,
      dropped: this.dropped,
      lateTicks: this.lateTicks,
    };
  }

  /** Since the exposure when the session clock is known, else since the picture was shown. */
  private pictureAge_ms(now_ms: number): number | undefined {
    const shown_ms = this.shownAt_ms[this.shownAt_ms.length - 1];
    if (shown_ms === undefined || this.shownCaptured_ns === undefined) return undefined;
    return this.clock.age_ms(this.shownCaptured_ns) ?? now_ms - shown_ms;
  }

  private measureLink(published_ns: bigint): void {
    const age_ms = this.clock.age_ms(published_ns);
    if (age_ms === undefined) return;
    this.link_ms = this.link_ms === undefined ? age_ms : this.link_ms + 0.1 * (age_ms - this.link_ms);
  }
}
