const MOST_HELD_MS = 200;
const PICTURES = 30;  // three seconds

/**
 * How long speech waits in its jitter buffer to be heard with the picture of its instant. The picture never waits,
 * because the hand follows it. Speech that comes later than its picture is heard when it comes.
 */
export class LipSync {
  private ages_ms: number[] = [];

  /** The picture that is shown was captured `age_ms` ago. */
  shown(age_ms: number): void {
    this.ages_ms = [...this.ages_ms, age_ms].slice(-PICTURES);
  }

  /** The delay in the jitter buffer. `fastest_ms`: how old the fastest frames of speech are when they arrive. */
  delay_ms(fastest_ms: number): number {
    if (this.ages_ms.length === 0) return 0;
    const sorted = [...this.ages_ms].sort((a, b) => a - b);
    return Math.min(MOST_HELD_MS, Math.max(0, sorted[Math.floor(sorted.length / 2)]! - fastest_ms));
  }
}
