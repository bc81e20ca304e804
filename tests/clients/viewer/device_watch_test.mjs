// When the page says that the device swings, or that its drive is at the limit:
// node device_watch_test.mjs VIEWER_SOURCES VIEWER_WORK TELEPALP_REPLAY
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import test from 'node:test';

import {decoders, readIndexed} from '../../npm/mcap_file.mjs';
import {bundled} from './bundled.mjs';

const {DeviceWatch, isOwnSwing} = await bundled('present/device_watch.ts');
const replay = process.argv[4];

const IN_BODY = 1;
const OUT_BODY = 3;

/** A state of the station at `at_s`; heights in metres along y. */
const state = (at_s, {device, hand, force_N = 0, phase = OUT_BODY}) => ({
  stampNs: BigInt(Math.round(1e9 * at_s)), phase, forceN: {x: 0, y: force_N, z: 0},
  device: {x: 0, y: device, z: 0}, hand: {x: 0, y: hand, z: 0},
});

/** The motions seen in 3 s of states at 100 Hz, looked at ten times a second as the page does. */
function motions(of, seconds = 3) {
  const watch = new DeviceWatch();
  const seen = [];
  for (let tick = 0; tick < 100 * seconds; ++tick) {
    watch.stateCame(state(10 + tick / 100, of(tick / 100)));
    if (tick % 10 === 9) seen.push(watch.motion);
  }
  return seen;
}

const wave = (width_m, hertz, at_s) => (width_m / 2) * Math.sin(2 * Math.PI * hertz * at_s);
const steps = (width_m, at_s) => width_m * ((Math.floor(7 * at_s) * 0.618) % 1);  // a place that is measured anew at times

const owns = (seen, pointerRests) => seen.filter(({swing}) => swing !== undefined && isOwnSwing(swing, pointerRests));

for (const width_mm of [4, 8])
  test(`a swing of ${width_mm} mm, 4.3 times a second, around a hand that rests is told within 1.5 s`, () => {
    const seen = motions((at_s) => ({device: 0.05 + wave(width_mm / 1000, 4.3, at_s), hand: 0.05, force_N: 3}));
    assert.ok(owns(seen.slice(0, 15), false).length > 0);
    const {swing} = seen.at(-1);
    assert.ok(Math.abs(swing.hertz - 4.3) < 0.5 && Math.abs(1000 * swing.width_m - width_mm) < 0.2, JSON.stringify(swing));
  });

test('a pointer that rests is believed more than its hand, whose place varies with the noise of the skin', () => {
  const seen = motions((at_s) => ({device: wave(0.006, 4.3, at_s), hand: steps(0.012, at_s)}));
  assert.equal(owns(seen, false).length, 0);
  assert.ok(owns(seen, true).length > 0);
});

const CALM = {
  'a fast palpation': (at_s) => ({device: wave(0.024, 3, at_s - 0.04), hand: wave(0.03, 3, at_s), phase: IN_BODY, force_N: 3}),
  'a breathing patient': (at_s) => ({device: wave(0.02, 0.4, at_s), hand: 0, phase: IN_BODY}),
  'a trembling hand': (at_s) => ({device: wave(0.002, 6, at_s), hand: wave(0.002, 6, at_s)}),
  'one press': (at_s) => ({device: -0.04 * Math.min(1, at_s), hand: -0.04, phase: IN_BODY, force_N: 4}),
};
for (const [what, of] of Object.entries(CALM))
  test(`${what} is no swing`, () => {
    const seen = motions(of);
    assert.equal(owns(seen, false).length, 0);
    assert.ok(seen.every(({driveIsFull}) => !driveIsFull));
  });

test('a drive at its limit is told after a second, and a short push of it is not', () => {
  const pushes = (seconds) => motions((at_s) => ({device: 0, hand: 0.1, force_N: at_s < seconds ? 3 : 0.5}));
  assert.ok(pushes(3).some(({driveIsFull}) => driveIsFull));
  assert.ok(pushes(0.5).every(({driveIsFull}) => !driveIsFull));
});

/** The states of a run of the real controller in virtual time. */
async function statesOf(hand, folder) {
  const out = join(folder, hand);
  execFileSync(replay, ['synthetic:torso,width=160', '--seconds', '12', '--hand', hand, '--out', out], {stdio: 'pipe'});
  const {reader, messages} = await readIndexed(join(out, 'session.mcap'));
  const decode = decoders(reader.schemasById);
  return messages.flatMap((message) => {
    const {topic, schemaId} = reader.channelsById.get(message.channelId);
    if (topic !== '/station/state') return [];
    const {stamp_ns, phase, force_N, device, hand: tracked} = decode.get(schemaId)(message.data);
    return [{stampNs: BigInt(stamp_ns.toString()), phase, forceN: force_N, device, hand: tracked}];
  });
}

for (const hand of ['tap', 'examine'])
  test(`the hand that is named ${hand}, on the real controller, is never called a swing`, async () => {
    const folder = mkdtempSync(join(tmpdir(), 'telepalp_device_watch_'));
    try {
      const watch = new DeviceWatch();
      const states = await statesOf(hand, folder);
      assert.ok(states.length > 1000, `${states.length} states`);
      states.forEach((one, at) => {
        watch.stateCame(one);
        if (at % 10 !== 9) return;
        const {swing, driveIsFull} = watch.motion;
        assert.ok(swing === undefined || !isOwnSwing(swing, false), `at state ${at}: ${JSON.stringify(swing)}`);
        assert.equal(driveIsFull, false, `at state ${at}`);
      });
    } finally {
      rmSync(folder, {recursive: true});
    }
  });
