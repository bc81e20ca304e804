import {Phase} from '../../messages/generated';
import type {Touch} from '../../present/instant';

const KEPT_S = 60;
const GAP_S = 0.3;  // the station's state comes each 10 ms

/** Columns for a plot: times of the station [s], values, and `null` where messages are missing. */
export interface Columns {
  at_s: number[];
  force_N: (number | null)[];
  drive_N: (number | null)[];  // null in contact
  indentation_mm: (number | null)[];
}

/** A time in which the phase did not change. */
export interface PhaseSpan {
  phase: Phase;
  from_s: number;
  to_s: number;
}

/** Force, indentation and phase of the last minute. It uses neither the page nor a clock. */
export class TouchHistory {
  private touches: Touch[] = [];

  add(touch: Touch): void {
    const last = this.touches[this.touches.length - 1];
    if (last !== undefined && touch.at_s < last.at_s) this.touches = [];  // the station was restarted
    this.touches.push(touch);
    const old = this.touches.findIndex(({at_s}) => at_s >= touch.at_s - KEPT_S);
    if (old > 500) this.touches.splice(0, old);  // in blocks, because each removal moves all others
  }

  get end_s(): number | undefined {
    return this.touches[this.touches.length - 1]?.at_s;
  }
  get begin_s(): number | undefined {
    return this.touches[0]?.at_s;
  }

  /** The touch nearest to `at_s`; undefined if there is none within GAP_S. */
  at(at_s: number): Touch | undefined {
    const found = this.touches[this.firstFrom(at_s)] ?? this.touches[this.touches.length - 1];
    return found !== undefined && Math.abs(found.at_s - at_s) < GAP_S ? found : undefined;
  }

  columns(from_s: number, to_s: number): Columns {
    const columns: Columns = {at_s: [], force_N: [], drive_N: [], indentation_mm: []};
    let before_s = Infinity;
    for (const {at_s, force_N, drive_N, indentation_m} of this.between(from_s, to_s)) {
      if (at_s - before_s > GAP_S) {
        columns.at_s.push(before_s + GAP_S);
        columns.force_N.push(null);
        columns.drive_N.push(null);
        columns.indentation_mm.push(null);
      }
      columns.at_s.push(at_s);
      columns.force_N.push(force_N);
      columns.drive_N.push(drive_N > 0 ? drive_N : null);
      columns.indentation_mm.push(1000 * indentation_m);
      before_s = at_s;
    }
    return columns;
  }

  phases(from_s: number, to_s: number): PhaseSpan[] {
    const spans: PhaseSpan[] = [];
    for (const {at_s, phase = Phase.UNSPECIFIED} of this.between(from_s, to_s)) {
      const last = spans[spans.length - 1];
      if (last !== undefined && at_s - last.to_s <= GAP_S) last.to_s = at_s;
      if (last === undefined || last.phase !== phase || at_s - last.to_s > GAP_S)
        spans.push({phase, from_s: at_s, to_s: at_s});
    }
    return spans;
  }

  private between(from_s: number, to_s: number): Touch[] {
    return this.touches.slice(this.firstFrom(from_s), this.firstFrom(to_s + 1e-9));
  }

  private firstFrom(at_s: number): number {
    const found = this.touches.findIndex((touch) => touch.at_s >= at_s);
    return found < 0 ? this.touches.length : found;
  }
}
