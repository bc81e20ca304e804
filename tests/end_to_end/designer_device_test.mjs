// node designer_device_test.mjs BIN_DIR [PICTURES]: the designer's page at a haptic device, which speaks the UDP protocol:
// the hand feels the handle, grasps it by the device's button, pushes the needle through the sac, and lets go; the space
// bar is a button, too; a second page takes the device over; a silent device is told.
import assert from 'node:assert/strict';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {violations} from './accessibility.mjs';
import {openBrowser, savePicture} from './browser.mjs';
import {NeedleDevice} from './needle_device.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, pictures] = process.argv.slice(2);  // PICTURES: a folder for screenshots, to be looked at
const place = new Workplace('designer-device');
let browser, child, device, page, address;

before(async () => {
  device = await NeedleDevice.open();
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  child = place.start(join(binDir, 'telepalp-study'),
                      ['designer', '--operators', '2', '--device', `udp:127.0.0.1:${device.port}`]);
  address = await until('the address is printed', () => {
    if (child.exitCode !== null) throw new Error(child.heard);
    return /^http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}$/m.exec(child.heard)?.[0];
  });
  await page.goto(address);
  await until('the hand is drawn', async () => (await frame())?.held === null);
});
after(async () => {
  await browser?.context.close();
  device?.close();
  await place.end();
});

const frame = () => page.evaluate(() => window.designer.frame);
const force_N = () => Math.hypot(...device.wrench.force_N);
const START = [0, 0.1, 0];  // of the device; the handle's end is 30 mm below
/** Moves the hand, and waits until the page has drawn what is there. */
async function move(to) {
  await device.move(to);
  await sleep(200);
}

test('the handle is felt before it is grasped, and the linkage stays', async () => {
  const {tip} = await frame();
  assert.ok(force_N() < 0.01, 'nothing is touched');
  await move([0, START[1] - 0.0235, 0]);
  await until('the handle is touched', async () => (await frame()).touched === 'handle');
  assert.ok(device.wrench.force_N[1] > 0.5 && force_N() < 3, `${device.wrench.force_N} N`);
  assert.deepEqual((await frame()).tip, tip);
  await savePicture(page, pictures, 'designer-device-touched');
  assert.deepEqual(await violations(page), []);
});

/** From outside into the handle's end, until it is touched. A device that was silent for 50 ms must come from outside. */
async function touchTheEnd() {
  await until('the handle is touched', async () => {
    await move(START);
    const {c, grasp} = await frame();
    await move([START[0] + 1e-3 * (c[0] - grasp[0]), START[1] + 1e-3 * (c[1] - grasp[1]) + 0.0065, 0]);
    return (await frame()).touched === 'handle';
  });
}

/** Pushes the held handle's end along its way until the sac gives way. Returns the greatest force on the hand. */
async function push(from_m) {
  const {reach, frame: from} = await page.evaluate(() => ({reach: window.designer.design.reach, frame: window.designer.frame}));
  let most_N = 0;
  for (const [, x, y] of reach.filter(([link3]) => link3 > from.link3)) {
    await device.move([from_m[0] + 1e-3 * (x - from.c[0]), from_m[1] + 1e-3 * (y - from.c[1]), 0]);
    most_N = Math.max(most_N, force_N());
    if ((await frame()).layers.sac === 'inside') break;
  }
  return most_N;
}

test('the button grasps it, the hand pushes the needle through the sac and feels it', async () => {
  let most_N = 0;
  await until('the sac is punctured', async () => {
    device.pressed = false;  // where the device was silent for a moment, the hand has let go, and begins anew
    await page.click('#renew');
    await touchTheEnd();
    device.pressed = true;
    await sleep(500);
    if ((await frame()).held !== 'handle') return false;
    most_N = await push(device.at_m);
    return (await frame()).layers.sac === 'inside';
  });
  assert.ok(most_N > 0.3 && most_N <= 10, `${most_N} N`);
  await until('the fall is told', async () => /^Sac punctured/.test(await page.textContent('#puncture')));
  await savePicture(page, pictures, 'designer-device-punctured');
});

test('a slider changes a length in the hand, with the needle where it is', async () => {
  const {b, o} = await frame();
  const l3 = Math.hypot(b[0] - o[0], b[1] - o[1]);
  let most_N = 0;
  await page.fill('#value-l3', String(l3 + 8));
  await page.press('#value-l3', 'Tab');
  await until('link 3 has grown', async () => {
    most_N = Math.max(most_N, force_N());
    const now = await frame();
    return Math.abs(Math.hypot(now.b[0] - now.o[0], now.b[1] - now.o[1]) - l3 - 8) < 0.01;
  });
  assert.equal((await frame()).held, 'handle');
  assert.equal((await frame()).layers.skin, 'inside', 'the same tissue');
  assert.ok(most_N <= 10, `${most_N} N`);
});

test('the button lets go; the space bar grasps, too; keys and sliders do what they say', async () => {
  const {tip} = await frame();
  device.pressed = false;
  await until('nobody holds it', async () => (await frame()).held === null);
  assert.ok(Math.hypot(...(await frame()).tip.map((value, axis) => value - tip[axis])) < 0.5, 'the linkage stays');
  await page.fill('#value-l_h', '150');
  await page.press('#value-l_h', 'Tab');
  await until('the new linkage is outside', async () => (await frame()).layers.skin === 'outside');
  await touchTheEnd();
  await page.click('h1');
  await page.keyboard.down('Space');
  await until('the handle is held', async () => (await frame()).held === 'handle');
  await page.keyboard.up('Space');
  await until('nobody holds it', async () => (await frame()).held === null);
});

test('a page that opens later has the device, and the first one says so', async () => {
  const second = await browser.context.newPage();
  await second.goto(address);
  await until('the second page has it', () => second.evaluate(() => window.designer.frame?.held === null));
  await until('the first one says so', async () => /another page has the haptic device/i.test(await page.textContent('#device')));
  await second.close();
  await page.reload();
  await until('the hand is drawn', async () => (await frame())?.held === null);
});

test('a silent device is told, and Ctrl-C ends the program', async () => {
  device.close();
  device = undefined;
  await until('it is told', async () => /does not answer/.test(await page.textContent('#device')));
  child.kill('SIGINT');
  await child.over;
  assert.equal(child.exitCode, 0, child.heard);
  assert.deepEqual(browser.problems.filter((problem) => !/WebSocket|ERR_CONNECTION/.test(problem)), []);
});
