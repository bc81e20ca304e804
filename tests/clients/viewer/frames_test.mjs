// The camera's frame and the scene's: node frames_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {fromCamera, rotationFromCamera} = await bundled('scene/frames.ts');

/** `v` turned by the unit quaternion `q`. */
function turned({x, y, z, w}, v) {
  const cross = (a, b) => ({x: a.y * b.z - a.z * b.y, y: a.z * b.x - a.x * b.z, z: a.x * b.y - a.y * b.x});
  const t = cross({x, y, z}, v);
  const u = cross({x, y, z}, t);
  return {x: v.x + 2 * (w * t.x + u.x), y: v.y + 2 * (w * t.y + u.y), z: v.z + 2 * (w * t.z + u.z)};
}

test('a direction of the hand is the same, turned in the camera’s frame or in the scene', () => {
  const q = {x: 0.1, y: -0.5, z: 0.7, w: 0.5};
  for (const axis of [{x: 1, y: 0, z: 0}, {x: 0, y: 1, z: 0}, {x: 0, y: 0, z: 1}]) {
    const expected = fromCamera(turned(q, axis));
    const got = turned(rotationFromCamera(q), axis);
    for (const part of ['x', 'y', 'z']) assert.ok(Math.abs(got[part] - expected[part]) < 1e-9);
  }
});

test('a palm that faces away from the camera with the fingers up the picture is the hand as it is drawn without attitude',
     () => {
       const {x, y, z, w} = rotationFromCamera({x: 1, y: 0, z: 0, w: 0});  // y up the picture, z to the camera
       assert.deepEqual([x, y, z, Math.abs(w)].map((part) => Math.abs(part) < 1e-12 ? 0 : part), [0, 0, 0, 1]);
     });

test('numbers that are no rotation are not drawn', () => {
  assert.equal(rotationFromCamera({x: 0, y: 0, z: 0, w: 0}), undefined);
  assert.equal(rotationFromCamera({x: NaN, y: 0, z: 0, w: 1}), undefined);
  assert.equal(rotationFromCamera({x: 3, y: 0, z: 0, w: 1}), undefined);
});
