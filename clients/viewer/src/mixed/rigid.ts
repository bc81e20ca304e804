import type {Rotation, Vec3} from '../messages/generated';

/** A rigid motion: first the rotation (a unit quaternion), then the translation [m]. */
export interface Rigid {
  rotation: Rotation;
  translation: Vec3;
}

export const plus = (a: Vec3, b: Vec3): Vec3 => ({x: a.x + b.x, y: a.y + b.y, z: a.z + b.z});
export const minus = (a: Vec3, b: Vec3): Vec3 => ({x: a.x - b.x, y: a.y - b.y, z: a.z - b.z});
export const norm = ({x, y, z}: Vec3): number => Math.hypot(x, y, z);

export function mean(points: readonly Vec3[]): Vec3 {
  const sum = points.reduce(plus, {x: 0, y: 0, z: 0});
  return {x: sum.x / points.length, y: sum.y / points.length, z: sum.z / points.length};
}

/** The vector `v`, rotated: v + 2 u x (u x v + w v) with u = (x, y, z). */
export function turn({x, y, z, w}: Rotation, v: Vec3): Vec3 {
  const [cx, cy, cz] = [y * v.z - z * v.y + w * v.x, z * v.x - x * v.z + w * v.y, x * v.y - y * v.x + w * v.z];
  return {x: v.x + 2 * (y * cz - z * cy), y: v.y + 2 * (z * cx - x * cz), z: v.z + 2 * (x * cy - y * cx)};
}

export const conjugate = ({x, y, z, w}: Rotation): Rotation => ({x: -x, y: -y, z: -z, w});

export function product(a: Rotation, b: Rotation): Rotation {
  return {
    x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
    y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
    z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
    w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
  };
}

export const moved = (by: Rigid, at: Vec3): Vec3 => plus(turn(by.rotation, at), by.translation);

export function inverse({rotation, translation}: Rigid): Rigid {
  const back = conjugate(rotation);
  return {rotation: back, translation: turn(back, minus({x: 0, y: 0, z: 0}, translation))};
}

/** First `b`, then `a`. */
export const after = (a: Rigid, b: Rigid): Rigid =>
  ({rotation: product(a.rotation, b.rotation), translation: moved(a, b.translation)});

/** The columns of the rotation's matrix. */
export const columnsOf = (rotation: Rotation): Vec3[] =>
  [{x: 1, y: 0, z: 0}, {x: 0, y: 1, z: 0}, {x: 0, y: 0, z: 1}].map((axis) => turn(rotation, axis));

/** The rotation about y by `angle` [rad]. */
export const aboutY = (angle: number): Rotation => ({x: 0, y: Math.sin(angle / 2), z: 0, w: Math.cos(angle / 2)});

/** The motion as a 4 x 4 matrix, column by column. */
export function matrixOf({rotation, translation}: Rigid): number[] {
  return [...columnsOf(rotation), translation].flatMap(({x, y, z}, i) => [x, y, z, i === 3 ? 1 : 0]);
}
