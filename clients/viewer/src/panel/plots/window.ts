/** The part of the history that the plots show. */
export interface Range {
  from_s: number;
  to_s: number;
}

const LIVE_S = 15;
const SHORTEST_S = 0.5;
const LONGEST_S = 60;

/** Follows the newest values until the user zooms; then it stands still until it is live again. Pure. */
export class PlotWindow {
  private held: Range | undefined;
  private length_s = LIVE_S;

  get isLive(): boolean {
    return this.held === undefined;
  }

  /** The range to draw, for a history from `begin_s` to `end_s`. A held range that has left the history ends. */
  range(begin_s: number, end_s: number): Range {
    if (this.held !== undefined && (this.held.to_s < begin_s || this.held.from_s > end_s)) this.live();
    return this.held ?? {from_s: end_s - this.length_s, to_s: end_s};
  }

  live(): void {
    this.held = undefined;
    this.length_s = LIVE_S;
  }

  hold(range: Range): void {
    if (range.to_s - range.from_s >= SHORTEST_S) this.held = range;
  }

  /** `factor` < 1 shows a shorter time, around the middle of a held range or up to now. */
  zoom(factor: number): void {
    if (this.held === undefined) {
      this.length_s = within(this.length_s * factor);
      return;
    }
    const {from_s, to_s} = this.held;
    const [middle_s, half_s] = [(from_s + to_s) / 2, within((to_s - from_s) * factor) / 2];
    this.held = {from_s: middle_s - half_s, to_s: middle_s + half_s};
  }

  /** Moves by `share` of the range; from a live range it stops following. */
  move(share: number, begin_s: number, end_s: number): void {
    const {from_s, to_s} = this.range(begin_s, end_s);
    const way_s = Math.min(end_s - to_s, Math.max(begin_s - from_s, share * (to_s - from_s)));
    this.held = {from_s: from_s + way_s, to_s: to_s + way_s};
  }
}

const within = (length_s: number) => Math.min(LONGEST_S, Math.max(SHORTEST_S, length_s));
