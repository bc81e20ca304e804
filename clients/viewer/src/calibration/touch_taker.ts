import {Phase, type RigidMotion, type StationState, type Vec3} from '../messages/generated';
import type {Touch} from './offset_fit';

export const TOUCHES_OF_A_PLACE = 50;
const QUIET_N = 0.05;  // the device's force below which the hand alone decides where the end-effector is

/** How far the present place is taken. */
export interface Taking {
  taken: number;    // of TOUCHES_OF_A_PLACE
  problem: string;  // why no touch is added now; empty: touches are added, or no place is asked for
}

type Touching = Pick<StationState, 'phase' | 'forceN' | 'hand' | 'device' | 'workspaceShift' | 'handSampledNs'>;

/** p_L from p_H, for p_H = rotation p_L + translation. */
function inTracker({rotation, translationM}: RigidMotion, haptic: Vec3): Vec3 {
  const {x, y, z, w} = rotation ?? {x: 0, y: 0, z: 0, w: 1};
  const t = translationM ?? {x: 0, y: 0, z: 0};
  const [px, py, pz] = [haptic.x - t.x, haptic.y - t.y, haptic.z - t.z];
  // v + 2 u x (u x v + w v) with u = -(x, y, z): the conjugate turns back.
  const [cx, cy, cz] = [z * py - y * pz + w * px, x * pz - z * px + w * py, y * px - x * py + w * pz];
  return {x: px + 2 * (z * cy - y * cz), y: py + 2 * (x * cz - z * cx), z: pz + 2 * (y * cx - x * cy)};
}

/** The device's own frame: workspace indexing shifts H against it. */
const unshifted = (at: Vec3, shift: Vec3 | undefined): Vec3 =>
  shift === undefined ? at : {x: at.x - shift.x, y: at.y - shift.y, z: at.z - shift.z};

/**
 * Takes the touches of one place from the station's states: one for each new sample of the hand tracker while the device
 * gives no force. It uses no clock and no sockets.
 */
export class TouchTaker {
  /** The calibration with which the station placed the hands that it publishes; undefined: its tracker has none. */
  inUse: RigidMotion | undefined;

  private place: number | undefined;
  private touches: Touch[] = [];
  private problem = '';
  private lastSample_ns = 0n;

  constructor(private readonly done: (touches: Touch[]) => void) {}

  /** Begins a place, instead of the present one; undefined: takes none. */
  take(place: number | undefined): void {
    this.place = place;
    this.touches = [];
    this.problem = '';
  }

  stateCame(state: Touching): void {
    if (this.place === undefined) return;
    this.problem = this.obstacle(state);
    const {hand, device, workspaceShift, handSampledNs} = state;
    if (this.problem !== '' || this.inUse === undefined || hand === undefined || device === undefined) return;
    if (handSampledNs === this.lastSample_ns) return;
    this.lastSample_ns = handSampledNs;
    this.touches.push({
      place: this.place,
      tracker: inTracker(this.inUse, unshifted(hand, workspaceShift)),
      haptic: unshifted(device, workspaceShift),
    });
    if (this.touches.length < TOUCHES_OF_A_PLACE) return;
    this.done(this.touches);
    this.take(undefined);
  }

  get taking(): Taking {
    return {taken: this.touches.length, problem: this.problem};
  }

  private obstacle({phase, forceN, handSampledNs}: Touching): string {
    const force_N = forceN === undefined ? 0 : Math.hypot(forceN.x, forceN.y, forceN.z);
    if (phase === Phase.FAULTED) return 'Station faulted: remove the cause, then run telepalp-station rearm';
    if (!(force_N <= QUIET_N)) return `The device pushes with ${force_N.toFixed(1)} N: restart the station with --scene calibration.`;
    return handSampledNs === 0n ? 'The tracker sees no hand: move the hand into its view.' : '';
  }
}
