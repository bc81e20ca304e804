import {ImageGaps} from './image_gaps';

/** A timer that is later than this was held up with the whole page, and images that have arrived may still wait behind it. */
const HELD_UP_MS = 30;
const AGAIN_MS = 10;
const SETTLE_MS = 5000;  // after connecting, the gaps are those of two programs that start

/** The functions that SilenceWatch calls. */
export interface WatchCallbacks {
  now_ms(): number;
  setTimer(call: () => void, after_ms: number): void;  // replaces the timer before it
  changed(): void;                                     // a silence has begun or ended
}

/** Notices when no image has come for longer than the gaps on this path explain, and when images come again. */
export class SilenceWatch {
  /** The time of the last image, while the silence since then is longer than the path explains. */
  since_ms: number | undefined;

  private gaps = new ImageGaps();
  private last_ms: number | undefined;
  private began_ms = 0;
  private resting = false;

  constructor(private readonly callbacks: WatchCallbacks) {}

  get limit_ms(): number {
    return this.gaps.limit_ms;
  }
  get usual_ms(): number | undefined {
    return this.gaps.usual_ms;
  }

  /** A new connection: its path may be another one. Nothing is expected before its first image. */
  restart(): void {
    this.gaps = new ImageGaps();
    this.began_ms = this.callbacks.now_ms();
    this.last_ms = undefined;
    this.resting = false;
    this.end();
  }

  imageCame(): void {
    if (this.resting) return;
    const now_ms = this.callbacks.now_ms();
    if (this.last_ms !== undefined && now_ms - this.began_ms > SETTLE_MS) this.gaps.add(now_ms - this.last_ms);
    this.last_ms = now_ms;
    this.end();
    this.arm(this.limit_ms);
  }

  /** True: no image is expected, because the played session is paused or has ended. */
  rest(wanted: boolean): void {
    if (wanted === this.resting) return;
    this.resting = wanted;
    this.last_ms = wanted ? undefined : this.callbacks.now_ms();
    this.end();
    if (!wanted) this.arm(this.limit_ms);
  }

  private arm(after_ms: number): void {
    const due_ms = this.callbacks.now_ms() + after_ms;
    this.callbacks.setTimer(() => this.look(due_ms), after_ms);
  }

  private look(due_ms: number): void {
    const {last_ms, callbacks, limit_ms} = this;
    const now_ms = callbacks.now_ms();
    if (this.resting || last_ms === undefined || now_ms < last_ms + limit_ms - 1) return;
    if (now_ms - due_ms > HELD_UP_MS) return this.arm(AGAIN_MS);
    this.since_ms = last_ms;
    callbacks.changed();
  }

  private end(): void {
    if (this.since_ms === undefined) return;
    this.since_ms = undefined;
    this.callbacks.changed();
  }
}
