// What the page's levels of detail cost and give without a graphics card: the page's own mesh of a depth image, laid by
// its own code. Called by telepalp-bench accuracy: node detail_rows.mjs BIN_DIR VIEWER_FILES
// The image is of a trunk with ribs, known by formula, with a Kinect's noise and whole millimetres.
import {join} from 'node:path';

import {bundler} from '../../clients/viewer/bundled.mjs';

const [, viewer] = process.argv.slice(2);
const sources = new URL('../../../clients/viewer/src', import.meta.url).pathname;
const {coarseMeshFor, layCoarseMesh} = await bundler(sources, join(viewer, '../clients/viewer/work'))('scene/coarse_mesh.ts');

const [WIDTH, HEIGHT, NOISE_MM, TIMES] = [640, 480, 1.5, 60];
const CAMERA = {fx: 525, fy: 525, cx: 319.5, cy: 239.5};
const STRIDES = [3, 4, 6, 8];  // of the levels in scene_view.ts; the mesh has 65 536 vertices at most, so at least 3

/** The trunk's depth [m] on the ray through a pixel. */
function trueDepth(column, row) {
  const [x, y] = [(column - CAMERA.cx) / CAMERA.fx, (row - CAMERA.cy) / CAMERA.fy];
  let z_m = 0.8;
  for (let i = 0; i < 8; ++i)
    z_m = 0.8 + (x * z_m) ** 2 / 3 + (y * z_m) ** 2 / 2 + 0.004 * Math.sin((x * z_m) / 0.016) * Math.cos((y * z_m) / 0.02);
  return z_m;
}

/** Numbers in [0, 1), the same in each run (mulberry32). */
function seeded(seed) {
  return () => {
    let t = (seed += 0x6d2b79f5);
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const truth = Float64Array.from({length: WIDTH * HEIGHT}, (_, at) => trueDepth(at % WIDTH, Math.floor(at / WIDTH)));
const random = seeded(1);
const normal = () => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
const samples = Uint16Array.from(truth, (z_m) => Math.round(1000 * z_m + NOISE_MM * normal()));
const frame = {width: WIDTH, height: HEIGHT, unit_m: 0.001, samples};

/** RMS depth [m] between the drawn triangles and the trunk, at the pixels inside whole squares of the mesh. */
function drawnError(mesh) {
  const {columns, stride, positions} = mesh;
  const depthAt = (vertex) => -positions[3 * vertex + 2];
  let [square, count] = [0, 0];
  for (let row = 0; row < stride * (mesh.rows - 1); ++row)
    for (let column = 0; column < stride * (columns - 1); ++column) {
      const at = Math.floor(row / stride) * columns + Math.floor(column / stride);
      const [u, v] = [(column % stride) / stride, (row % stride) / stride];
      const [near, right, below, far] = [at, at + 1, at + columns, at + columns + 1].map(depthAt);
      const z_m = u + v <= 1 ? near + u * (right - near) + v * (below - near) :
                               far + (1 - u) * (below - far) + (1 - v) * (right - far);
      square += (z_m - truth[row * WIDTH + column]) ** 2;
      ++count;
    }
  return Math.sqrt(square / count);
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

for (const stride of STRIDES) {
  const mesh = coarseMeshFor(WIDTH, HEIGHT, stride);
  const times_ms = Array.from({length: TIMES}, () => {
    const began = process.cpuUsage();
    layCoarseMesh(mesh, frame, CAMERA);
    const {user, system} = process.cpuUsage(began);
    return (user + system) / 1000;
  });
  const name = `page, a vertex every ${mesh.stride} pixels`;
  const rows = [['triangles', mesh.used / 3, ''], ['processor time to lay the mesh, p50', median(times_ms), 'ms'],
    ['RMS depth error of the drawn surface', 1000 * drawnError(mesh), 'mm']];
  for (const [what, value, unit] of rows) console.log([`${name}: ${what}`, value, unit, 'none', 0].join('\t'));
}
