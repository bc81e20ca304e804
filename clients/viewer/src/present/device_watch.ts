import type {StationState, Vec3} from '../messages/generated';
import {forcesOf} from './instant';

const WINDOW_S = 1.2;
const FEWEST_STATES = 60;      // of 120 in the window: with fewer, a swing cannot be told from gaps
const SMALLEST_SWING_M = 0.003;
const SLOWEST_HZ = 2.5;        // a patient breathes at less than 1 Hz
const MIDDLE_SHARE = 0.15;     // a crossing of the middle counts once the device is this share of its way beyond it
const FULL_DRIVE_N = 2.95;     // PositionControl.most_N (scene.proto) is 3 N
const FULL_SHARE = 0.9;        // of the states in the window

/** An oscillation of the device. */
export interface Swing {
  width_m: number;  // from end to end
  hertz: number;
  hand_m: number;   // how far the tracked hand moved meanwhile, from end to end
}

/** How the device moved in the last second. */
export interface DeviceMotion {
  swing: Swing | undefined;
  driveIsFull: boolean;  // the drive pushes the free device with its largest force
}

const AXES = ['x', 'y', 'z'] as const;
const spread = (values: readonly number[]) => Math.max(...values) - Math.min(...values);

/** How often `values` pass the middle of their range, from well below it to well above it or back. */
function crossings(values: readonly number[]): number {
  const middle = (Math.max(...values) + Math.min(...values)) / 2;
  const margin = MIDDLE_SHARE * spread(values);
  let [side, count] = [0, 0];
  for (const value of values) {
    const now = value > middle + margin ? 1 : value < middle - margin ? -1 : 0;
    if (now === 0 || now === side) continue;
    if (side !== 0) ++count;
    side = now;
  }
  return count;
}

/** The device's oscillation along the axis on which it moves most; undefined: it does not oscillate. */
function swingOf(states: readonly StationState[]): Swing | undefined {
  const seen = states.flatMap(({device, hand}) => (device === undefined || hand === undefined ? [] : [{device, hand}]));
  if (seen.length < FEWEST_STATES) return undefined;
  const along = (of: 'device' | 'hand', axis: keyof Vec3) => seen.map((one) => one[of][axis]);
  const widths = AXES.map((axis) => spread(along('device', axis)));
  const width_m = Math.max(...widths);
  const axis = AXES[widths.indexOf(width_m)]!;
  const hertz = crossings(along('device', axis)) / 2 / WINDOW_S;
  if (width_m < SMALLEST_SWING_M || hertz < SLOWEST_HZ) return undefined;
  return {width_m, hertz, hand_m: spread(along('hand', axis))};
}

/** Watches the station's states for a device that swings, and for a drive at its limit. Uses no clock: states have times. */
export class DeviceWatch {
  private states: StationState[] = [];

  stateCame(state: StationState): void {
    const last = this.states[this.states.length - 1];
    if (last !== undefined && state.stampNs < last.stampNs) this.states = [];  // the station was restarted
    this.states.push(state);
    const since_ns = state.stampNs - BigInt(Math.round(1e9 * WINDOW_S));
    while (this.states[0]!.stampNs <= since_ns) this.states.shift();
  }

  forget(): void {
    this.states = [];
  }

  get motion(): DeviceMotion {
    const full = this.states.filter((state) => forcesOf(state).drive_N >= FULL_DRIVE_N).length;
    return {
      swing: swingOf(this.states),
      driveIsFull: this.states.length >= FEWEST_STATES && full >= FULL_SHARE * this.states.length,
    };
  }
}

/**
 * True if the swing is the device's own: the hand's motion does not explain it, or the pointer that moves the hand rests.
 * Such a hand's measured place still varies with the noise of the skin below the pointer.
 */
export const isOwnSwing = ({width_m, hand_m}: Swing, pointerRests: boolean) => pointerRests || hand_m < width_m / 2;
