// What lies under the skin: node inside_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {marks_mm, caliperAfter} = await bundled('inside/depth_scale.ts');
const {ProbeImages} = await bundled('inside/probe_images.ts');
const {meshOf} = await bundled('scene/inner_structures.ts');
const {uprightOn, inHand} = await bundled('scene/transducer.ts');

test('the depth scale has at most six steps of 1, 2 or 5', () => {
  assert.deepEqual(marks_mm(0.1), [0, 20, 40, 60, 80, 100]);
  assert.deepEqual(marks_mm(0.06), [0, 10, 20, 30, 40, 50, 60]);
  assert.deepEqual(marks_mm(0.3), [0, 50, 100, 150, 200, 250, 300]);
  assert.deepEqual(marks_mm(0), []);
  assert.deepEqual(marks_mm(NaN), []);
});

test('keys move the caliper within the image, and Escape removes it', () => {
  assert.equal(caliperAfter('ArrowDown', undefined, 0.1), 1);
  assert.equal(caliperAfter('PageDown', 95, 0.1), 100);
  assert.equal(caliperAfter('PageUp', 3, 0.1), 0);
  assert.equal(caliperAfter('Escape', 40, 0.1), undefined);
  assert.equal(caliperAfter('a', 40, 0.1), 40);
});

const image = (stampNs) => ({stampNs, onSkin: true, widthM: 0.06, depthM: 0.1, jpeg: stampNs});

test('each image is drawn as it comes, also while the page asks for nothing', async () => {
  const drawn = [];
  const answers = [];
  const images = new ProbeImages(async (jpeg) => `bitmap ${jpeg}`, (bitmap) => drawn.push(bitmap), (view) => answers.push(view));
  for (const stampNs of [1n, 2n, 3n]) {
    images.came(image(stampNs));
    await new Promise(setImmediate);
  }
  assert.deepEqual(drawn, ['bitmap 1', 'bitmap 2', 'bitmap 3']);
  assert.deepEqual(answers, []);
  images.ask();
  assert.deepEqual(answers.map(({stampNs, drawn: count, onSkin}) => [stampNs, count, onSkin]), [[3n, 3, true]]);
  images.ask();
  assert.equal(answers.length, 1, 'the same pose is not sent twice');
  images.came({...image(4n), onSkin: false});
  await new Promise(setImmediate);
  assert.equal(drawn.at(-1), undefined, 'off the skin it is black');
  assert.deepEqual([answers.at(-1).onSkin, answers.at(-1).drawn], [false, 3]);
});

test('of the images that come while one is decoded, the newest alone is decoded', async () => {
  const decoded = [];
  const ends = [];
  const images = new ProbeImages(
      (jpeg) => (decoded.push(jpeg), new Promise((end) => ends.push(end))), () => undefined, () => undefined);
  for (const stampNs of [1n, 2n, 3n]) images.came(image(stampNs));
  assert.deepEqual(decoded, [1n]);
  ends[0]('bitmap');
  await new Promise(setImmediate);
  assert.deepEqual(decoded, [1n, 3n]);
});

test('a damaged image counts as none', async () => {
  const answers = [];
  const images = new ProbeImages(async () => undefined, () => undefined, (view) => answers.push(view));
  images.ask();
  images.came(image(1n));
  await new Promise(setImmediate);
  assert.deepEqual([answers[0].onSkin, answers[0].drawn], [false, 0]);
});

const structure = (points, triangles) => ({
  name: 'rib', effect: 1, least: {x: 1, y: 2, z: 3}, stepM: 0.5,
  points: new Uint8Array(Uint16Array.from(points).buffer), triangles: new Uint8Array(Uint16Array.from(triangles).buffer),
});

test('a structure becomes points in metres', () => {
  const {positions, corners} = meshOf(structure([0, 2, 4, 1, 1, 1, 2, 0, 0], [0, 1, 2]));
  assert.deepEqual([...positions], [1, 3, 5, 1.5, 2.5, 3.5, 2, 2, 3]);
  assert.deepEqual([...corners], [0, 1, 2]);
});

test('a structure that names points which it lacks is not drawn', () => {
  assert.equal(meshOf(structure([0, 0, 0, 1, 1, 1], [0, 1, 2])), undefined);
  assert.equal(meshOf(structure([0, 0], [])), undefined);
  assert.equal(meshOf({...structure([], []), least: undefined}), undefined);
});

/** The vector `v` turned by the unit quaternion `q`. */
function turned({x, y, z, w}, v) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const t = cross([x, y, z], v);
  const u = cross([x, y, z], t);
  return v.map((part, i) => part + 2 * (w * t[i] + u[i]));
}
const near = (a, b) => a.every((part, i) => Math.abs(part - b[i]) < 1e-9);

test('a probe stands upright on the skin, its face along the picture’s rows', () => {
  for (const [x, y, z] of [[0, 0, 1], [0.6, 0, 0.8], [1, 0, 0]])
    assert.ok(near(turned(uprightOn({x, y, z}), [0, 1, 0]), [x, y, z]));
  assert.ok(near(turned(uprightOn({x: 0, y: 0, z: 1}), [1, 0, 0]), [1, 0, 0]));
});

test('the probe’s cable leaves the hand at its back, and its long side lies across the hand', () => {
  const hand = uprightOn({x: 0, y: 0, z: 1}).identity();  // the hand's axes are the scene's: z out of its back
  assert.ok(near(turned(inHand(hand), [0, 1, 0]), [0, 0, 1]));
  assert.ok(near(turned(inHand(hand), [1, 0, 0]), [1, 0, 0]));
});
