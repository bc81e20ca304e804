// node ultrasound_test.mjs SCENES BIN_DIR VIEWER_FILES: the page of a station whose hand holds an ultrasound probe on the
// skin: the panel's image, its caliper by mouse and by keyboard, the layers below the skin, and accessibility by axe. With
// TELEPALP_PICTURES=DIR the picture doctor-inside.jpg of docs/ is written there.
import assert from 'node:assert/strict';
import {mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {violations} from './accessibility.mjs';
import {lookAtMiddle, openBrowser, status, untilStatus} from './browser.mjs';
import {sceneOfASteadyProbe, until, Workplace} from './running_program.mjs';

const [scenes, binDir, viewer] = process.argv.slice(2);
const place = new Workplace('ultrasound');
const pictures = process.env.TELEPALP_PICTURES;
let browser, page;

before(async () => {
  const {port, http_port} = await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer]);
  const scene = sceneOfASteadyProbe(scenes, place.folder);
  place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`, '--scene', scene]);
  browser = await openBrowser(place.folder, {width: 1040, height: 700});
  page = browser.page;
  await page.goto(`http://127.0.0.1:${http_port}/?view=doctor`);
  await untilStatus(page, 'images come', (now) => now.connected && now.probeImages > 2)
      .catch(async (late) => assert.fail(`${late.message}: ${JSON.stringify(await status(page))}`));
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const said = () => page.textContent('#ultrasound-said');
const saidIs = (text) => until(text, async () => (await said()) === text);

test('the panel shows an image, and the next ones', async () => {
  const panel = page.locator('#ultrasound-image');
  await until('the panel is not black', async () => {
    const {drawn, colors} = await lookAtMiddle(browser.context, await panel.screenshot({timeout: 120_000}));
    return drawn > 0.3 && colors > 20;
  });
  const {probeImages} = await status(page);
  await untilStatus(page, 'images go on', (now) => now.probeImages > probeImages + 2);
  assert.match(await page.getAttribute('#ultrasound-frame', 'aria-label'), /Ultrasound under the probe/);
  const marks = await page.locator('#ultrasound-scale span').allTextContents();
  assert.deepEqual(marks, ['0', '20', '40', '60', '80', '100']);
});

test('the mouse reads a depth', async () => {
  const {x, y, width, height} = await page.locator('#ultrasound-image').boundingBox();
  await page.mouse.move(x + 0.5 * width, y + 0.4 * height);
  await until('the depth under the pointer', async () => /^(39|40|41) mm deep$/.test(await said()));
  assert.ok(await page.isVisible('#ultrasound-line'));
  await page.mouse.move(x - 200, y);
  await saidIs('Depth in mm');
  assert.equal(await page.isVisible('#ultrasound-line'), false);
});

test('the keyboard reads a depth', async () => {
  await page.focus('#ultrasound-frame');
  for (const [key, text] of [
    ['PageDown', '10 mm deep'], ['ArrowDown', '11 mm deep'], ['ArrowUp', '10 mm deep'], ['PageUp', '0 mm deep'],
    ['ArrowUp', '0 mm deep'], ['Escape', 'Depth in mm'],
  ]) {
    await page.keyboard.press(key);
    await saidIs(text);
  }
});

test('keys hide the panel and show what lies below the skin', async () => {
  await page.keyboard.press('e');
  await page.waitForSelector('#ultrasound', {state: 'hidden'});
  await page.keyboard.press('e');
  await page.waitForSelector('#ultrasound', {state: 'visible'});
  await untilStatus(page, 'the layers have come', (now) => now.innerTriangles > 1000);
  await page.keyboard.press('i');
  assert.equal(await page.getAttribute('#show-inside', 'aria-pressed'), 'true');
  const {frames, probeImages} = await status(page);
  await untilStatus(page, 'pictures and images go on', (now) => now.frames > frames + 1 && now.probeImages > probeImages);
  if (pictures !== undefined) await keepPicture();
  await page.keyboard.press('i');
});

/** The view with the layers below the skin, of which the bottom is cut off. */
async function keepPicture() {
  mkdirSync(pictures, {recursive: true});
  const size = page.viewportSize();
  await page.setViewportSize({width: 1152, height: 640});
  const {frames} = await status(page);
  await untilStatus(page, 'the picture has the new size', (now) => now.frames > frames + 3);
  const path = join(pictures, 'doctor-inside.jpg');
  await page.screenshot({path, type: 'jpeg', quality: 72, clip: {x: 0, y: 0, width: 1152, height: 560}, timeout: 120_000});
  await page.setViewportSize(size);
}

test('the buttons of panel and layers are reached and pressed by the keyboard', async () => {
  for (const [id, attribute] of [['show-ultrasound', 'aria-pressed'], ['show-inside', 'aria-pressed']]) {
    const before = await page.getAttribute(`#${id}`, attribute);
    await page.focus(`#${id}`);
    await page.keyboard.press('Enter');
    assert.notEqual(await page.getAttribute(`#${id}`, attribute), before, id);
    await page.keyboard.press('Space');
    assert.equal(await page.getAttribute(`#${id}`, attribute), before, id);
  }
  assert.ok(await page.isVisible('#ultrasound'));
});

test('the panel breaks no rule of WCAG AA, in the dark and in the light', async () => {
  for (const theme of ['dark', 'light']) {
    assert.deepEqual(await violations(page, '#ultrasound'), [], theme);
    await page.keyboard.press('l');
  }
  assert.deepEqual(browser.problems, []);
});
