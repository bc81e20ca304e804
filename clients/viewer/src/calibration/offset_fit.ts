import type {Vec3} from '../messages/generated';

/** The hand on the end-effector: one place, in the hand tracker's frame L and in the haptic base's frame H [m]. */
export interface Touch {
  place: number;  // touches of one rest of the hand have the same number, from 1
  tracker: Vec3;
  haptic: Vec3;
}

/** The residuals of one place [m]. */
export interface PlaceResiduals {
  place: number;
  touches: number;
  rms_m: number;
  moved_m: number;  // largest distance of a touch from the mean of its own place
}

export interface OffsetFit {
  tracker0: Vec3;      // p0_L of S1 eq. (2): mean of the hand
  haptic0: Vec3;       // p0_H: mean of the end-effector
  translation: Vec3;   // p0_H - R p0_L
  rms_m: number;
  largest_m: number;
  places: PlaceResiduals[];
}

export const LEAST_TOUCHES = 10;
/** A larger residual means that the hand moved, or that the tracker is turned otherwise than eq. (4) states. */
export const MOST_MOVED_M = 0.005;

const plus = (a: Vec3, b: Vec3): Vec3 => ({x: a.x + b.x, y: a.y + b.y, z: a.z + b.z});
const minus = (a: Vec3, b: Vec3): Vec3 => ({x: a.x - b.x, y: a.y - b.y, z: a.z - b.z});
const norm = ({x, y, z}: Vec3) => Math.hypot(x, y, z);
/** R of S1 eq. (4). */
const turned = ({x, y, z}: Vec3): Vec3 => ({x, y: -y, z: -z});

function mean(points: readonly Vec3[]): Vec3 {
  const sum = points.reduce(plus, {x: 0, y: 0, z: 0});
  return {x: sum.x / points.length, y: sum.y / points.length, z: sum.z / points.length};
}

const rms = (lengths: readonly number[]) =>
  Math.sqrt(lengths.reduce((sum, length) => sum + length * length, 0) / lengths.length);

/**
 * S1 eq. (2) and (4): p_H = R (p_L - p0_L) + p0_H, as haptic_station/calibration/offset_procedure.h computes it for the
 * file. undefined: fewer than LEAST_TOUCHES.
 */
export function fitOffset(touches: readonly Touch[]): OffsetFit | undefined {
  if (touches.length < LEAST_TOUCHES) return undefined;
  const tracker0 = mean(touches.map(({tracker}) => tracker));
  const haptic0 = mean(touches.map(({haptic}) => haptic));
  const translation = minus(haptic0, turned(tracker0));
  const off = touches.map(({place, tracker, haptic}) => ({place, off: minus(plus(turned(tracker), translation), haptic)}));
  const lengths = off.map(({off: by}) => norm(by));
  const places = [...new Set(touches.map(({place}) => place))].map((place) => {
    const own = off.filter((one) => one.place === place).map(({off: by}) => by);
    const middle = mean(own);
    return {
      place, touches: own.length, rms_m: rms(own.map(norm)),
      moved_m: Math.max(...own.map((by) => norm(minus(by, middle)))),
    };
  });
  return {tracker0, haptic0, translation, rms_m: rms(lengths), largest_m: Math.max(...lengths), places};
}

/** The touches as the point pairs that `telepalp-station calibrate` reads: `to` is H, `from` the tracker's frame. */
export function pairsFile(touches: readonly Touch[]): string {
  const numbers = ({x, y, z}: Vec3) => [x, y, z].map((value) => value.toFixed(6)).join(',');
  const rows = touches.map(({place, tracker, haptic}) => `${place},${numbers(haptic)},${numbers(tracker)}\n`);
  return `place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m\n${rows.join('')}`;
}
