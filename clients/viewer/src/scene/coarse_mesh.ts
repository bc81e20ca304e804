import type {DepthFrame} from '../depth/decode_depth';

/** fx, fy, cx, cy of the depth camera [pixels]. */
export interface Intrinsics {
  fx: number;
  fy: number;
  cx: number;
  cy: number;
}

/** A mesh of every `stride`-th pixel, in the scene's frame. The buffers are reused from frame to frame. */
export interface CoarseMesh {
  columns: number;
  rows: number;
  stride: number;
  positions: Float32Array;  // x, y, z [m]; 0, 0, 0 where nothing was measured
  pixels: Float32Array;     // column, row of the depth image
  lamp: Float32Array;       // 0 ... 1: cosine between the surface's normal and the direction of the lamp
  corners: Uint16Array;     // three for each triangle
  used: number;             // number of corners that are valid
}

/** Towards the lamp, in the scene's frame; of length 1. */
const LAMP = {x: -0.416, y: 0.601, z: 0.682};
const MOST_VERTICES = 65_536;

/** The largest depth difference of two neighbours on one surface [m], as in surface_shaders.ts. */
const largestStep = (z_m: number) => 0.012 + 0.010 * z_m * z_m;

/** An empty mesh for frames of this size. `stride` is raised until the vertices can be numbered in 16 bits. */
export function coarseMeshFor(width: number, height: number, wanted: number): CoarseMesh {
  let stride = wanted;
  const count = (size: number) => Math.floor((size - 1) / stride) + 1;
  while (count(width) * count(height) > MOST_VERTICES) ++stride;
  const [columns, rows] = [count(width), count(height)];
  const pixels = new Float32Array(2 * columns * rows);
  for (let at = 0; at < columns * rows; ++at) pixels.set([stride * (at % columns), stride * Math.floor(at / columns)], 2 * at);
  return {
    columns, rows, stride, pixels,
    positions: new Float32Array(3 * columns * rows),
    lamp: new Float32Array(columns * rows),
    corners: new Uint16Array(6 * (columns - 1) * (rows - 1)),
    used: 0,
  };
}

/** Writes `frame` into `mesh`: places, light and triangles. No triangle spans a hole or a depth break. */
export function layCoarseMesh(mesh: CoarseMesh, frame: DepthFrame, intrinsics: Intrinsics): void {
  place(mesh, frame, intrinsics);
  light(mesh);
  join(mesh);
}

function place({columns, rows, stride, positions}: CoarseMesh, frame: DepthFrame, {fx, fy, cx, cy}: Intrinsics): void {
  for (let row = 0, at = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column, at += 3) {
      const z_m = smoothDepth(frame, stride * column, stride * row);
      positions[at] = ((stride * column - cx) / fx) * z_m;
      positions[at + 1] = -((stride * row - cy) / fy) * z_m;
      positions[at + 2] = -z_m;
    }
}

/** The mean depth of a pixel and its neighbours on the same surface [m], for display only; 0: not measured. */
function smoothDepth({width, height, samples, unit_m}: DepthFrame, column: number, row: number): number {
  const own = samples[row * width + column]!;
  if (own === 0) return 0;
  const most = largestStep(own * unit_m) / unit_m;
  let [sum, count] = [0, 0];
  for (let y = Math.max(0, row - 1); y <= Math.min(height - 1, row + 1); ++y)
    for (let x = Math.max(0, column - 1); x <= Math.min(width - 1, column + 1); ++x) {
      const other = samples[y * width + x]!;
      if (other === 0 || Math.abs(other - own) > most) continue;
      sum += other;
      ++count;
    }
  return (sum / count) * unit_m;
}

/** Fills `lamp`: the light on each vertex, by the normal through its neighbours on the same surface. */
function light({columns, rows, stride, positions, lamp}: CoarseMesh): void {
  const depthAt = (vertex: number) => -positions[3 * vertex + 2]!;
  for (let row = 0, at = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column, ++at) {
      const most = stride * largestStep(depthAt(at));
      const same = (other: number) => (depthAt(other) > 0 && Math.abs(depthAt(other) - depthAt(at)) < most ? other : at);
      const [left, right] = [same(column > 0 ? at - 1 : at), same(column + 1 < columns ? at + 1 : at)];
      const [above, below] = [same(row > 0 ? at - columns : at), same(row + 1 < rows ? at + columns : at)];
      lamp[at] = facing(positions, 3 * left, 3 * right, 3 * above, 3 * below);
    }
}

/** The cosine between the lamp's direction and the normal to the lines left–right and above–below. */
function facing(at: Float32Array, left: number, right: number, above: number, below: number): number {
  const [ax, ay, az] = [at[right]! - at[left]!, at[right + 1]! - at[left + 1]!, at[right + 2]! - at[left + 2]!];
  const [bx, by, bz] = [at[below]! - at[above]!, at[below + 1]! - at[above + 1]!, at[below + 2]! - at[above + 2]!];
  const [x, y, z] = [by * az - bz * ay, bz * ax - bx * az, bx * ay - by * ax];
  const length = Math.sqrt(x * x + y * y + z * z);
  return length === 0 ? LAMP.z : Math.max(0, (x * LAMP.x + y * LAMP.y + z * LAMP.z) / length);
}

/** Two triangles for each square of vertices, wound to face the camera. */
function join(mesh: CoarseMesh): void {
  const {columns, rows, stride, positions, corners} = mesh;
  const depthAt = (vertex: number) => -positions[3 * vertex + 2]!;
  let used = 0;
  const add = (a: number, b: number, c: number) => {
    const [za, zb, zc] = [depthAt(a), depthAt(b), depthAt(c)];
    const nearest = Math.min(za, zb, zc);
    if (nearest === 0 || Math.max(za, zb, zc) - nearest > stride * largestStep(nearest)) return;
    corners[used++] = a;
    corners[used++] = b;
    corners[used++] = c;
  };
  for (let row = 0; row + 1 < rows; ++row)
    for (let column = 0; column + 1 < columns; ++column) {
      const at = row * columns + column;
      add(at, at + columns, at + 1);
      add(at + 1, at + columns, at + columns + 1);
    }
  mesh.used = used;
}
