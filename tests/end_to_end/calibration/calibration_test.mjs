// node calibration_test.mjs BIN_DIR VIEWER_FILES: a technician calibrates tracker and device in the page, through the
// real server and station. Device and tracker are a program that speaks their protocols, with a known place of the
// tracker. With TELEPALP_PICTURES=DIR the picture of docs/ is written there.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {promisify} from 'node:util';

import {violations} from '../accessibility.mjs';
import {openBrowser, untilStatus} from '../browser.mjs';
import {until, Workplace} from '../running_program.mjs';
import {HAPTIC_FROM_TRACKER_M} from './measured_rig.mjs';

const PLACES_M = [[0, 0.06, 0], [0.05, 0.06, 0.02], [-0.03, 0.09, -0.04]];
const pictures = process.env.TELEPALP_PICTURES;
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('calibration');
const control = join(place.folder, 'station.control');
const station = resolve(binDir, 'telepalp-station');
const run = (...args) => promisify(execFile)(station, args, {cwd: place.folder});
let browser, page, rig;

before(async () => {
  rig = place.start(process.execPath, [fileURLToPath(new URL('measured_rig.mjs', import.meta.url))]);
  const [, udp, leap] = await until('the rig listens', () => /udp=(\d+) leap=(\d+)/.exec(rig.heard) ?? undefined);
  const {port, http_port} = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer]);
  const child = place.start(station, ['--connect', `127.0.0.1:${port}`, '--scene', 'calibration', '--control', control,
    '--device', `udp:127.0.0.1:${udp}`, '--tracker', `leap:ws://127.0.0.1:${leap}/v6.json`]);
  await until('the control loop runs', () => child.heard.includes('the control loop runs at 2 kHz'));
  browser = await openBrowser(place.folder, {width: 1280, height: 1080});
  page = browser.page;
  await page.goto(`http://127.0.0.1:${http_port}/?view=technician&mesh=off`);
  await page.waitForSelector('#calibration', {state: 'visible', timeout: 60_000});
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const text = (id) => page.textContent(`#${id}`);
const row = (list, name) => page.evaluate(([id, wanted]) =>
  [...document.querySelectorAll(`#${id} div`)].find((line) => line.firstChild.textContent === wanted)?.lastChild.textContent, [list, name]);

async function carryTo(at) {
  const before = rig.heard.length;
  rig.stdin.write(`go ${at.join(' ')}\n`);
  await until('hand and end-effector are there', () => rig.heard.includes('there', before));
}

/** Presses the button and waits for the place's row. A machine that halts for a second may cause a fault: it is ended. */
async function take(number, press) {
  await press();
  await until(`place ${number} is taken`, async () => {
    if (/fault/.test(await text('calibration-said'))) await run('rearm', '--control', control).catch(() => {});
    return (await row('calibration-places', `Place ${number}`)) !== undefined;
  });
}

async function savedPairs(name) {
  await page.focus('#calibration-save');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  assert.equal(download.suggestedFilename(), 'pairs.csv');
  const file = join(place.folder, name);
  await download.saveAs(file);
  return file;
}

test('three places by mouse and keyboard give the place of the tracker, and the station computes the same', async () => {
  assert.equal(await page.isDisabled('#calibration-save'), true, 'without pairs there is nothing to save');
  await untilStatus(page, 'the device gives no force', (now) => now.force_N === 0);
  await carryTo(PLACES_M[0]);
  await take(1, () => page.click('#calibration-take'));
  assert.match(await text('calibration-verdict'), /^Good so far\. Measure three places/);
  for (const [index, at] of PLACES_M.slice(1).entries()) {
    await carryTo(at);
    await page.focus('#calibration-take');
    await take(index + 2, () => page.keyboard.press('Enter'));
  }
  assert.equal(await text('calibration-verdict'), 'Good: the places agree.');
  const shown_mm = (await row('calibration-fit', 'Translation')).split(', ').map(Number.parseFloat);
  shown_mm.forEach((value, axis) =>
    assert.ok(Math.abs(value - 1000 * HAPTIC_FROM_TRACKER_M[axis]) < 0.5, `translation ${shown_mm} mm`));
  const rms_mm = Number.parseFloat(await row('calibration-fit', 'Residual'));
  assert.ok(rms_mm < 1, `${rms_mm} mm; the tracker's noise is 0.3 mm at most`);
  for (const theme of ['dark', 'light']) {
    assert.deepEqual(await violations(page, '#calibration'), [], theme);
    await page.focus('#scene');
    await page.keyboard.press('l');
  }
  if (pictures !== undefined) await keepPicture();

  const file = await savedPairs('pairs.csv');
  const command = (await text('calibration-command')).split(' ').slice(1);
  assert.equal(readFileSync(file, 'utf8').trim().split('\n').length, 151, 'a header and 50 pairs a place');
  assert.match((await run(...command)).stdout, /haptic_from_tracker from 150 measurements/);
  const written = readFileSync(join(place.folder, 'site.calibration.textproto'), 'utf8');
  const number = (name) => Number(new RegExp(`\\b${name}: (\\S+)`).exec(written)[1]);
  assert.ok(Math.abs(1000 * number('residual_rms_m') - rms_mm) < 0.01, `${written}: the page says ${rms_mm} mm`);
  ['x', 'y', 'z'].forEach((axis, at) => assert.ok(Math.abs(1000 * number(axis) - shown_mm[at]) < 0.1, `${axis} of ${written}`));
  await run('--calibration', 'site.calibration.textproto', '--check');
});

test('a hand that slips on the end-effector is named, and its pairs are refused by the station, too', async () => {
  await page.focus('#calibration-again');
  await page.keyboard.press('Space');
  assert.equal(await text('calibration-verdict'), 'At least 10 pairs are needed.');
  rig.stdin.write('slip on\n');
  await take(1, () => page.click('#calibration-take'));
  assert.equal(await text('calibration-verdict'), 'The hand moved at place 1: press Begin again.');
  const file = await savedPairs('slipped.csv');
  await assert.rejects(run('calibrate', 'offset', '--pairs', file), /the hand moved on the end-effector/);
  assert.deepEqual(browser.problems, []);
});

async function keepPicture() {
  await page.locator('#calibration').screenshot({path: join(pictures, 'calibration.jpg'), type: 'jpeg', quality: 85, timeout: 120_000});
}
