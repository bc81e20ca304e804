const SPAN_MS = 30_000;

/** The least age of an image on its arrival in the last 30 to 60 s: the delay of a path on which nothing waits. */
export class LeastAge {
  private before_ms = Infinity;  // in the span before this one
  private now_ms = Infinity;
  private began_ms = 0;

  note(age_ms: number, at_ms: number): void {
    if (at_ms - this.began_ms > SPAN_MS) {
      this.before_ms = this.now_ms;
      this.now_ms = Infinity;
      this.began_ms = at_ms;
    }
    this.now_ms = Math.min(this.now_ms, Math.max(0, age_ms));
  }

  /** 0 while no image has come. */
  get value_ms(): number {
    const least_ms = Math.min(this.before_ms, this.now_ms);
    return Number.isFinite(least_ms) ? least_ms : 0;
  }
}
