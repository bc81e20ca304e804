import type {DecodedDepth} from '../depth/depth_decoder';
import type {StationState} from '../messages/generated';
import {forcesOf, type Instant, type Touch} from './instant';
import {type Packet, PacketLine} from './packet_line';
import {
  continuesWithoutPicture, handWithoutPicture, isSkipped, LONGEST_WAIT_MS, nearest, presentableUntil, valuesAt,
} from './presented_instant';

const MOST_STATES = 256;  // 2.5 s of /station/state
const MOST_COLORS = 40;

export interface DepthPacket extends Packet {
  published_ns: bigint;
}
export interface ColorPicture {
  data: Uint8Array | ImageBitmap;  // a JPEG, or a decoded frame of video, which must be closed if it is not given away
  captured_ns: bigint;
}

function release(color: ColorPicture | undefined): void {
  if (color !== undefined && 'close' in color.data) color.data.close();
}

/** Arrival times of the parts of a picture, in session time and on this computer's clock. */
export interface Arrival {
  captured_ns: bigint;
  published_ns: bigint;
  complete_ms: number | undefined;  // undefined: the station's state of that instant has not come
}

export interface Chosen extends Omit<Instant, 'picture' | 'times'> {
  decoded: DecodedDepth | undefined;
  color: ColorPicture | undefined;
  arrival: Arrival | undefined;
}

/** The functions that Instants calls. */
export interface Callbacks {
  now_ms(): number;
  decode(packet: Packet): void;     // answered by Instants.decoded or Instants.undecodable
  present(chosen: Chosen): void;    // once for each ask()
  requestKeyFrame(): void;                // requests a key frame, because nothing can be decoded without one
}

/**
 * Chooses what the page presents next. The page asks when it is ready to draw. It gets the newest instant of which both
 * picture and numbers have arrived. A slow page therefore skips instants, and no queue grows. A picture never comes with
 * values of another instant: if its own are not known, it comes without any.
 */
export class Instants {
  private readonly line = new PacketLine();
  private arrivals: Arrival[] = [];  // arrivals of pushed messages, newest last
  private states: StationState[] = [];
  private colors: ColorPicture[] = [];
  private asked = false;
  private decoding: Packet | undefined;
  private outdated: Packet | undefined;  // packet that was being decoded when the connection ended
  private ready: {decoded: DecodedDepth; captured_ns: bigint} | undefined;
  private newestCapture_ns = 0n;
  private newestArrival_ms = 0;
  private presentedCapture_ns: bigint | undefined;
  private presentedStamp_ns = 0n;
  private first_ns: bigint | undefined;  // time of the first of the station's values

  constructor(private readonly callbacks: Callbacks) {}

  get overtaken(): number {
    return this.line.overtaken;
  }

  /** The first instant that could be presented and was not chosen yet. */
  get waiting(): Arrival | undefined {
    return this.arrivals.find(({complete_ms}) => complete_ms !== undefined);
  }

  /** The page is ready to draw. */
  ask(): void {
    this.asked = true;
    this.serve();
  }

  depthCame(packet: DepthPacket): void {
    this.newestCapture_ns = packet.captured_ns;
    this.newestArrival_ms = this.callbacks.now_ms();
    this.arrivals.push({captured_ns: packet.captured_ns, published_ns: packet.published_ns, complete_ms: undefined});
    if (this.arrivals.length > 2 * MOST_STATES) this.arrivals.shift();
    if (!this.line.push(packet)) this.callbacks.requestKeyFrame();
    this.serve();
  }

  colorCame(color: ColorPicture): void {
    this.colors.push(color);
    if (this.colors.length > MOST_COLORS) release(this.colors.shift());
  }

  stationCame(state: StationState): void {
    const newest = this.states[this.states.length - 1];
    if (newest !== undefined && state.stampNs < newest.stampNs) this.states = [];  // the station was restarted
    this.states.push(state);
    this.first_ns ??= state.stampNs;
    if (this.states.length > MOST_STATES) this.states.shift();
    this.serve();
  }

  decoded(decoded: DecodedDepth): void {
    const packet = this.decoding;
    this.decoding = undefined;
    if (packet !== undefined && packet !== this.outdated && !this.isSkipped(packet.captured_ns)) this.ready = {decoded, captured_ns: packet.captured_ns};
    this.serve();
  }

  undecodable(): void {
    this.decoding = undefined;
    this.line.failed();
    this.serve();
  }

  /** A new connection begins and the data of the last one is discarded. A pending request is still answered. */
  restart(): void {
    this.line.clear();
    this.states = [];
    this.colors.forEach(release);
    this.colors = [];
    this.arrivals = [];
    this.ready = this.presentedCapture_ns = this.first_ns = undefined;
    this.presentedStamp_ns = 0n;
    this.outdated = this.decoding;
  }

  private get newestState(): StationState | undefined {
    return this.states[this.states.length - 1];
  }

  private isSkipped(captured_ns: bigint): boolean {
    return this.newestState !== undefined && valuesAt(this.states, captured_ns) === undefined &&
        isSkipped(captured_ns, this.newestState.stampNs, this.presentedCapture_ns);
  }

  /** Call this LONGEST_WAIT_MS after a picture has arrived. In a paused session no later message may come. */
  timePassed(): void {
    this.serve();
  }

  private get presentableUntil_ns(): bigint {
    if (this.callbacks.now_ms() - this.newestArrival_ms >= LONGEST_WAIT_MS) return this.newestCapture_ns;
    return presentableUntil(this.newestState?.stampNs, this.newestCapture_ns);
  }

  private serve(): void {
    const until_ns = this.presentableUntil_ns;
    this.noteComplete(until_ns);
    if (this.decoding === undefined) {
      this.decoding = this.line.next(until_ns, this.asked && this.ready === undefined);
      if (this.decoding !== undefined) this.callbacks.decode(this.decoding);
    }
    if (!this.asked) return;
    if (this.ready !== undefined) return this.presentPicture(this.ready.decoded, this.ready.captured_ns);
    if (this.decoding === undefined) this.presentWithoutPicture();
  }

  private noteComplete(until_ns: bigint): void {
    for (const arrival of this.arrivals)
      if (arrival.captured_ns <= until_ns) arrival.complete_ms ??= this.callbacks.now_ms();
  }

  private presentPicture(decoded: DecodedDepth, captured_ns: bigint): void {
    this.ready = undefined;
    const arrival = this.arrivals.find((one) => one.captured_ns === captured_ns);
    const station = valuesAt(this.states, captured_ns);
    const newest = this.newestState;
    const late_ms = station === undefined && newest !== undefined ? Number(captured_ns - newest.stampNs) / 1e6 : undefined;
    const color = nearest(this.colors, (one) => one.captured_ns, captured_ns);
    for (const one of this.colors) if (one.captured_ns <= captured_ns && one !== color) release(one);
    this.colors = this.colors.filter((one) => one.captured_ns > captured_ns && one !== color);
    this.arrivals = this.arrivals.filter((one) => one.captured_ns > captured_ns);
    this.presentedCapture_ns = captured_ns;
    const hand = station === undefined ? 'none' : 'new';
    this.give({decoded, station, hand, late_ms, color, arrival, trail: this.trailTo(station)});
  }

  private presentWithoutPicture(): void {
    const station = this.newestState;
    if (station === undefined || station.stampNs <= this.presentedStamp_ns) return;
    if (!continuesWithoutPicture(station.stampNs, this.presentedCapture_ns, this.first_ns ?? station.stampNs)) return;
    const hand = handWithoutPicture(
        station.stampNs, this.presentedCapture_ns === undefined ? undefined : this.newestCapture_ns);
    const nothing = {decoded: undefined, color: undefined, arrival: undefined, late_ms: undefined};
    this.give({...nothing, station, hand, trail: this.trailTo(station)});
  }

  private trailTo(station: StationState | undefined): Touch[] {
    if (station === undefined) return [];
    const since_ns = this.presentedStamp_ns;
    return this.states.filter(({stampNs}) => stampNs > since_ns && stampNs <= station.stampNs).map((state) => ({
      at_s: Number(state.stampNs / 1000n) / 1e6,
      ...forcesOf(state),
      indentation_m: state.indentationM,
    }));
  }

  private give(chosen: Chosen): void {
    if (chosen.station !== undefined) this.presentedStamp_ns = chosen.station.stampNs;
    this.asked = false;
    this.callbacks.present(chosen);
  }
}
