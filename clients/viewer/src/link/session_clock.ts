interface Probe {
  roundTrip_ms: number;
  offset_ms: number;
}

const PROBES_KEPT = 8;
const PROBE_EVERY_MS = 5000;

/**
 * The session clock as this browser knows it. The server's reading lies half-way between asking and hearing, give or
 * take half the round trip, so the quickest of the last probes is believed.
 */
export class SessionClock {
  private probes: Probe[] = [];

  /** Asks the server from now on. */
  start(): void {
    void this.probe();
    window.setInterval(() => void this.probe(), PROBE_EVERY_MS);
  }

  /** Forgets what it knew: the server may be another one, with another session. */
  restart(): void {
    this.probes = [];
    for (let times = 0; times < 3; ++times) void this.probe();
  }

  /** Milliseconds since session time `at_ns`; undefined while the server's clock is not known. */
  age_ms(at_ns: bigint): number | undefined {
    const best = this.probes.reduce<Probe | undefined>(
        (least, probe) => (least && least.roundTrip_ms <= probe.roundTrip_ms ? least : probe), undefined);
    if (best === undefined) return undefined;
    return performance.now() + best.offset_ms - Number(at_ns / 1000n) / 1000;
  }

  private async probe(): Promise<void> {
    const asked_ms = performance.now();
    try {
      const reply = await fetch('/session_clock', {cache: 'no-store', signal: AbortSignal.timeout(2000)});
      const text = await reply.text();
      const heard_ms = performance.now();
      if (!reply.ok || !/^\d+$/.test(text)) return;
      const server_ms = Number(BigInt(text) / 1000n) / 1000;
      this.probes.push({roundTrip_ms: heard_ms - asked_ms, offset_ms: server_ms - (asked_ms + heard_ms) / 2});
      this.probes = this.probes.slice(-PROBES_KEPT);
    } catch {
      // The server is away: the stream says so, and the next probe comes by itself.
    }
  }
}
