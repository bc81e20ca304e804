// node protocol_device_test.mjs BIN_DIR [PICTURES]: a person's protocol at a haptic device, which speaks the UDP protocol:
// the page tells what to do, the device moves the needle and gets the force, and the sitting is a session file.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {openBrowser, savePicture} from './browser.mjs';
import {NeedleDevice} from './needle_device.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, pictures] = process.argv.slice(2);  // PICTURES: a folder for screenshots, to be looked at
const place = new Workplace('protocol-device');
const list = join(place.folder, 'one.txt');
const out = join(place.folder, 'out');
writeFileSync(list, 'name=short l_h=100\n');
let browser, child, device, page;

before(async () => {
  device = await NeedleDevice.open();
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  child = place.start(join(binDir, 'telepalp-study'),
                      ['protocol', '--design', list, '--participant', 'p08', '--conditions', 'both', '--training', '0',
                       '--penetrations', '1', '--device', `udp:127.0.0.1:${device.port}`, '--out', out]);
  await page.goto(await until('the address is printed', () => {
    if (child.exitCode !== null) throw new Error(child.heard);
    return /^http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}$/m.exec(child.heard)?.[0];
  }));
  await until('the page is live', () => page.evaluate(() => window.protocol?.state !== undefined));
});
after(async () => {
  await browser?.context.close();
  device?.close();
  await place.end();
});

const protocol = () => page.evaluate(() => ({state: window.protocol.state, frame: window.protocol.frame}));

test('the device moves the needle and gets its force; the mouse moves nothing', async () => {
  assert.equal((await protocol()).state.device, true);
  // Where the device was silent for a moment, the page refuses to begin, says so, and waits for the next press.
  await until('the needle is seen', async () => {
    await page.keyboard.press('Space');
    await sleep(1000);
    return (await protocol()).frame?.seen !== undefined;
  });
  assert.match(await page.textContent('#do'), /Hold the end-effector/);
  await page.keyboard.press('ArrowRight', {delay: 200});
  assert.equal((await protocol()).state.stage, 'ready', 'an arrow key is no hand');
  let at = [0, 0.1, 0];
  let most_N = 0;
  for (let i = 0; i < 120; ++i) {
    const {state, frame} = await protocol();
    if (state.done === 1 || !frame) break;
    at = [at[0] + 0.001 * frame.along[0], at[1] + 0.001 * frame.along[1], 0];
    await device.move(at);
    most_N = Math.max(most_N, Math.hypot(...device.wrench.force_N));
    if (i === 40) await savePicture(page, pictures, 'device-inserting');
  }
  assert.ok(most_N > 0.3 && most_N <= 10, `${most_N} N`);
  await page.waitForFunction(() => window.protocol.state.done === 1, undefined, {timeout: 40_000});
});

test('the report says that force was felt, and the sitting is a session', async () => {
  await until('the program ends', () => child.exitCode !== null);
  assert.equal(child.exitCode, 0, child.heard);
  assert.match(readFileSync(join(out, 'report.html'), 'utf8'), /worked at a haptic device and felt the force/);
  const files = readdirSync(join(out, 'sessions'));
  assert.deepEqual(files, ['p08-0001.mcap']);
  const file = join(out, 'sessions', files[0]);
  assert.match(execFileSync(join(binDir, 'telepalp-record'), ['verify', file], {encoding: 'utf8'}), /whole|no damage|messages/);
  const csv = join(place.folder, 'ticks.csv');
  execFileSync(join(binDir, 'telepalp-export'), [file, '--csv', '/station/ticks', '--out', csv]);
  assert.ok(readFileSync(csv, 'utf8').split('\n').length > 100, 'the ticks of the penetration');
  execFileSync(join(binDir, 'telepalp-report'), [file, '--out', join(place.folder, 'report.html')]);
  assert.deepEqual(browser.problems.filter((problem) => !/WebSocket|ERR_CONNECTION/.test(problem)), []);
});
