// node views_test.mjs BIN_DIR VIEWER_FILES: each view of the page, on a recorded session that the real server plays: its
// cards, controls by mouse and by keyboard, themes, accessibility by axe, and a lost graphics context. With
// TELEPALP_PICTURES=DIR the pictures of docs/ are written there.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {violations} from './accessibility.mjs';
import {openBrowser, ownPlayback, status, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const IWER = readFileSync(join(borrowed.resolve('iwer'), '../../build/iwer.min.js'), 'utf8');
const pictures = process.env.TELEPALP_PICTURES;
const VIEWS = ['doctor', 'technician', 'qa'];
const SIZE = pictures === undefined ? {width: 1040, height: 700} : {width: 1280, height: 800};
const SIZES = [[1400, 900], [900, 640], [390, 760]];
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('views');
const file = join(place.folder, 'session.mcap');
const program = (name) => join(binDir, name);
let browser, page, address, played;

before(async () => {
  const live = await place.server(program('telepalp-server'), ['--viewer', viewer]);
  const station = place.start(program('telepalp-station'), ['--connect', `127.0.0.1:${live.port}`]);
  await promisify(execFile)(program('telepalp-record'), ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', '10']);
  station.kill('SIGTERM');
  live.child.kill('SIGTERM');
  played = await place.server(program('telepalp-server'), ['--viewer', viewer, '--source', `session:${file}`]);
  address = `http://127.0.0.1:${played.http_port}/`;
  browser = await openBrowser(place.folder, SIZE);
  page = browser.page;
  await page.goto(`${address}?view=doctor`);
  await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const text = (id) => page.textContent(`#${id}`);
const playback = async () => (await fetch(`${address}playback`)).json();
const cardTitles = () => page.evaluate(() => [...document.querySelectorAll('#side h2')]
    .filter((title) => title.offsetParent !== null).map((title) => title.textContent));

/** Keeps a picture that is not stale and for which `holds(status)`: until this is so before and after it is taken. */
async function keepPicture(name, holds = () => true) {
  if (pictures === undefined) return;
  mkdirSync(pictures, {recursive: true});
  const isFresh = async () => (await page.getAttribute('body', 'data-old')) !== 'true' && holds(await status(page));
  for (let tries = 0; tries < 100; ++tries) {
    await until(`a picture for ${name}`, isFresh, 120_000);
    await sleep(400);  // a picture that was stale brightens in 0.3 s
    if (!(await isFresh())) continue;
    await page.screenshot({path: join(pictures, `${name}.jpg`), type: 'jpeg', quality: 72, timeout: 120_000});
    if (await isFresh()) return;
  }
  assert.fail(`no picture for ${name}: this computer draws too slowly`);
}

const presses = (now) => now.force_N > 0.3 && now.indentation_m > 0.005 && now.handPosition_m !== undefined;

test('the doctor sees the recorded station, and what it compensated', async () => {
  await until('the station is named', async () => /Recorded station/.test(await text('presence')));
  await until('the way of a frame has its stages', async () => /Network to station\d/.test(await text('delay')));
  await until('hand and skin are compensated', async () => /Hand predicted[\d.]+ ± [\d.]+ mm/.test(await text('compensated')));
  await keepPicture('doctor', presses);
});

test('the technician sees the state of the picture, and the depth under the pointer', async () => {
  await page.keyboard.press('2');
  await until('the source can be chosen', async () => (await cardTitles()).includes('Source'));
  assert.deepEqual(await cardTitles(), ['Picture', 'Source', 'Depth', 'Network', 'Subscribers']);
  await until('the distance is measured', async () => /Distance0\.\d+ m/.test(await text('picture-problems')));
  await until('light is measured', async () => /Light(good|too)/.test(await text('picture-problems')));
  await until('rates come', async () => /Mbit\/s/.test(await text('network')));
  await page.mouse.move(520, 400);
  await until('depth is read', async () => /^pixel \d+, \d+: [01]\.\d{3} m$/.test(await text('point-depth')));
  await page.keyboard.press('c');
  await page.locator('#range-near').fill('0.7');
  assert.equal(await page.getAttribute('#range-auto', 'aria-pressed'), 'false');
  await until('the range is shown', async () => (await text('range-near-text')) === '0.70 m');
  await keepPicture('technician');
  await page.click('#range-auto');
  await page.keyboard.press('c');
});

test('QA shares a moment, and the address brings another visitor to it', async () => {
  await page.keyboard.press('3');
  await until('the cards of a played session come', async () =>
    (await cardTitles()).join() === 'Moment,Notes,Impaired network,Events');
  await until('events of the session come', async () => (await page.locator('#events li').count()) > 0);
  await until('the whole session has its phases in a band', async () => (await page.locator('#overview i').count()) > 2);
  const {events, complete} = await (await fetch(`${address}playback/events`)).json();
  assert.ok(complete);
  await until('and its events in the list', async () => (await page.locator('#events li').count()) === events.length);
  await keepPicture('qa');
  await page.keyboard.press('Space');
  await until('it stands still', async () => !(await playback()).playing);
  const band = await page.locator('#overview').boundingBox();
  await page.mouse.click(band.x + 0.25 * band.width, band.y + 0.5 * band.height);
  await until('a click into the band seeks', async () => {
    const {position_s, duration_s} = await playback();
    return Math.abs(position_s - 0.25 * duration_s) < 0.2;
  });
  await page.locator('#timeline-slider').fill('4');
  await until('4 s are reached', async () => (await playback()).position_s === 4);
  const {shown_s} = await playback();
  await until('the page knows', async () => /^0:0(3\.9|4\.0) /.test(await text('moment')));
  await page.click('#share');
  await until('it says so', async () => /address of this moment/.test(await text('moment-said')));
  const shared = page.url();
  assert.match(new URL(shared).search, /^\?view=qa&at_s=(3\.9\d|4\.00)$/);
  await page.locator('#timeline-slider').fill('8');
  await until('it is elsewhere', async () => (await playback()).position_s === 8);
  await page.goto(shared);
  await until('the address leads this page back to the same picture', async () =>
    (await ownPlayback(page)).shown_s === shown_s);
  assert.equal((await playback()).position_s, 8, 'and leaves the others where they are');
  await untilStatus(page, 'it is QA\'s view', (now) => now.view === 'qa');
  await untilStatus(page, 'the mesh is drawn again', (now) => now.meshVertices > 200);
});

test('a snapshot is a picture file', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#snapshot')]);
  assert.match(download.suggestedFilename(), /^telepalp_.*\.png$/);
  const saved = join(place.folder, 'snapshot.png');
  await download.saveAs(saved);
  assert.deepEqual([...readFileSync(saved).subarray(1, 4)].map((byte) => String.fromCharCode(byte)).join(''), 'PNG');
});

test('no view breaks WCAG AA, in the dark and in the light; no size cuts its readings', async () => {
  for (const view of VIEWS) {
    await page.click(`#view-${view}`);
    assert.deepEqual(await violations(page), [], view);
  }
  await page.keyboard.press('l');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'light');
  await page.click('#view-technician');  // it has texts of all colours
  assert.deepEqual(await violations(page), [], 'technician in the light');
  await page.setViewportSize({width: 390, height: 760});
  await page.waitForSelector('#side', {state: 'hidden'});  // a small window begins without details
  await page.keyboard.press('d');
  await page.waitForSelector('#side', {state: 'visible'});
  assert.deepEqual(await violations(page), [], 'details in a small window');
  for (const view of pictures === undefined ? [] : VIEWS) {
    await page.click(`#view-${view}`);
    for (const [width, height] of SIZES) {
      await page.setViewportSize({width, height});
      await keepPicture(`light_${view}_${width}`);
    }
  }
  await page.setViewportSize(SIZE);
  await page.keyboard.press('l');
});

test('in no width do phase, top bar, banner and notice touch, nor a reading and the next one', async () => {
  const {playing} = await playback();
  const play = (now) => fetch(`${address}playback`, {method: 'POST', body: JSON.stringify({play: now})});
  await play(false);
  await page.waitForSelector('#banner-title:text-is("Paused")');
  for (const width of [1920, 1400, 1100, 900, 390]) {
    await page.setViewportSize({width, height: 800});
    const touching = await page.evaluate(async () => {
      for (let drawn = 0; drawn < 3; ++drawn) await new Promise(requestAnimationFrame);  // heights are measured after layout
      document.getElementById('phase-says').textContent = 'no force: push the device down to the skin';
      for (const id of ['picture-age', 'link-age']) document.getElementById(id).textContent = '999 ± 99 ms';
      const notice = document.querySelector('.hand-notice');
      notice.hidden = false;
      notice.firstChild.textContent = 'Another viewer holds the hand. Move the pointer over the skin to ask for it.';
      const textBox = (element) => {
        const range = document.createRange();
        range.selectNodeContents(element);
        return range.getBoundingClientRect();
      };
      const parts = ['.top', '#badge', '#banner', '.hand-notice', '#readings']
          .map((name) => ({name, box: document.querySelector(name).getBoundingClientRect()}));
      const values = [...document.querySelectorAll('.ages dd')].filter(({offsetParent}) => offsetParent !== null)
          .map((value) => ({name: value.id, box: textBox(value)}));
      const touch = ({box: a}, {box: b}) => a.left < b.right + 2 && b.left < a.right + 2 && a.top < b.bottom && b.top < a.bottom;
      return [parts, values].flatMap((list) => list.flatMap((one, at) =>
          list.slice(at + 1).filter((other) => touch(one, other)).map((other) => `${one.name} and ${other.name}`)));
    });
    assert.deepEqual(touching, [], `${width} px`);
  }
  await page.setViewportSize(SIZE);
  await play(playing);
});

test('two pictures side by side are drawn for a 3D screen', async () => {
  const {frames} = await status(page);
  await page.click('#timeline-play');
  await page.keyboard.press('s');
  await untilStatus(page, 'pictures go on', (now) => now.frames > frames);
  assert.equal(await page.getAttribute('#show-stereo', 'aria-pressed'), 'true');
  await page.keyboard.press('s');
});

test('a lost graphics context is said, and the picture comes back', async () => {
  await page.evaluate(() => {
    const canvas = document.getElementById('scene');
    window.lose = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
    window.lose.loseContext();
  });
  await until('the page says so', async () => /No picture/.test(await text('banner-title')));
  const {frames} = await status(page);
  await page.evaluate(() => window.lose.restoreContext());
  await untilStatus(page, 'pictures are drawn again', (now) => now.frames > frames && now.meshVertices > 200);
  await until('the banner is gone', () => page.evaluate(() =>
    !/No picture/.test(document.querySelector('#banner:not([hidden])')?.textContent ?? '')));
  assert.deepEqual(browser.problems, []);
});

test('an emulated headset shows the scene, and gives the page back', async (context) => {
  const {drawn_ms} = await status(page);
  await fetch(`${address}playback`, {method: 'POST', body: JSON.stringify({play: true})});  // QA has paused it for all
  if (drawn_ms > 2000) return context.skip(`one picture takes ${drawn_ms} ms here, and an emulated headset draws without a pause`);
  assert.equal(await page.isVisible('#headset'), false, 'without a headset there is no button');
  await page.setViewportSize({width: 390, height: 620});  // both eyes are drawn without a graphics card
  await page.addInitScript(`${IWER}; new IWER.XRDevice(IWER.metaQuest3).installRuntime({forceInstall: true});`);
  await page.goto(`${address}?view=doctor`);
  await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
  await page.waitForSelector('#headset', {state: 'visible'});
  await page.evaluate(() => document.getElementById('headset').click());
  await page.waitForSelector('#headset[aria-pressed="true"]', {state: 'attached'});
  const {frames} = await status(page);
  await untilStatus(page, 'pictures go on in the headset', (now) => now.frames > frames);
  await page.evaluate(() => document.getElementById('headset').click());
  await page.waitForSelector('#headset[aria-pressed="false"]', {state: 'attached'});
  const after = (await status(page)).frames;
  await untilStatus(page, 'and on the page', (now) => now.frames > after);
});
