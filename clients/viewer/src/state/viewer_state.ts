import type {Taking} from '../calibration/touch_taker';
import type {DepthFidelity} from '../depth/depth_fidelity';
import type {DepthSummary} from '../depth/depth_summary';
import {milliseconds} from '../link/session_clock';
import {isAtRest, isPaused} from '../messages/capture_rest';
import {
  Phase, type StationCompensation, type StationEvent, type StationState, type SurfaceReport,
} from '../messages/generated';
import {NOBODY} from '../messages/nobody';
import {isOwnSwing} from '../present/device_watch';
import {forcesOf, type Instant, type Light} from '../present/instant';
import {shownHand} from '../present/shown_hand';
import {accountFor, type FrameTimes, type TimeAccount, total_ms, WorstOfSecond} from '../present/time_account';
import type {News} from '../site/worker_messages';
import type {Health, Unsteady} from './health';
import {lineLeft, type Presence, stationIsLive} from './presence';

const UNTAKEN_MS = 2500;
const STALE_MS = 1000;   // a picture that is older by this than its path always needs is stale; on an irregular path, by more
const DRAWING_MS = 400;  // to decode and draw without a graphics card
const SILENT_MS = 850;   // a station that sent nothing for this long counts as gone; the page shows it within 1 s
const OLD_NUMBERS_MS = 250;
const UNSTEADY_MS = 2000;
const AWAY_MS = 2500;     // a server sends a message each second

/** All texts and numbers that the page shows at one time. */
export interface Reading extends Health {
  force_N: number | undefined;  // of the contact; 0 while the device is driven
  drive_N: number | undefined;  // of the drive; 0 in contact
  torque_N_m: number | undefined;  // on the hand; undefined: the device gives none
  indentation_mm: number | undefined;
  limited: boolean;
  numbersOld: boolean;  // nothing newer has come from the station since the picture became stale
  silenceLimit_ms: number | undefined;  // images that come later than this are too late for this path
  imageGap_ms: number | undefined;      // during 99 % of the time, the gap between images is shorter; undefined: not known yet
  depth: DepthFidelity | undefined;
  link_ms: number | undefined;
  clockError_ms: number | undefined;  // bound on the error of ages that compare two computers' clocks
  fps: number;
  frames: number;
  dropped: number;
  undecodable: number;
  lateTicks: number | undefined;
  pictureInstant_ms: number | undefined;  // session time of the exposure that is drawn
  picturePublished_ms: number | undefined;  // session time at which the server sent it
  numbersInstant_ms: number | undefined;  // session time that force and numbers belong to
  handInstant_ms: number | undefined;     // session time of hand and force in the scene; undefined: they are hidden
  role: string;                           // of this visitor at the server; empty while it is not known
  presence: Presence;
  station: StationState | undefined;                // of the presented instant
  compensation: StationCompensation | undefined;    // of the presented instant
  surfaceReport: SurfaceReport | undefined;         // of the newest frame that the station has
  summary: DepthSummary | undefined;                // of the drawn depth
  events: readonly StationEvent[];                  // the latest, oldest first; only in views that show them
  sessionNow_ns: bigint | undefined;                // the session clock; undefined while it is not known
  light: Light | undefined;                         // only in views that show it
  cameraFrames_per_s: number;
  colorSaid: string;  // which coding of colour the page takes, in one sentence; empty: pictures, the default
  taking: Taking | undefined;  // of a calibration; undefined: there is no live station whose tracker needs one
}

/**
 * What to show after `told` was shown and `now` is seen. Of two swings: the newer one, with the larger of both widths.
 * A swing that was shown is kept when only a full drive is seen now, because a swing brings about a full drive.
 */
function withWidest(told: Unsteady | undefined, now: Unsteady): Unsteady {
  if (typeof told !== 'object') return now;
  if (typeof now !== 'object') return told;
  return {...now, swing_mm: Math.max(told.swing_mm, now.swing_mm)};
}

interface DrawnPicture {
  summary: DepthSummary;
  captured_ms: number;   // session time
  published_ms: number;  // session time
  times: FrameTimes | undefined;
  drawn_ms: number;
}

/**
 * The state of the viewer: the presented instant, the link and the patient's site. It uses neither the page nor
 * workers; `read` returns the whole state at one time.
 */
export class ViewerState {
  news: News | undefined;
  holdsHand = false;
  graphicsLost = false;
  pointerRests = false;  // true: the pointer that moves this page's hand rests
  paused = false;  // true: the played session is paused
  opening: number | undefined;  // as Health.opening
  frames = 0;

  private coming: Instant | undefined;  // taken by the page, not drawn yet
  private station: StationState | undefined;
  private compensation: StationCompensation | undefined;
  private picture: DrawnPicture | undefined;
  private hand_ms: number | undefined;
  private late_ms: number | undefined;
  private drawnAt_ms: number[] = [];
  private unsteady: {what: Unsteady; at_ms: number} | undefined;
  private readonly worst = new WorstOfSecond();

  /** Returns true if a silence of the images or of the station has begun or ended. */
  newsCame(news: News): boolean {
    const before = this.silences;
    this.news = news;
    return this.silences !== before;
  }

  /** The page has taken `instant` to draw it next. */
  taken(instant: Instant): void {
    this.coming = instant;
  }

  /** `instant` comes to the screen with the next screen refresh, so its numbers are shown, too. */
  shown(instant: Instant, now_ms: number): void {
    const {picture, station, hand, late_ms, compensation, times} = instant;
    if (this.coming === instant) this.coming = undefined;
    this.station = station;
    this.compensation = compensation;
    this.late_ms = late_ms;
    if (hand !== 'kept') this.hand_ms = hand === 'new' && station !== undefined ? milliseconds(station.stampNs) : undefined;
    if (picture === undefined) return;
    const {summary, captured_ns, published_ns} = picture;
    this.picture = {summary, captured_ms: milliseconds(captured_ns), published_ms: milliseconds(published_ns), times, drawn_ms: now_ms};
  }

  /** The picture of `instant` is on the screen. */
  drawn({picture}: Instant, now_ms: number): void {
    if (picture === undefined || this.picture === undefined) return;
    ++this.frames;
    this.picture.drawn_ms = now_ms;
    this.drawnAt_ms.push(now_ms);
    if (this.drawnAt_ms.length > 120) this.drawnAt_ms.shift();
  }

  read(now_ms: number): Reading {
    const {news, picture} = this;
    const connected = news?.connected ?? false;
    const rests = this.rests;
    const station = connected && news?.stationHeard_ms !== undefined && (rests || !this.stationIsSilent) ? this.station : undefined;
    const exact = this.account(now_ms);
    const account = exact && this.worst.note(exact, now_ms);
    const silence_ms = !connected || rests || news?.silentSince_ms === undefined ? undefined : now_ms - news.silentSince_ms;
    const picture_ms = this.pictureAge_ms(now_ms);
    const age_ms = account === undefined ? picture_ms : total_ms(account);
    const stale = connected && !rests && age_ms !== undefined && (silence_ms !== undefined || age_ms > oldestFresh_ms(news));
    const station_ms = news?.stationHeard_ms === undefined ? undefined : now_ms - news.stationHeard_ms;
    const presence = presenceOf(news, now_ms);
    return {
      ...touchOf(station),
      connected,
      everConnected: news?.everConnected ?? false,
      retryIn_ms: news?.retryAt_ms === undefined ? undefined : Math.max(0, news.retryAt_ms - now_ms),
      opening: this.opening,
      unopened: news?.unopened,
      capture: news?.capture,
      phase: news?.phase === Phase.FAULTED ? Phase.FAULTED : station?.phase ?? this.unknownPhase,
      depth: news?.depth,
      holdsHand: this.holdsHand,
      graphicsLost: this.graphicsLost,
      unsteady: station && this.unsteadyAt(now_ms),
      paused: this.isPaused,
      stale,
      silence_ms,
      heardAny_ms: news?.heardAny_ms === undefined ? undefined : now_ms - news.heardAny_ms,
      numbersOld: stale && station !== undefined && station_ms !== undefined && station_ms > OLD_NUMBERS_MS,
      silenceLimit_ms: news?.silenceLimit_ms,
      imageGap_ms: news?.imageGap_ms,
      untaken: news?.untaken_ms !== undefined && now_ms - news.untaken_ms < UNTAKEN_MS,
      surfaceStale: station !== undefined && (news?.surfaceStale ?? false),
      handOutsideWindow: station !== undefined && (news?.surfaceReport?.handOutsideWindow ?? false),
      objectOverPlace: station !== undefined && (news?.surfaceReport?.objectOverPlace ?? false),
      station_ms,
      picture_ms,
      account,
      late_ms: connected ? this.late_ms : undefined,
      link_ms: connected ? news?.link_ms : undefined,
      clockError_ms: news?.clockError_ms,
      fps: this.drawnAt_ms.filter((at_ms) => at_ms > now_ms - 1000).length,
      frames: this.frames,
      dropped: (news?.dropped ?? 0) + (news?.overtaken ?? 0),
      undecodable: news?.undecodable ?? 0,
      colorSaid: news?.colorSaid ?? '',
      lateTicks: news?.lateTicks,
      pictureInstant_ms: picture?.captured_ms,
      picturePublished_ms: picture?.published_ms,
      numbersInstant_ms: station && milliseconds(station.stampNs),
      handInstant_ms: this.hand_ms,
      role: news?.role ?? '',
      lineLeft_B_per_s: lineLeft(presence),
      presence,
      station,
      compensation: station && this.compensation,
      surfaceReport: this.stationIsSilent ? undefined : news?.surfaceReport,
      summary: picture?.summary,
      light: news?.light,
      events: connected ? news?.events ?? [] : [],
      sessionNow_ns: news?.offset_ms === undefined ? undefined : BigInt(Math.round(1000 * (now_ms + news.offset_ms))) * 1000n,
      taking: stationIsLive(presence) ? news?.taking : undefined,
      cameraFrames_per_s: connected ? news?.capture?.framesPerS ?? 0 : 0,
    };
  }

  /** An unsteady device is shown for some time, because a swing comes and goes: with largest width and newest rate. */
  private unsteadyAt(now_ms: number): Unsteady | undefined {
    const {swing, driveIsFull} = this.news?.motion ?? {};
    const told = this.unsteady !== undefined && now_ms - this.unsteady.at_ms < UNSTEADY_MS ? this.unsteady.what : undefined;
    let now: Unsteady | undefined = driveIsFull === true ? 'full drive' : undefined;
    if (swing !== undefined && isOwnSwing(swing, this.pointerRests)) now = {swing_mm: 1000 * swing.width_m, hertz: swing.hertz};
    if (now === undefined) return told;
    const what = withWidest(told, now);
    this.unsteady = {what, at_ms: now_ms};
    return what;
  }

  private get isPaused(): boolean {
    const capture = this.news?.capture;
    return this.paused || (capture !== undefined && isPaused(capture));
  }

  /** No newer picture is expected. */
  private get rests(): boolean {
    const capture = this.news?.capture;
    return this.isPaused || (capture !== undefined && isAtRest(capture));
  }

  private get unknownPhase(): Phase | undefined {
    return this.stationIsSilent ? Phase.UNSPECIFIED : undefined;
  }

  /** By the clock of the news: a page that is busy reads old news. */
  private get stationIsSilent(): boolean {
    const {news} = this;
    return news?.connected !== true || news.stationHeard_ms === undefined || news.at_ms - news.stationHeard_ms >= SILENT_MS;
  }

  private get silences(): string {
    return `images ${this.news?.silentSince_ms !== undefined}, station ${this.stationIsSilent}`;
  }

  /** Age since the exposure if the session clock is known, else since the picture was drawn. */
  private pictureAge_ms(now_ms: number): number | undefined {
    if (this.picture === undefined) return undefined;
    const offset_ms = this.news?.offset_ms;
    return offset_ms === undefined ? now_ms - this.picture.drawn_ms : now_ms + offset_ms - this.picture.captured_ms;
  }

  private account(now_ms: number): TimeAccount | undefined {
    const times = this.picture?.times;
    const heard = this.news?.heard;
    if (this.picture === undefined || times === undefined || heard === undefined) return undefined;
    const waiting = this.news?.waiting;
    const newer = waiting !== undefined && waiting.captured_ms > times.captured_ms + 1 ? waiting : undefined;
    const shown = {...times, drawn_ms: this.picture.drawn_ms};
    return accountFor({shown, next: this.coming?.times ?? newer, heard}, now_ms);
  }
}

/** The greatest age of a picture that its path explains: what each image needs, and what some wait for a lost packet. */
const oldestFresh_ms = (news: News | undefined) =>
    (news?.leastAge_ms ?? 0) + Math.max(STALE_MS, (news?.silenceLimit_ms ?? 0) + DRAWING_MS);

/** It is not known who is here while the server is silent. */
function presenceOf(news: News | undefined, now_ms: number): Presence {
  const known = news?.connected === true && now_ms - (news.heardAny_ms ?? now_ms) < AWAY_MS ? news : undefined;
  return {
    stats: known?.stats,
    touching: known?.touching ?? 0,
    holder: known?.holder ?? NOBODY,
    me: known?.viewer ?? 0n,
    playsSession: known?.capture?.source.startsWith('session:') ?? false,
  };
}

function touchOf(station: StationState | undefined) {
  const forces = station && forcesOf(station);
  const torque = station?.torqueCameraNM;
  return {
    force_N: forces?.force_N,
    drive_N: forces?.drive_N,
    torque_N_m: torque && Math.hypot(torque.x, torque.y, torque.z),
    indentation_mm: station && 1000 * station.indentationM,
    limited: station?.limited ?? false,
    yields_s: station && station.yieldsInS > 0 && Number.isFinite(station.yieldsInS) ? station.yieldsInS : undefined,
    handShown: station && shownHand(station) !== undefined,
    unmodelled: (station?.unmodelled ?? 0) > 0.5,
    objectUnseen: station?.objectUnseen ?? false,
    surface_ms: station && station.surfaceCapturedNs !== 0n
        ? Number(station.stampNs - station.surfaceCapturedNs) / 1e6
        : undefined,
  };
}
