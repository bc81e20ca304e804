import type {Rotation, Vec3} from '../messages/generated';
import {aboutY, columnsOf, conjugate, mean, minus, moved, norm, product, type Rigid, turn} from './rigid';
import {eigenpairs, solved} from './symmetric';

/** A place of the device, touched with the tip of a tracked hand or controller [m]. */
export interface Touch {
  place: number;  // touches with equal numbers are repeats
  known: Vec3;    // in the device's own frame
  touched: Vec3;  // in the headset's reference space
}

export interface Anchor {
  headsetFromDevice: Rigid;
  rms_m: number;  // of the distances between touches and anchored places
}

/** What is wrong, and how to fix it: one sentence each. */
export interface Refusal {
  what: string;
  fix: string;
}

export const isRefusal = (result: object): result is Refusal => 'fix' in result;

// The limits of clients/mixed/anchor/headset_anchor.cpp.
const LEAST_SPREAD_M = 0.01;
const LARGEST_RMS_M = 0.015;
const LEAST_TURN_RAD = 0.2;

const coordinates = ({x, y, z}: Vec3) => [x, y, z];

/** Sums over the points of coordinate i in `from` times coordinate k in `to`, as `sums[i][k]`. */
function products(from: readonly Vec3[], to: readonly Vec3[]): number[][] {
  return [0, 1, 2].map((i) => [0, 1, 2].map((k) => from.reduce((sum, one, n) => sum + coordinates(one)[i]! * coordinates(to[n]!)[k]!, 0)));
}

/** The rotation about y that best turns the centred points `from` onto `to`. */
function heading(from: readonly Vec3[], to: readonly Vec3[]): Rotation {
  const s = products(from, to);
  return aboutY(Math.atan2(s[2]![0]! - s[0]![2]!, s[0]![0]! + s[2]![2]!));
}

/** The rotation that best turns the centred points `from` onto `to`. Source: Horn 1987, by quaternions, which never give a reflection. */
function rotation(from: readonly Vec3[], to: readonly Vec3[]): Rotation {
  type Three = [number, number, number];
  const [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = products(from, to) as [Three, Three, Three];
  const [best] = eigenpairs([
    [xx + yy + zz, yz - zy, zx - xz, xy - yx],
    [yz - zy, xx - yy - zz, xy + yx, zx + xz],
    [zx - xz, xy + yx, yy - xx - zz, yz + zy],
    [xy - yx, zx + xz, yz + zy, zz - xx - yy],
  ]);
  const [w, x, y, z] = best!.vector as [number, number, number, number];
  return {x, y, z, w};
}

/** RMS of the points' second principal component [m]: 0 on a line. */
function spreadBesideALine(points: readonly Vec3[]): number {
  const centred = points.map((point) => minus(point, mean(points)));
  return Math.sqrt(Math.max(0, eigenpairs(products(centred, centred))[1]!.value / points.length));
}

/**
 * The rigid motion that best moves the points `from` onto `to`. `level`: y is up in both frames, so that only heading and
 * place are fitted. undefined: the points lie on a line or at one point.
 */
export function fitRigid(from: readonly Vec3[], to: readonly Vec3[], level = false): Rigid | undefined {
  if (from.length < 3 || spreadBesideALine(from) < LEAST_SPREAD_M) return undefined;
  const [fromMean, toMean] = [mean(from), mean(to)];
  const centred = [from.map((point) => minus(point, fromMean)), to.map((point) => minus(point, toMean))] as const;
  const best = level ? heading(...centred) : rotation(...centred);
  return {rotation: best, translation: minus(toMean, turn(best, fromMean))};
}

/** RMS of the distances between the moved points and `to` [m]. */
function rmsOf(motion: Rigid, from: readonly Vec3[], to: readonly Vec3[]): number {
  return Math.sqrt(from.reduce((sum, point, i) => sum + norm(minus(moved(motion, point), to[i]!)) ** 2, 0) / from.length);
}

/**
 * The least-squares anchor of touches at three places or more. `level`: y is up in both frames. It computes the same as
 * clients/mixed/anchor/headset_anchor.h; a test compares both.
 */
export function anchorHeadset(touches: readonly Touch[], level: boolean): Anchor | Refusal {
  const places = new Set(touches.map(({place}) => place)).size;
  const [known, touched] = [touches.map((touch) => touch.known), touches.map((touch) => touch.touched)];
  if (![...known, ...touched].every(({x, y, z}) => Number.isFinite(x + y + z)))
    return {what: 'A coordinate of a touch is not finite.', fix: 'Touch that place again, with the hand in view.'};
  if (places < 3) return {what: `Only ${places} places were touched; an anchor needs three.`, fix: 'Touch three places or more.'};
  const headsetFromDevice = fitRigid(known, touched, level);
  if (headsetFromDevice === undefined)
    return {what: 'The places lie on a line or at one point.', fix: 'Touch a place beside the line.'};
  const rms_m = rmsOf(headsetFromDevice, known, touched);
  if (rms_m > LARGEST_RMS_M)
    return {what: `The touches miss their places by ${(1e3 * rms_m).toFixed(0)} mm.`, fix: 'Touch the end-effector itself, and hold still.'};
  return {headsetFromDevice, rms_m};
}

/**
 * S2 II.C: one pose of a hand that lies flat on the end-effector, its fingers along the device's -z. Heading and place
 * follow from it, and no residual exists. `forward`: direction of the fingers, in the headset's space.
 */
export function anchorByOnePose(known: Vec3, hand: Vec3, forward: Vec3): Anchor | Refusal {
  if (Math.hypot(forward.x, forward.z) < 0.3)
    return {what: 'The fingers point up or down.', fix: 'Lay the hand flat on the end-effector, fingers away from you.'};
  const turned = aboutY(Math.atan2(-forward.x, -forward.z));
  return {headsetFromDevice: {rotation: turned, translation: minus(hand, turn(turned, known))}, rms_m: NaN};
}

/**
 * The tip in the tool's frame [m], from poses in which the tip rests while the tool turns about it: pivot calibration.
 * For each pose i, R_i tip - rest = -t_i: solved by least squares for tip and resting point.
 */
export function pivotTip(poses: readonly Rigid[]): Vec3 | Refusal {
  const refusal = {what: 'The controller was turned too little about its end.', fix: 'Rest its end at one point, and turn it widely.'};
  const first = poses[0];
  if (first === undefined || poses.length < 4) return refusal;
  const turned = Math.max(...poses.map((pose) => 2 * Math.acos(Math.min(1, Math.abs(product(conjugate(first.rotation), pose.rotation).w)))));
  if (turned < LEAST_TURN_RAD) return refusal;
  const normal = Array.from({length: 6}, () => new Array<number>(6).fill(0));
  const right = new Array<number>(6).fill(0);
  for (const {rotation: by, translation} of poses) {
    const columns = columnsOf(by).map(coordinates);
    for (let row = 0; row < 3; ++row) {
      const line = [...columns.map((column) => column[row]!), row === 0 ? -1 : 0, row === 1 ? -1 : 0, row === 2 ? -1 : 0];
      for (let i = 0; i < 6; ++i) {
        for (let k = 0; k < 6; ++k) normal[i]![k]! += line[i]! * line[k]!;
        right[i]! -= line[i]! * coordinates(translation)[row]!;
      }
    }
  }
  const found = solved(normal, right);
  return found === undefined ? refusal : {x: found[0]!, y: found[1]!, z: found[2]!};
}
