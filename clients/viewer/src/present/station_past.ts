import type {Phase, StationCompensation, StationState} from '../messages/generated';
import {nearest} from './presented_instant';

const MOST_KEPT = 256;              // 2.5 s of messages at 100 Hz
const TOGETHER_NS = 10_000_000n;    // a compensation further from the state belongs to another instant

/** The newest phases and compensations of the station, to be looked up for the presented instant. */
export class StationPast {
  private phases: {from_s: number; phase: Phase}[] = [];
  private compensations: StationCompensation[] = [];

  stateCame({stampNs, phase}: Pick<StationState, 'stampNs' | 'phase'>): void {
    const from_s = Number(stampNs / 1000n) / 1e6;
    const last = this.phases[this.phases.length - 1];
    if (last !== undefined && from_s < last.from_s) this.phases = [];  // the station was restarted
    if (last === undefined || last.phase !== phase || from_s < last.from_s) this.phases.push({from_s, phase});
    if (this.phases.length > MOST_KEPT) this.phases.shift();
  }

  compensationCame(compensation: StationCompensation): void {
    this.compensations.push(compensation);
    if (this.compensations.length > MOST_KEPT) this.compensations.shift();
  }

  /** The phase at the station's time `at_s`; undefined before the first one that is known. */
  phaseAt(at_s: number): Phase | undefined {
    return this.phases.findLast(({from_s}) => from_s <= at_s)?.phase;
  }

  /** The compensation of the instant `stamp_ns`; undefined if none is known. */
  compensationAt(stamp_ns: bigint): StationCompensation | undefined {
    const found = nearest(this.compensations, ({stampNs}) => stampNs, stamp_ns);
    if (found === undefined) return undefined;
    const off_ns = found.stampNs - stamp_ns;
    return (off_ns < 0n ? -off_ns : off_ns) <= TOGETHER_NS ? found : undefined;
  }

  forget(): void {
    this.phases = [];
    this.compensations = [];
  }
}
