interface Probe {
  roundTrip_ms: number;
  offset_ms: number;
}

const PROBES_KEPT = 8;
const PROBE_EVERY_MS = 5000;

/** The current time in milliseconds since 1970: monotonic, and equal in the page and its workers. */
export const now_ms = () => performance.timeOrigin + performance.now();

/** Session time `at_ns` in milliseconds. */
export const milliseconds = (at_ns: bigint) => Number(at_ns / 1000n) / 1000;

/**
 * An estimate of the session clock in the browser. It assumes that the server read its clock halfway between request
 * and reply; the error is at most half the round trip. So the probe with the shortest round trip among the last ones is
 * used.
 */
export class SessionClock {
  private probes: Probe[] = [];

  /** Starts to probe the server. */
  start(): void {
    void this.probe();
    setInterval(() => void this.probe(), PROBE_EVERY_MS);
  }

  /** Discards the estimate, because the server may be another one with another session. */
  restart(): void {
    this.probes = [];
    for (let times = 0; times < 3; ++times) void this.probe();
  }

  /** Session time minus now_ms(); undefined while the server's clock is not known. */
  get offset_ms(): number | undefined {
    return this.best?.offset_ms;
  }

  /** Bound on the error of offset_ms, and so of each age; undefined while the server's clock is not known. */
  get error_ms(): number | undefined {
    return this.best && this.best.roundTrip_ms / 2;
  }

  private get best(): Probe | undefined {
    return this.probes.reduce<Probe | undefined>(
        (least, probe) => (least && least.roundTrip_ms <= probe.roundTrip_ms ? least : probe), undefined);
  }

  private async probe(): Promise<void> {
    const asked_ms = now_ms();
    try {
      const reply = await fetch('/session_clock', {cache: 'no-store', signal: AbortSignal.timeout(2000)});
      const text = await reply.text();
      const heard_ms = now_ms();
      if (!reply.ok || !/^\d+$/.test(text)) return;
      const server_ms = milliseconds(BigInt(text));
      this.probes.push({roundTrip_ms: heard_ms - asked_ms, offset_ms: server_ms - (asked_ms + heard_ms) / 2});
      this.probes = this.probes.slice(-PROBES_KEPT);
    } catch {
      // The server is away: the stream says so, and the next probe comes by itself.
    }
  }
}
