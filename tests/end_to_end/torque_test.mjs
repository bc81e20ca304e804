// node torque_test.mjs SCENES BIN_DIR VIEWER_FILES: a needle on a device with six degrees of freedom presses a membrane with
// its tip, 50 mm beside the hand: the page shows the torque as a ring around the device's ball, and as a number. With
// TELEPALP_PICTURES=DIR the picture torque.png is written there.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {lookAtMiddle, openBrowser, status, untilStatus} from './browser.mjs';
import {NeedleDevice} from './needle_device.mjs';
import {until, Workplace} from './running_program.mjs';

const [scenes, binDir, viewer] = process.argv.slice(2);
const LEVER_M = 0.05;
const RING = [0xd9, 0x8c, 0xff];  // its colour
const place = new Workplace('torque');
let browser, device, page, station;
let depth_m = 0.023;

before(async () => {
  const {port, http_port} = await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic:torso,motion=hold,width=160', '--viewer', viewer]);
  device = await NeedleDevice.open();
  const scene = join(place.folder, 'needle.scene.textproto');
  const shipped = readFileSync(join(scenes, 'membrane.scene.textproto'), 'utf8');
  writeFileSync(scene, shipped.replace('tears_at_N: 2.5', `tears_at_N: 15 tip_m { x: ${LEVER_M} }`) +
    'age_limits { device_s: 1 surface_s: 10 tracker_s: 10 }\n');  // this device and the browser share a processor
  station = place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`, '--scene', scene, '--control', 'none',
    '--device', `udp:127.0.0.1:${device.port}`, '--tracker', 'held']);
  browser = await openBrowser(place.folder);
  page = browser.page;
  await page.goto(`http://127.0.0.1:${http_port}/?view=doctor`);
  await untilStatus(page, 'the page is connected', (now) => now.connected);
  await until('the station has a surface', () => /touchable/.test(station.heard));
});
after(async () => {
  await browser?.context.close();
  device?.close();
  await place.end();
});

const ringPixels = async () => (await lookAtMiddle(browser.context, await page.screenshot(), RING)).alike;

/** undefined below 0.05 N m. */
async function shownTorque_N_m() {
  const shown = /^torque ([\d.]+) N m$/.exec(await page.textContent('#torque'))?.[1];
  return Number(shown ?? 0) > 0.05 ? Number(shown) : undefined;
}

/** Presses 5 mm deeper, down to 0.1 m: the slower this computer answers the device, the softer is the spring between it and
 * the tool, and the deeper must the device be where the tool reaches the membrane. */
async function pressDeeper() {
  if (depth_m < 0.1) {
    depth_m += 0.005;
    await device.move([0, -depth_m, 0]);
  }
  return shownTorque_N_m();
}

async function explain(late) {
  assert.fail(`${late.message}; ${depth_m} m, ${JSON.stringify([await status(page), device.wrench])} ${station.heard}`);
}

test('without contact there is neither ring nor torque', async () => {
  await device.move([0, 0.03, 0]);
  assert.equal(await shownTorque_N_m(), undefined);
  assert.ok((await ringPixels()) < 20);
});

test('a needle that presses beside the hand gives a torque: a ring, and its number', async () => {
  const torque_N_m = await until('the page shows a torque', pressDeeper).catch(explain);
  const [x, y, z] = device.wrench.torque_N_m;
  assert.ok(Math.hypot(x, y) < 0.05 * z, 'the lever along x and the force along y turn about z');
  assert.ok(torque_N_m <= LEVER_M * 10 && torque_N_m > 0.05, String(torque_N_m));
  await until('the ring is drawn', async () => (await ringPixels()) > 150).catch(explain);
  if (process.env.TELEPALP_PICTURES) await page.screenshot({path: join(process.env.TELEPALP_PICTURES, 'torque.png')});
});
