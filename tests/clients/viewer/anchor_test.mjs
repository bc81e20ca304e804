// node anchor_test.mjs VIEWER_SOURCES VIEWER_WORK TELEPALP_MIXED: a headset anchored to the haptic device by touches.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {anchorHeadset, fitRigid, isRefusal, pivotTip} = await bundled('mixed/anchor_fit.ts');
const {Anchoring} = await bundled('mixed/anchoring.ts');
const {after, inverse, matrixOf, moved, norm, minus, turn} = await bundled('mixed/rigid.ts');
const {eigenpairs} = await bundled('mixed/symmetric.ts');
const [, , , , program] = process.argv;

const point = (x, y, z) => ({x, y, z});
const about = (x, y, z, angle) => {
  const scale = Math.sin(angle / 2) / Math.hypot(x, y, z);
  return {x: scale * x, y: scale * y, z: scale * z, w: Math.cos(angle / 2)};
};

/** Normal numbers from a seed. */
function normals(seed) {
  let state = BigInt(seed) * 0x9E3779B97F4A7C15n;
  const uniform = () => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return (Number(state >> 11n) + 0.5) / 2 ** 53;
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}
const around = (normal, scale) => point(scale * normal(), scale * normal(), scale * normal());
const sum = (a, b) => point(a.x + b.x, a.y + b.y, a.z + b.z);

test('without noise an anchor is exact and proper, with gravity known and unknown', () => {
  const truth = {rotation: about(0, 1, 0, 2.5), translation: point(1, 2, 3)};
  const touches = [point(0, 0, 0), point(0.2, 0, 0), point(0, 0, 0.25)]
      .map((known, place) => ({place, known, touched: moved(truth, known)}));
  for (const level of [true, false]) {
    const anchor = anchorHeadset(touches, level);
    assert.ok(anchor.rms_m < 1e-9);
    matrixOf(anchor.headsetFromDevice).forEach((value, i) => assert.ok(Math.abs(value - matrixOf(truth)[i]) < 1e-7, `${i}`));
  }
  const tilted = {rotation: about(1, 0.3, -0.5, 1.9), translation: point(-0.4, 1.1, 0.2)};
  const cloud = Array.from({length: 12}, () => around(normals(5), 0.1)).map((at, i) => sum(at, point(0.01 * i * i, 0.02 * i, 0)));
  const found = fitRigid(cloud, cloud.map((at) => moved(tilted, at)));
  matrixOf(found).forEach((value, i) => assert.ok(Math.abs(value - matrixOf(tilted)[i]) < 1e-7, `${i}`));
});

/** The errors of many anchors by touches with 1 mm of noise an axis: [patient seen against felt, turn], RMS. */
function errors(repeats, level) {
  const seeds = 400;
  let [squares, turns] = [0, 0];
  for (let seed = 1; seed <= seeds; ++seed) {
    const normal = normals(seed);
    const truth = {rotation: about(0, 1, 0, 3 * normal()), translation: around(normal, 1)};
    const touches = [0, 1, 2].flatMap((place) => {
      const known = point(0.2 / Math.sqrt(3) * Math.cos(2.0943951 * place), 0.02, 0.2 / Math.sqrt(3) * Math.sin(2.0943951 * place));
      return Array.from({length: repeats}, () => ({place, known, touched: sum(moved(truth, known), around(normal, 1e-3))}));
    });
    const error = after(inverse(truth), anchorHeadset(touches, level).headsetFromDevice);
    const far = around(normal, 1);
    const target = point(0.1 * far.x / norm(far), 0.1 * far.y / norm(far), 0.1 * far.z / norm(far));
    squares += norm(minus(moved(error, target), target)) ** 2 / seeds;
    turns += (2 * Math.acos(Math.min(1, Math.abs(error.rotation.w)))) ** 2 / seeds;
  }
  return [1e3 * Math.sqrt(squares), Math.sqrt(turns) * 180 / Math.PI];
}

test('three touches place the patient within 1.4 mm and 0.65 degrees, five a point within 0.6 mm and 0.3 degrees', (context) => {
  const [one_mm, one_deg] = errors(1, true);
  const [five_mm, five_deg] = errors(5, true);
  context.diagnostic(`three touches ${one_mm.toFixed(2)} mm, ${one_deg.toFixed(2)} deg; five a point ${five_mm.toFixed(2)} mm, ${five_deg.toFixed(2)} deg`);
  assert.ok(one_mm <= 1.4 && one_deg <= 0.65);
  assert.ok(five_mm <= 0.6 && five_deg <= 0.3);
});

test('touches from which no place follows are refused with a sentence', () => {
  assert.match(anchorHeadset([], true).what, /Only 0 places/);
  const line = [0, 1, 2].map((place) => ({place, known: point(0.1 * place, 0, 0), touched: point(0.1 * place, 0, 0)}));
  assert.match(anchorHeadset(line, true).what, /on a line/);
  line[1] = {...line[1], known: point(0.1, 0, 0.2)};
  assert.match(anchorHeadset(line, false).what, /miss their places by/);
  line[0] = {...line[0], touched: point(NaN, 0, 0)};
  assert.match(anchorHeadset(line, true).what, /not finite/);
});

test('a tip is found from poses about it while it rests, and not from one attitude', () => {
  const [tip, rest] = [point(0.01, -0.02, 0.12), point(0.3, 1, -0.2)];
  const poses = Array.from({length: 8}, (_, i) => {
    const rotation = about(Math.cos(i), 0.3, Math.sin(i), 0.5);
    return {rotation, translation: minus(rest, turn(rotation, tip))};
  });
  assert.ok(norm(minus(pivotTip(poses), tip)) < 1e-9);
  assert.ok(isRefusal(pivotTip(Array(8).fill(poses[0]))));
  assert.ok(isRefusal(pivotTip([])));
});

test('eigenpairs are those of the matrix, largest first', () => {
  const matrix = [[4, 1, 0.5, -1], [1, 3, 0.2, 0], [0.5, 0.2, -2, 1], [-1, 0, 1, 0.3]];
  const pairs = eigenpairs(matrix);
  pairs.forEach(({value, vector}, k) => {
    assert.ok(k === 0 || value <= pairs[k - 1].value);
    matrix.forEach((row, i) => assert.ok(Math.abs(row.reduce((all, one, j) => all + one * vector[j], 0) - value * vector[i]) < 1e-9));
  });
});

/** A desk: the device's frame, the scene, and a headset that sees both; the end-effector is where the doctor puts it. */
class Desk {
  constructor(settings = {}) {
    this.anchoring = new Anchoring({paper: false, level: true, repeats: 1, ...settings});
    this.truth = {rotation: about(0, 1, 0, 0.7), translation: point(0.2, 0.8, -0.4)};  // headset_from_device
    this.sceneFromHaptic = {rotation: about(1, 0.2, 0, -1.2), translation: point(0.1, -0.3, -0.8)};
    this.shift = undefined;
    this.device = point(0, 0.1, 0);
  }
  station() {
    const haptic = this.shift ? sum(this.device, this.shift) : this.device;
    const {x, y, z} = moved(this.sceneFromHaptic, haptic);
    return {device: haptic, deviceCamera: {x, y: -y, z: -z}, workspaceShift: this.shift};
  }
  /** Frames with the finger on the end-effector, `off` from it. */
  rest(frames = 25, off = point(0, 0, 0)) {
    for (let i = 0; i < frames; ++i)
      this.anchoring.frame(
          {pose: {rotation: about(0, 1, 0, 0.1), translation: sum(moved(this.truth, this.device), off)}, isFinger: true, palm: undefined}, this.station());
  }
  touch(device, off) {
    this.device = device;
    this.rest(25, off);
    this.anchoring.press();
    this.anchoring.release();
  }
  /** How far the patient is seen from where he is felt [m], at a place of the scene. */
  apart(scene) {
    const haptic = moved(inverse(this.sceneFromHaptic), scene);
    const own = this.shift ? minus(haptic, this.shift) : haptic;
    return norm(minus(moved(this.anchoring.headsetFromScene, scene), moved(this.truth, own)));
  }
}
const PLACES = [point(-0.1, 0.1, 0.06), point(0.1, 0.1, 0.06), point(0, 0.12, -0.11)];
const PATIENT = point(0.05, -0.2, -0.9);

test('three touches of the end-effector show the patient where he is felt', () => {
  const desk = new Desk();
  assert.equal(desk.anchoring.headsetFromScene, undefined);
  PLACES.forEach((place) => desk.touch(place));
  assert.match(desk.anchoring.note, /^Anchored\. The touches miss by 0\.0 mm/);
  assert.ok(desk.apart(PATIENT) < 1e-6);
});

test('the saved pose of a touch has its tip where the touch was taken, though the hand trembled', () => {
  const desk = new Desk();
  desk.device = PLACES[0];
  desk.rest(19);
  desk.rest(1, point(0.003, 0, 0));
  desk.anchoring.press();
  assert.equal(desk.anchoring.taken, 1);
  const row = desk.anchoring.table.trim().split('\n')[1].split(',').map(Number);
  const touched = sum(moved(desk.truth, PLACES[0]), point(0.003 / 20, 0, 0));
  assert.ok(norm(minus(point(row[4], row[5], row[6]), touched)) < 1e-6);
});

test('a shifted workspace moves the patient with it, during the touches and after them', () => {
  const desk = new Desk();
  desk.shift = point(0.02, 0, 0.03);
  desk.touch(PLACES[0]);
  desk.touch(PLACES[1]);
  desk.shift = point(-0.05, 0, 0.01);
  desk.touch(PLACES[2]);
  assert.ok(desk.apart(PATIENT) < 1e-6);
  desk.shift = point(0.1, 0, 0);
  desk.rest(1);
  assert.ok(desk.apart(PATIENT) < 1e-6);
});

test('a touch that moves, is too near to another, or has no hand is not taken, and the note says why', () => {
  const desk = new Desk();
  desk.anchoring.frame(undefined, desk.station());
  desk.anchoring.press();
  assert.match(desk.anchoring.note, /does not see the hand/);
  desk.rest(5);
  desk.anchoring.press();
  assert.match(desk.anchoring.note, /Hold still for a moment/);
  desk.rest(20);
  desk.rest(3, point(0.02, 0, 0));
  desk.anchoring.press();
  assert.match(desk.anchoring.note, /moves: hold still/);
  desk.touch(PLACES[0]);
  assert.equal(desk.anchoring.taken, 1);
  desk.touch(sum(PLACES[0], point(0.05, 0, 0)));
  assert.match(desk.anchoring.note, /at least 15 cm away/);
  desk.anchoring.frame({pose: {rotation: about(0, 1, 0, 0), translation: point(0, 0, 0)}, isFinger: true, palm: undefined}, undefined);
  desk.anchoring.press();
  assert.match(desk.anchoring.note, /station sends no place/);
  assert.equal(desk.anchoring.taken, 1);
});

test('touches beside the end-effector are refused and begun again; a new anchor takes seconds', () => {
  const desk = new Desk();
  desk.touch(PLACES[0]);
  desk.touch(PLACES[1]);
  desk.touch(PLACES[2], point(0.08, 0, 0.05));
  assert.match(desk.anchoring.note, /miss their places by \d+ mm\. Touch the end-effector itself/);
  assert.equal(desk.anchoring.anchor, undefined);
  PLACES.forEach((place) => desk.touch(place));
  assert.ok(desk.apart(PATIENT) < 1e-6);
  desk.truth = {...desk.truth, translation: point(0.5, 0.7, -0.2)};  // the headset was put on elsewhere
  assert.ok(desk.apart(PATIENT) > 0.1);
  desk.anchoring.again();
  assert.equal(desk.anchoring.headsetFromScene, undefined);
  PLACES.forEach((place) => desk.touch(place));
  assert.ok(desk.apart(PATIENT) < 1e-6);
});

test('a controller is calibrated about its end first', () => {
  const desk = new Desk();
  const [tip, rest] = [point(0, -0.03, 0.1), point(0.3, 0.9, -0.2)];
  const at = (end, rotation) => ({pose: {rotation, translation: minus(end, turn(rotation, tip))}, isFinger: false, palm: undefined});
  desk.anchoring.frame(at(rest, about(0, 1, 0, 0)), desk.station());
  assert.match(desk.anchoring.note, /Rest the controller's end/);
  desk.anchoring.press();
  for (let i = 0; i < 40; ++i) desk.anchoring.frame(at(rest, about(0, 1, 0, 0)), desk.station());
  desk.anchoring.release();
  desk.anchoring.frame(at(rest, about(0, 1, 0, 0)), desk.station());
  assert.match(desk.anchoring.note, /turned too little/);
  desk.anchoring.press();
  for (let i = 0; i < 40; ++i) desk.anchoring.frame(at(rest, about(Math.cos(i), 0.2, Math.sin(i), 0.6)), desk.station());
  desk.anchoring.release();
  for (const place of PLACES) {
    desk.device = place;
    for (let i = 0; i < 25; ++i) desk.anchoring.frame(at(moved(desk.truth, place), about(1, 0, 0, -0.4)), desk.station());
    desk.anchoring.press();
    desk.anchoring.release();
  }
  assert.ok(desk.apart(PATIENT) < 1e-6);
});

test('S2\'s one pose of a flat hand anchors without a residual, once the end-effector has moved about', () => {
  const desk = new Desk({paper: true});
  const lay = () => {
    const palm = {rotation: about(0, 1, 0, 0.7), translation: moved(desk.truth, desk.device)};
    for (let i = 0; i < 25; ++i) desk.anchoring.frame({pose: palm, isFinger: true, palm}, desk.station());
    desk.anchoring.press();
    desk.anchoring.release();
  };
  lay();
  assert.match(desk.anchoring.note, /Move the end-effector about first/);
  PLACES.forEach((place) => {
    desk.device = place;
    desk.rest(1);
  });
  desk.device = point(0, 0.1, 0);
  lay();
  assert.match(desk.anchoring.note, /One pose has no residual/);
  assert.ok(desk.apart(PATIENT) < 1e-6);
});

test('telepalp-mixed anchor computes the same from the saved touches', () => {
  const desk = new Desk();
  const normal = normals(3);
  PLACES.forEach((place) => desk.touch(place, around(normal, 1e-3)));
  const folder = mkdtempSync(join(tmpdir(), 'anchor'));
  try {
    writeFileSync(join(folder, 'touches.csv'), desk.anchoring.table);
    const said = execFileSync(program, ['anchor', '--touches', join(folder, 'touches.csv'), '--out', join(folder, 'anchor.csv')]).toString();
    assert.ok(said.includes(`residual ${(1e3 * desk.anchoring.anchor.rms_m).toFixed(2)} mm rms`), said);
    const [x, y, z] = readFileSync(join(folder, 'anchor.csv'), 'utf8').split('\n')[1].split(',').map(Number);
    const {translation} = desk.anchoring.anchor.headsetFromDevice;
    assert.ok(norm(minus(point(x, y, z), translation)) < 1e-5);
  } finally {
    rmSync(folder, {recursive: true});
  }
});
