// node comparison_test.mjs BIN_DIR VIEWER_FILES: QA sees two runs on one time axis, on the page of the real server. The
// runs are replays of one source over two networks, in virtual time. telepalp-report compares the same files at 2 kHz.
// With TELEPALP_PICTURES=DIR the picture of docs/ is written there.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {copyFileSync, mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {violations} from '../accessibility.mjs';
import {openBrowser} from '../browser.mjs';
import {until, Workplace} from '../running_program.mjs';

const SOURCE = 'synthetic:torso,motion=irregular,width=160';
const NETWORKS = {lan: [], wan: ['--delay-ms', '80', '--loss', '10%']};
const pictures = process.env.TELEPALP_PICTURES;
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('comparison');
const folder = join(place.folder, 'sessions');
const run = (program, args) => promisify(execFile)(join(binDir, program), args);
let browser, page, address, reported;

before(async () => {
  mkdirSync(folder);
  for (const [name, options] of Object.entries(NETWORKS)) {
    const out = join(place.folder, name);
    await run('telepalp-replay', [SOURCE, '--seconds', '4', ...options, '--out', out]);
    copyFileSync(join(out, 'session.mcap'), join(folder, `${name}.mcap`));
  }
  const {stdout} = await run('telepalp-report', [join(folder, 'lan.mcap'), join(folder, 'wan.mcap'), '--out', join(place.folder, 'compared')]);
  const found = /difference ([\d.]+) s after the start: the force is ([\d.]+) N in A and ([\d.]+) N in B/.exec(stdout);
  assert.ok(found, stdout);
  reported = found.slice(1).map(Number);
  const {http_port} = await place.server(join(binDir, 'telepalp-server'),
      ['--viewer', viewer, '--source', `session:${join(folder, 'lan.mcap')},paused=yes`, '--compare-dir', folder]);
  address = `http://127.0.0.1:${http_port}/`;
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  await page.goto(`${address}?view=qa`);
  await page.waitForSelector('#comparison-card', {state: 'visible', timeout: 60_000});
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const text = (id) => page.textContent(`#${id}`);
const playback = async () => (await fetch(`${address}playback`)).json();

test('the chosen run lies beside the played one, and the first felt difference is the report\'s', async () => {
  assert.deepEqual(await page.locator('#comparison-with option').allTextContents(), ['none', 'lan.mcap', 'wan.mcap']);
  await page.focus('#comparison-with');
  await page.keyboard.press('End');
  await page.waitForSelector('#comparison', {state: 'visible', timeout: 60_000});
  assert.match(await text('comparison-said'), /^At the first difference, [\d.]+ N in A, [\d.]+ N in B; the force vectors differ by [\d.]+ N\. Both runs are shown at their session times\.$/);
  const {first} = await (await fetch(`${address}playback/comparison`)).json();
  const [at_s, a_N, b_N] = reported;
  assert.ok(first.at_s > at_s - 0.02 && first.at_s < at_s + 0.05, `${first.at_s} s, and ${at_s} s in the report`);
  assert.ok(Math.abs(first.force_a_N - a_N) < 0.3 && Math.abs(first.force_b_N - b_N) < 0.3, JSON.stringify(first));
});

test('the first difference and a click into a plot move the played session there', async () => {
  const {first} = await (await fetch(`${address}playback/comparison`)).json();
  await page.focus('#comparison-first');
  await page.keyboard.press('Enter');
  await until('the session is there', async () => Math.abs((await playback()).position_s - first.at_s) < 0.05);
  if (pictures !== undefined)
    await page.screenshot({path: join(pictures, 'comparison.jpg'), type: 'jpeg', quality: 72, timeout: 120_000});
  const plot = await page.locator('#comparison-force .u-over').boundingBox();
  await page.mouse.click(plot.x + 0.25 * plot.width, plot.y + 0.5 * plot.height);
  await until('a click seeks', async () => Math.abs((await playback()).position_s - 0.25 * 4) < 0.15);
  await until('the line follows', async () => /^0:0[01]\.\d: A /.test(await text('comparison-moment')));
});

test('the keyboard moves the line in the plots, by the timeline', async () => {
  const line_px = () => page.evaluate(() => Number.parseFloat(document.querySelector('#comparison-force .comparison-now').style.left));
  const before_px = await line_px();
  await page.focus('#timeline-slider');
  await page.keyboard.press('Home');
  await until('the session is at its beginning', async () => (await playback()).position_s < 0.2);
  await until('the line is there', async () => (await line_px()) < 0.5 * before_px);
});

test('two runs side by side break no rule of WCAG AA, in the dark and in the light', async () => {
  for (const theme of ['dark', 'light']) {
    for (const card of ['#comparison-card', '#comparison']) assert.deepEqual(await violations(page, card), [], `${card} ${theme}`);
    await page.focus('#scene');
    await page.keyboard.press('l');
  }
});

test('a run beside itself has no difference; none ends the comparison', async () => {
  await page.selectOption('#comparison-with', 'lan.mcap');
  await until('they are equal', async () => /^The hand feels no difference between A and B\./.test(await text('comparison-said')));
  assert.equal(await page.isVisible('#comparison-first'), false);
  await page.focus('#comparison-with');
  await page.keyboard.press('Home');
  await page.waitForSelector('#comparison', {state: 'hidden'});
  assert.deepEqual(browser.problems, []);
});

test('the choice of another visitor is shown on a page that is open', async () => {
  await fetch(`${address}playback/comparison`, {method: 'POST', body: '{"with":"wan.mcap"}'});
  await page.waitForSelector('#comparison', {state: 'visible', timeout: 60_000});
  assert.equal(await page.inputValue('#comparison-with'), 'wan.mcap');
});
