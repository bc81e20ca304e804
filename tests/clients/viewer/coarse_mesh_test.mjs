// The surface that is drawn without a graphics card: node coarse_mesh_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {coarseMeshFor, layCoarseMesh} = await bundled('scene/coarse_mesh.ts');

const [WIDTH, HEIGHT, STRIDE] = [64, 48, 4];
const CAMERA = {fx: 60, fy: 60, cx: 32, cy: 24};

/** The mesh of the depth image whose pixel is `depthAt(column, row)` [mm]. */
function meshOf(depthAt, stride = STRIDE) {
  const samples = Uint16Array.from({length: WIDTH * HEIGHT}, (_, at) => depthAt(at % WIDTH, Math.floor(at / WIDTH)));
  const mesh = coarseMeshFor(WIDTH, HEIGHT, stride);
  layCoarseMesh(mesh, {width: WIDTH, height: HEIGHT, unit_m: 0.001, samples}, CAMERA);
  return mesh;
}

const depthOf = (mesh, vertex) => -mesh.positions[3 * vertex + 2];
const triangles = (mesh) => Array.from({length: mesh.used / 3}, (_, at) => [...mesh.corners.slice(3 * at, 3 * at + 3)]);

test('a plane is covered completely, lies where the camera saw it, and is lit evenly', () => {
  const mesh = meshOf(() => 800);
  assert.equal(mesh.used, 6 * (mesh.columns - 1) * (mesh.rows - 1));
  const vertex = mesh.columns + 2;  // pixel (8, 4)
  const [x, y, z] = mesh.positions.slice(3 * vertex, 3 * vertex + 3);
  assert.ok(Math.abs(x - ((8 - 32) / 60) * 0.8) < 1e-6 && Math.abs(y + ((4 - 24) / 60) * 0.8) < 1e-6 && Math.abs(z + 0.8) < 1e-6);
  for (const lamp of mesh.lamp) assert.ok(Math.abs(lamp - 0.682) < 1e-3, `${lamp}`);  // cosine of lamp and camera axis
});

test('each triangle faces the camera', () => {
  const mesh = meshOf((column, row) => 700 + column + row);
  for (const [a, b, c] of triangles(mesh)) {
    const at = (vertex) => [...mesh.pixels.slice(2 * vertex, 2 * vertex + 2)];
    const [[ax, ay], [bx, by], [cx, cy]] = [at(a), at(b), at(c)];
    assert.ok((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0, 'rows grow downwards');
  }
});

test('no triangle spans a silhouette', () => {
  const mesh = meshOf((column) => (column < 30 ? 700 : 1000));
  const found = triangles(mesh);
  assert.ok(found.length > 0 && mesh.used < mesh.corners.length);
  for (const corners of found) {
    const depths = corners.map((vertex) => depthOf(mesh, vertex));
    assert.ok(Math.max(...depths) - Math.min(...depths) < 0.1, `${depths}`);
  }
});

test('no triangle has a corner that was not measured, and its depth does not smear over the hole', () => {
  const mesh = meshOf((column, row) => (column > 20 && column < 40 && row > 10 && row < 30 ? 0 : 800));
  for (const corners of triangles(mesh)) for (const vertex of corners) assert.ok(Math.abs(depthOf(mesh, vertex) - 0.8) < 1e-6);
  const holes = [...mesh.lamp.keys()].filter((vertex) => depthOf(mesh, vertex) === 0);
  assert.equal(holes.length, 20, 'vertices at columns 24 to 36 and rows 12 to 28');
});

test('a step that is too fine for 16-bit numbers is made coarser', () => {
  const mesh = coarseMeshFor(640, 480, 1);
  assert.equal(mesh.stride, 3);
  assert.ok(mesh.columns * mesh.rows <= 65_536);
});
