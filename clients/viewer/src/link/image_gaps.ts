const BIN_MS = 10;
const BINS = 100;                // gaps of 1 s and more share the last bin
const MEMORY_MS = 60_000;        // a gap this long ago counts 1/e of a new one
const UNKNOWN_MS = 5000;         // until gaps of this total duration are known, the path counts as unknown
const USUAL_SHARE = 0.99;

const REGULAR_MS = 100;
const REGULAR_LIMIT_MS = 270;    // the page then marks within 300 ms
const MARGIN_MS = 200;
const LONGEST_LIMIT_MS = 1000;
const OUTLIER_MS = 30;

/**
 * The gaps between arriving images on this path, and the silence that they do not explain. The gaps are weighted by
 * their duration: images that a lossy path delivers together would otherwise hide the gap before them. Pure.
 */
export class ImageGaps {
  private readonly shares = new Float64Array(BINS + 1);  // duration of the gaps in each bin [ms], older ones weighted less

  /** A gap between two images that arrived. A gap beyond the limit counts little more than the limit, because it was an outage. */
  add(gap_ms: number): void {
    const counted_ms = Math.min(gap_ms, this.limit_ms + OUTLIER_MS);
    const kept = Math.exp(-counted_ms / MEMORY_MS);
    for (let bin = 0; bin <= BINS; ++bin) this.shares[bin]! *= kept;
    this.shares[Math.min(BINS, Math.floor(counted_ms / BIN_MS))]! += counted_ms;
  }

  /** During 99 % of the time, the gap is shorter than this; undefined while too few gaps are known. */
  get usual_ms(): number | undefined {
    const all_ms = this.shares.reduce((sum, share_ms) => sum + share_ms, 0);
    if (all_ms < UNKNOWN_MS) return undefined;
    let above_ms = 0;
    for (let bin = BINS; bin >= 0; --bin) {
      above_ms += this.shares[bin]!;
      if (above_ms > (1 - USUAL_SHARE) * all_ms) return (bin + 1) * BIN_MS;
    }
    return BIN_MS;
  }

  /** A silence that is longer than this is not explained by the path: the picture counts as stale. At most 1 s. */
  get limit_ms(): number {
    const usual_ms = this.usual_ms ?? Infinity;
    return usual_ms <= REGULAR_MS ? REGULAR_LIMIT_MS : Math.min(LONGEST_LIMIT_MS, usual_ms + MARGIN_MS);
  }
}
