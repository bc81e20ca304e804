import {FRAME_MS, FRAME_SAMPLES, type SpokenFrame} from './frame';

const TRANSITS = 500;         // ten seconds
const SHARE_IN_TIME = 0.995;  // of the frames
const MARGIN_MS = 5;
const MOST_DELAY_MS = 400;
const MOST_WAITING = 50;      // frames
const GIVE_UP = 10;           // missing frames in a row, after which nobody talks
const SKIP_ABOVE = 1.2;       // frames
const SKIP_AT_ONCE_ABOVE = 4;
const SKIP_EVERY = 5;         // calls
const STRETCH_BELOW = -0.2;   // frames; within the margin, so that a frame is not played before it comes
const JUMP_BACK_MS = 200;
const JUMP_ON_MS = 2000;

export interface VoiceCounts {
  played: number;
  concealed: number;  // frames that were lost, or came too late
  skipped: number;    // frames left out to shorten the delay
  stretched: number;  // 20 ms made up to lengthen the delay
  late: number;
}

/**
 * The jitter buffer between network and loudspeaker, for decoded frames: the rules of codec/voice_playout.h. The delay
 * follows the path: with it, 99.5 % of the last ten seconds' frames would have come before their turn. It is at least
 * `held_ms`, by which speech waits for its picture. A missing frame is made up from the one before it, and fades. Times
 * are in ms, of any steady clock.
 */
export class JitterBuffer {
  readonly counts: VoiceCounts = {played: 0, concealed: 0, skipped: 0, stretched: 0, late: 0};
  delay_ms = MARGIN_MS;
  held_ms = 0;
  /** How old the fastest frames of the last ten seconds were when they came; undefined: not known. */
  fastest_ms: number | undefined;

  private talker = 0n;
  private readonly waiting = new Map<number, SpokenFrame>();
  private next: number | undefined;  // the frame whose turn is next
  private playing = false;
  private missing = 0;      // frames since the last one that came
  private sinceSkip = 0;
  private transits: number[] = [];
  private least_ms = 0;
  private last = new Float32Array(FRAME_SAMPLES);  // played last

  /** `age_ms`: how long ago its first sample was spoken; undefined: not known. */
  add(frame: SpokenFrame, arrived_ms: number, age_ms?: number): void {
    const transit = arrived_ms - frame.number * FRAME_MS;
    const jumped = this.transits.length > 0 &&
        (transit < this.least_ms - JUMP_BACK_MS || transit > this.least_ms + JUMP_ON_MS);
    if (frame.talker !== this.talker || jumped) this.restart(frame.talker);
    this.noteTransit(transit);
    if (age_ms !== undefined) this.fastest_ms = age_ms - transit + this.least_ms;
    if (this.next !== undefined && frame.number < this.next) return void ++this.counts.late;
    this.waiting.set(frame.number, frame);
    if (this.waiting.size > MOST_WAITING) this.waiting.delete(this.first()!);
  }

  /** The sound of the 20 ms from `now_ms` on; undefined: silence. */
  pull(now_ms: number): Float32Array<ArrayBuffer> | undefined {
    if (!this.playing && !this.begins(now_ms)) return undefined;
    if (this.waiting.size === 0 && this.missing >= GIVE_UP) {
      this.playing = false;
      this.next! -= this.missing;
      this.missing = 0;
      return undefined;
    }
    ++this.sinceSkip;
    const behind = this.behind(now_ms);
    if (behind < STRETCH_BELOW) {
      ++this.counts.stretched;
      return this.madeUp();
    }
    if (behind > SKIP_AT_ONCE_ABOVE || (behind > SKIP_ABOVE && this.sinceSkip >= SKIP_EVERY)) {
      this.sinceSkip = 0;
      ++this.counts.skipped;
      this.waiting.delete(this.next!);
      ++this.next!;
    }
    return this.playNext();
  }

  private restart(talker: bigint): void {
    this.talker = talker;
    this.waiting.clear();
    this.transits = [];
    this.next = undefined;
    this.playing = false;
    this.missing = 0;
  }

  private noteTransit(transit: number): void {
    this.transits.push(transit);
    if (this.transits.length > TRANSITS) this.transits.shift();
    this.least_ms = Math.min(...this.transits);
    const useful = this.transits.filter((one) => one <= this.least_ms + MOST_DELAY_MS).sort((a, b) => a - b);
    const rank = Math.ceil(SHARE_IN_TIME * useful.length) - 1;
    this.delay_ms = Math.min(useful[rank]! - this.least_ms + MARGIN_MS, MOST_DELAY_MS);
  }

  /** How many frames the turn at `now_ms` is ahead of the next frame to play. */
  private behind(now_ms: number): number {
    return (now_ms - this.least_ms - Math.max(this.delay_ms, this.held_ms)) / FRAME_MS - this.next!;
  }

  private first(): number | undefined {
    return this.waiting.size === 0 ? undefined : Math.min(...this.waiting.keys());
  }

  private begins(now_ms: number): boolean {
    const first = this.first();
    if (first === undefined) return false;
    const before = this.next;
    this.next = first;
    if (this.behind(now_ms) < 0) {
      this.next = before;
      return false;
    }
    const {begun} = this.waiting.get(first)!;
    if (before !== undefined) this.counts.concealed += first - Math.min(first, Math.max(begun, before));
    while (this.waiting.size > 1 && this.behind(now_ms) >= 1) {  // after an outage, only the newest part is of use
      this.waiting.delete(this.next);
      ++this.counts.skipped;
      this.next = this.first()!;
    }
    this.sinceSkip = this.missing = 0;
    return (this.playing = true);
  }

  private playNext(): Float32Array<ArrayBuffer> {
    const number = this.next!++;
    const frame = this.waiting.get(number);
    if (frame === undefined) {
      ++this.missing;
      return this.madeUp();
    }
    this.waiting.delete(number);
    this.counts.concealed += Math.min(this.missing, number - frame.begun);
    this.missing = 0;
    ++this.counts.played;
    return (this.last = frame.samples);
  }

  /** The sound before, turned around so that it begins where that one ended, at half its loudness. */
  private madeUp(): Float32Array<ArrayBuffer> {
    this.last = this.last.map((_, at, all) => 0.5 * all[all.length - 1 - at]!);
    return this.last;
  }
}
