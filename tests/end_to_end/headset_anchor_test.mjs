// An emulated headset is anchored to the end-effector of a scripted station: node headset_anchor_test.mjs STAGE VIEWER_DIR
// TELEPALP_MIXED. With TELEPALP_PICTURES=DIR pictures of the page are written there.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import test from 'node:test';

import {openBrowser, status, untilStatus} from './browser.mjs';
import {until, Workplace} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const IWER = readFileSync(join(borrowed.resolve('iwer'), '../../build/iwer.min.js'), 'utf8');
const [stage, viewer, mixed] = process.argv.slice(2);
const pictures = process.env.TELEPALP_PICTURES;

/** Where the device really stands in the headset's space: turned by 0.6 rad about the vertical. */
const TRUTH = {angle: 0.6, x: 0.1, y: 0.9, z: -0.5};
const inHeadset = ([x, y, z]) => {
  const [cos, sin] = [Math.cos(TRUTH.angle), Math.sin(TRUTH.angle)];
  return [TRUTH.x + cos * x + sin * z, TRUTH.y + y, TRUTH.z + cos * z - sin * x];
};
/** Counts the frames of a headset's session: without a graphics card there are few a second. */
const COUNT_FRAMES = 'window.xrFrames = 0; const askedFrame = XRSession.prototype.requestAnimationFrame; ' +
    'XRSession.prototype.requestAnimationFrame = function(draw) { ' +
    'return askedFrame.call(this, (time, frame) => { draw(time, frame); ++window.xrFrames; }); };';
const PLACES = [[-0.1, 0.1, 0.06], [0.1, 0.1, 0.06], [0, 0.12, -0.11]];

test('a controller touches the end-effector at three places, and the patient is placed where he is felt', async () => {
  const workplace = new Workplace('headset_anchor');
  let browser;
  try {
    const child = workplace.start(stage, ['--http-port', '0', '--viewer', viewer]);
    const address = await until('the stage listens', () => /http:\S+/.exec(child.heard)?.[0]);
    browser = await openBrowser(workplace.folder, {width: 390, height: 420});
    const {page, problems} = browser;
    const loaded = [];
    page.on('request', (request) => loaded.push(request.url()));
    await page.addInitScript(`${IWER}; window.device = new IWER.XRDevice(IWER.metaQuest3); ` +
        'device.installRuntime({forceInstall: true}); window.controller = device.controllers.right; ' + COUNT_FRAMES);
    await page.goto(`${address}?mesh=off`);
    await untilStatus(page, 'the page is connected', (now) => now.connected);
    await page.waitForSelector('#anchor', {state: 'visible'});
    const asked = () => loaded.some((url) => url.endsWith('/mixed.js'));
    assert.ok(!asked(), 'nothing of it is loaded before it is asked for');
    assert.equal((await status(page)).anchorRms_m, undefined);

    const put = (at, turn = [0, 0, 0, 1]) => page.evaluate(([at, turn]) => {
      window.controller.position.set(...at);
      window.controller.quaternion.set(...turn);
    }, [at, turn]);
    const trigger = (value) => page.evaluate((value) => window.controller.updateButtonValue('trigger', value), value);
    const drawn = () => page.evaluate(() => window.xrFrames);
    const frames = async (count) => {
      const enough = (await drawn()) + count;
      await until(`${count} frames`, async () => (await drawn()) >= enough, 120_000);
    };

    await page.evaluate(() => document.getElementById('anchor').click());
    await page.waitForSelector('#headset[aria-pressed="true"]', {state: 'attached'});
    assert.ok(asked(), 'the part is loaded now');
    // The controller's end is its own place here: it turns about it.
    await put([0, 1, -0.3]);
    await trigger(1);
    for (let i = 0; i < 24; ++i) {
      const half = 0.35;
      await put([0, 1, -0.3], [Math.sin(half) * Math.cos(i), 0, Math.sin(half) * Math.sin(i), Math.cos(half)]);
      await frames(1);
    }
    await trigger(0);
    for (const place of PLACES) {
      const shown = async () => String((await status(page)).handPosition_m);
      const formerly = await shown();
      child.stdin.write(`at ${place.join(' ')}\n`);
      await until('the page shows the end-effector at its new place', async () => (await shown()) !== formerly, 60_000);
      await put(inHeadset(place), [0, 0.2, 0, Math.sqrt(1 - 0.04)]);
      const {anchorTouches: before} = await status(page);
      // As a user does: pull the trigger again where the page says that the end-effector still moves.
      await until('the touch is taken', async () => {
        await frames(24);
        await trigger(1);
        await frames(2);
        await trigger(0);
        await frames(2);
        return (await status(page)).anchorTouches > before;
      }, 60_000);
    }
    const {anchorRms_m} = await untilStatus(page, 'the headset is anchored', (now) => now.anchorRms_m !== undefined, 20_000);
    assert.ok(anchorRms_m < 1e-3, `the touches miss by ${anchorRms_m} m`);
    if (pictures !== undefined) {
      mkdirSync(pictures, {recursive: true});
      await page.screenshot({path: join(pictures, 'headset-anchored.png')});
    }

    const saved = page.waitForEvent('download');
    await page.evaluate(() => document.getElementById('save-touches').click());
    const file = join(workplace.folder, 'touches.csv');
    await (await saved).saveAs(file);
    execFileSync(mixed, ['anchor', '--touches', file, '--out', join(workplace.folder, 'anchor.csv')]);
    const [x, y, z, rx, ry, rz] = readFileSync(join(workplace.folder, 'anchor.csv'), 'utf8').split('\n')[1].split(',').map(Number);
    for (const [found, expected] of [[x, TRUTH.x], [y, TRUTH.y], [z, TRUTH.z], [rx, 0], [ry, TRUTH.angle], [rz, 0]])
      assert.ok(Math.abs(found - expected) < 2e-3, `${[x, y, z, rx, ry, rz]} is not the truth`);

    await page.evaluate(() => document.getElementById('anchor').click());
    await untilStatus(page, 'a second press begins again', (now) => now.anchorRms_m === undefined);
    await page.evaluate(() => document.getElementById('headset').click());
    await page.waitForSelector('#headset[aria-pressed="false"]', {state: 'attached'});
    assert.deepEqual(problems, []);
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});
