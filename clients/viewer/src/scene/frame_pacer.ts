/** A level of detail: the step between drawn pixels of the depth image, and the screen pixels per point of the page. */
export interface Detail {
  stride: number;
  pixelRatio: number;
}

const POLL_MS = 4;
/**
 * Longest rest after a slow frame in the canvas. The page rests for the duration of the frame, so that messages are
 * handled.
 */
const LONGEST_REST_MS = 500;
const TOO_SLOW_MS = 60;  // fewer than 15 pictures a second
const EASY_MS = 12;
const SLOW_FRAMES = 4;
const EASY_FRAMES = 240;

/**
 * Draws a frame only after the graphics card has finished the last one, so that a slow card delays neither the page nor
 * the messages. If drawing takes too long, as without a graphics card, it selects a coarser level of detail.
 */
export class FramePacer {
  /** The levels of detail, finest first. */
  level = 0;
  /** Duration of the last frame, from the start of drawing to its end on the graphics card. */
  drawn_ms = 0;

  private wanted = false;
  private busy = false;
  private slow = 0;
  private easy = 0;

  /**
   * `draw` returns whether its duration counts. It draws aside, and `show` shows the finished frame; without `show`,
   * `draw` draws into the canvas, and is called in the animation frame. `onDrawn` is called when the frame is finished,
   * `onFree` when the next one may begin. `level` stays below `levels`.
   */
  constructor(
      private readonly gl: WebGL2RenderingContext,
      private readonly levels: number,
      private readonly draw: () => boolean,
      private readonly show: (() => void) | undefined,
      private readonly onDrawn: () => void,
      private readonly onFree: () => void,
  ) {}

  /** Requests a frame. One frame answers all requests made before it began. */
  ask(): void {
    this.wanted = true;
    if (this.busy) return;
    this.busy = true;
    if (this.show === undefined) requestAnimationFrame(() => this.begin());
    else window.setTimeout(() => this.begin(), 0);  // drawing aside shows nothing yet
  }

  private begin(): void {
    this.wanted = false;
    const began_ms = performance.now();
    const representative = this.draw();
    const done = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    this.wait(done, began_ms, representative);
  }

  private wait(done: WebGLSync | null, began_ms: number, representative: boolean): void {
    // A lost context signals nothing; it counts as done.
    const pending = done !== null && !this.gl.isContextLost() &&
        this.gl.getSyncParameter(done, this.gl.SYNC_STATUS) !== this.gl.SIGNALED;
    if (pending) {
      window.setTimeout(() => this.wait(done, began_ms, representative), POLL_MS);
      return;
    }
    if (done !== null) this.gl.deleteSync(done);
    if (this.show === undefined) return this.finish(began_ms, representative);
    this.show();
    // The browser reads the canvas after the callbacks of its next animation frame.
    requestAnimationFrame(() => window.setTimeout(() => this.finish(began_ms, representative), 0));
  }

  private finish(began_ms: number, representative: boolean): void {
    this.onDrawn();
    this.drawn_ms = performance.now() - began_ms;
    if (representative) this.judge(this.drawn_ms);
    if (this.show !== undefined || this.drawn_ms < TOO_SLOW_MS) this.rested();
    else window.setTimeout(() => this.rested(), Math.min(this.drawn_ms, LONGEST_REST_MS));
  }

  private rested(): void {
    this.busy = false;
    this.onFree();
    if (this.wanted) this.ask();
  }

  private judge(drawn_ms: number): void {
    this.slow = drawn_ms > TOO_SLOW_MS ? this.slow + 1 : 0;
    this.easy = drawn_ms < EASY_MS ? this.easy + 1 : 0;
    if (this.slow >= SLOW_FRAMES && this.level + 1 < this.levels) this.change(this.level + 1);
    if (this.easy >= EASY_FRAMES && this.level > 0) this.change(this.level - 1);
  }

  private change(level: number): void {
    this.level = level;
    this.slow = this.easy = 0;
    this.ask();
  }
}
