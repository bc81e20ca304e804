/** How finely the view is drawn: every n-th pixel of the depth image, and screen pixels for each point of the page. */
export interface Detail {
  stride: number;
  pixelRatio: number;
}

const POLL_MS = 4;
/** After a slow frame the page rests for as long as that took, at most this: messages wait behind drawing. */
const LONGEST_REST_MS = 500;
const TOO_SLOW_MS = 90;
const EASY_MS = 12;
const SLOW_FRAMES = 4;
const EASY_FRAMES = 240;

/**
 * Draws no frame before the graphics card has finished the one before, so that a slow one holds up neither the page
 * nor the messages; and draws less finely where that takes too long, as without a graphics card.
 */
export class FramePacer {
  /** Into what the view may be drawn as, from the finest. */
  level = 0;
  /** From the drawing's start to its end on the graphics card, of the last frame. */
  drawn_ms = 0;

  private wanted = false;
  private busy = false;
  private slow = 0;
  private easy = 0;

  /**
   * `draw` is called with the animation frame and says whether its time tells anything; `onDrawn` when it is finished, and
   * `onFree` when the next one may begin.
   * `level` stays below `levels`.
   */
  constructor(
      private readonly gl: WebGL2RenderingContext,
      private readonly levels: number,
      private readonly draw: () => boolean,
      private readonly onDrawn: () => void,
      private readonly onFree: () => void,
  ) {}

  /** Asks for a frame. Asking often costs nothing: one is drawn for all that asked before it began. */
  ask(): void {
    this.wanted = true;
    if (this.busy) return;
    this.busy = true;
    requestAnimationFrame(() => this.begin());
  }

  private begin(): void {
    this.wanted = false;
    const began_ms = performance.now();
    const telling = this.draw();
    const done = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
    this.wait(done, began_ms, telling);
  }

  private wait(done: WebGLSync | null, began_ms: number, telling: boolean): void {
    // A lost context signals nothing; it counts as done.
    const pending = done !== null && !this.gl.isContextLost() &&
        this.gl.getSyncParameter(done, this.gl.SYNC_STATUS) !== this.gl.SIGNALED;
    if (pending) {
      window.setTimeout(() => this.wait(done, began_ms, telling), POLL_MS);
      return;
    }
    if (done !== null) this.gl.deleteSync(done);
    this.onDrawn();
    this.drawn_ms = performance.now() - began_ms;
    if (telling) this.judge(this.drawn_ms);
    if (this.drawn_ms < TOO_SLOW_MS) this.rested();
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
