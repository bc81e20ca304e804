import {BufferAttribute, BufferGeometry} from 'three';

// A right hand with the palm down, seen from above: x to the little finger, y along the fingers, z out of the back of
// the hand [mm]. Bones are round cones; skin is their smooth union.

type Point = readonly [number, number, number];
interface Joint {
  at: Point;
  radius: number;
}
const joint = (x: number, y: number, z: number, radius: number): Joint => ({at: [x, y, z], radius});

/** The pad of the middle finger, which touches; it is the origin of the shape that `handGeometry` makes. */
const PAD: Point = [-6, 110, -25];

const CHAINS: readonly (readonly Joint[])[] = [
  [joint(-27, 22, 6, 11), joint(-30, 63, 5, 9.3), joint(-31, 87, -5, 8.2), joint(-31, 102, -17, 7.2)],
  [joint(-6, 27, 8, 11.5), joint(-6, 71, 7, 9.6), joint(-6, 98, -4, 8.4), joint(-6, 113, -17, 7.4)],
  [joint(14, 22, 6, 11), joint(16, 65, 5, 9.1), joint(18, 90, -5, 8.1), joint(19, 104, -17, 7.1)],
  [joint(32, 11, 3, 10), joint(38, 44, 2, 8), joint(41, 64, -6, 7.1), joint(43, 77, -16, 6.3)],
  [joint(-22, -48, 0, 15), joint(-48, -14, -4, 12), joint(-60, 14, -8, 9.6), joint(-64, 37, -13, 8)],
  [joint(-14, -58, 3, 16), joint(-27, 22, 5, 12.5)],
  [joint(-3, -60, 4, 17), joint(-6, 26, 6, 13)],
  [joint(8, -60, 4, 17), joint(14, 22, 5, 12.5)],
  [joint(17, -56, 2, 16), joint(32, 11, 2, 11.5)],
  [joint(-10, -60, 4, 18), joint(-13, -145, 6, 20)],
  [joint(11, -60, 4, 18), joint(14, -145, 6, 20)],
];

const PALM_BLEND_MM = 13;
const FINGER_BLEND_MM = 8;
const LEAST: Point = [-84, -168, -40];
/** The forearm fades out between these positions along y. */
const FADED_MM = -142;
const WHOLE_MM = -78;
const MOST: Point = [66, 132, 40];

/** Signed distance to a round cone, accurate near its surface. */
function distanceToBone(x: number, y: number, z: number, from: Joint, to: Joint): number {
  const bx = to.at[0] - from.at[0];  // no arrays here: this runs 100 000 times before the first picture
  const by = to.at[1] - from.at[1];
  const bz = to.at[2] - from.at[2];
  const px = x - from.at[0];
  const py = y - from.at[1];
  const pz = z - from.at[2];
  const along = Math.min(1, Math.max(0, (px * bx + py * by + pz * bz) / (bx * bx + by * by + bz * bz)));
  const qx = px - along * bx;
  const qy = py - along * by;
  const qz = pz - along * bz;
  const off = Math.sqrt(qx * qx + qy * qy + qz * qz);
  return off - (from.radius + along * (to.radius - from.radius));
}

function smoothMin(a: number, b: number, blend: number): number {
  const near = Math.max(blend - Math.abs(a - b), 0) / blend;
  return Math.min(a, b) - (near * near * blend) / 4;
}

/** Fingers blend with the palm but not with each other: each finger is complete before it is joined to the rest. */
function distanceToHand(x: number, y: number, z: number): number {
  let whole = Infinity;
  let fingers = Infinity;
  CHAINS.forEach((chain, number) => {
    let nearest = Infinity;
    for (let bone = 0; bone + 1 < chain.length; ++bone)
      nearest = Math.min(nearest, distanceToBone(x, y, z, chain[bone] as Joint, chain[bone + 1] as Joint));
    if (number < 5) fingers = Math.min(fingers, nearest);
    else whole = whole === Infinity ? nearest : smoothMin(whole, nearest, PALM_BLEND_MM);
  });
  return smoothMin(whole, fingers, FINGER_BLEND_MM);
}

/**
 * Surface nets (Gibson 1998): a vertex in each cell that the surface crosses, a quad across each crossed edge.
 * `cell_mm`: the size of a cell.
 */
export function handGeometry(cell_mm: number): BufferGeometry {
  const [nx, ny, nz] = [0, 1, 2].map((axis) => Math.ceil((MOST[axis]! - LEAST[axis]!) / cell_mm) + 1) as
      [number, number, number];
  const at = (i: number, j: number, k: number) => (k * ny + j) * nx + i;
  const field = new Float32Array(nx * ny * nz);
  for (let k = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx;) {
        const distance = distanceToHand(LEAST[0] + i * cell_mm, LEAST[1] + j * cell_mm, LEAST[2] + k * cell_mm);
        // Within half of the distance there is no surface: the sign, which is all that counts there, stays the same.
        const until = Math.min(nx, i + Math.max(1, Math.floor(Math.abs(distance) / 2 / cell_mm)));
        while (i < until) field[at(i++, j, k)] = distance;
      }

  const positions: number[] = [];
  const colors: number[] = [];  // white, with an opacity
  const vertexOf = new Int32Array(nx * ny * nz).fill(-1);
  for (let k = 0; k + 1 < nz; ++k)
    for (let j = 0; j + 1 < ny; ++j)
      for (let i = 0; i + 1 < nx; ++i) {
        if (Math.abs(field[at(i, j, k)]!) > 3 * cell_mm) continue;  // no corner of the cell is at the surface
        const middle = crossing(i, j, k, (a, b, c) => field[at(a, b, c)] as number);
        if (middle === undefined) continue;
        vertexOf[at(i, j, k)] = positions.length / 3;
        colors.push(1, 1, 1, solidity(LEAST[1] + middle[1] * cell_mm));
        middle.forEach((value, axis) => positions.push((LEAST[axis]! + value * cell_mm - PAD[axis]!) / 1000));
      }

  const triangles: number[] = [];
  const quad = (inside: boolean, a: number, b: number, c: number, d: number) =>
      inside ? triangles.push(a, b, c, a, c, d) : triangles.push(a, c, b, a, d, c);
  for (let k = 1; k + 1 < nz; ++k)
    for (let j = 1; j + 1 < ny; ++j)
      for (let i = 1; i + 1 < nx; ++i) {
        const inside = field[at(i, j, k)]! < 0;
        const v = (a: number, b: number, c: number) => vertexOf[at(a, b, c)]!;
        if (inside !== field[at(i + 1, j, k)]! < 0)
          quad(inside, v(i, j - 1, k - 1), v(i, j, k - 1), v(i, j, k), v(i, j - 1, k));
        if (inside !== field[at(i, j + 1, k)]! < 0)
          quad(inside, v(i - 1, j, k - 1), v(i - 1, j, k), v(i, j, k), v(i, j, k - 1));
        if (inside !== field[at(i, j, k + 1)]! < 0)
          quad(inside, v(i - 1, j - 1, k), v(i, j - 1, k), v(i, j, k), v(i - 1, j, k));
      }

  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('color', new BufferAttribute(new Float32Array(colors), 4));
  geometry.setIndex(triangles);
  geometry.computeVertexNormals();
  return geometry;
}

function solidity(y_mm: number): number {
  const share = Math.min(1, Math.max(0, (y_mm - FADED_MM) / (WHOLE_MM - FADED_MM)));
  return share * share * (3 - 2 * share);
}

const CORNERS: readonly Point[] =
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]];
const EDGES: readonly (readonly [number, number])[] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/** The mean of the points where a cell's edges cross the surface, in cells; undefined when none does. */
function crossing(i: number, j: number, k: number, field: (i: number, j: number, k: number) => number):
    [number, number, number] | undefined {
  const values = CORNERS.map(([x, y, z]) => field(i + x, j + y, k + z));
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (const [a, b] of EDGES) {
    const [va, vb] = [values[a]!, values[b]!];
    if (va < 0 === vb < 0) continue;
    const share = va / (va - vb);
    for (const axis of [0, 1, 2] as const)
      sum[axis] += CORNERS[a]![axis] + share * (CORNERS[b]![axis] - CORNERS[a]![axis]);
    ++count;
  }
  return count === 0 ? undefined : [i + sum[0] / count, j + sum[1] / count, k + sum[2] / count];
}
