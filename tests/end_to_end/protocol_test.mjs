// node protocol_test.mjs BIN_DIR [PICTURES]: a person's protocol in Chromium, served by the real telepalp-study: a hand of
// mouse and keys does the training and two penetrations with each of two mechanisms; Escape, another tab, Ctrl-C and the
// same command again; and the report has the figures of what the hand did.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {checkNarrowInLight, violations} from './accessibility.mjs';
import {openBrowser, savePicture} from './browser.mjs';
import {until, Workplace} from './running_program.mjs';

const [binDir, pictures] = process.argv.slice(2);  // PICTURES: a folder for screenshots, to be looked at
const place = new Workplace('protocol');
const list = join(place.folder, 'two.txt');
const out = join(place.folder, 'out');
writeFileSync(list, 'name=long l_h=180\nname=short l_h=100\n');
const command = ['protocol', '--design', list, '--participant', 'p07', '--conditions', 'both', '--training', '1',
                 '--penetrations', '2', '--out', out];
let browser, page, child;

async function start() {
  child = place.start(join(binDir, 'telepalp-study'), command);
  const address = await until('the address is printed', () => {
    if (child.exitCode !== null) throw new Error(child.heard);
    return /^http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}$/m.exec(child.heard)?.[0];
  });
  await page.goto(address);
  await until('the page is live', () => page.evaluate(() => window.protocol?.state !== undefined));
}
before(async () => {
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  await start();
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const state = () => page.evaluate(() => window.protocol.state);
const frame = () => page.evaluate(() => window.protocol.frame);
const stage = (name) => page.waitForFunction((wanted) => window.protocol.state?.stage === wanted, name);
const picture = (name, options) => savePicture(page, pictures, name, options);

/** Holds the arrow key until the needle is through the skin and the force has fallen to half of its peak behind it. */
async function pushUntilItGivesWay() {
  await page.focus('#field');
  await page.keyboard.press('Space');
  await stage('ready');
  const before = (await state()).done;
  await page.evaluate(() => (window.peak = 0));
  await page.keyboard.down('ArrowRight');
  await page.waitForFunction((done) => {
    const {state, frame} = window.protocol;
    if (state.done > done) return true;
    if (!frame?.seen?.through_skin) return false;
    window.peak = Math.max(window.peak, frame.hand_N);
    return frame.hand_N < 0.5 * window.peak;
  }, before, {polling: 'raf'});
  await page.keyboard.up('ArrowRight');
  // The force may have fallen because muscle slips: then the hand goes on slowly.
  for (let i = 0; i < 200 && (await state()).done === before; ++i) {
    await page.keyboard.down('ArrowRight');
    await page.waitForTimeout(60);
    await page.keyboard.up('ArrowRight');
    await page.waitForTimeout(160);
  }
  await page.waitForFunction((done) => window.protocol.state.done > done, before);
  return state();
}

test('the page tells what to do, that a mouse gives no force, and what a pause is', async () => {
  const {done, all, training, condition} = await state();
  assert.deepEqual([done, all, training, condition], [0, 5, true, 'both']);
  assert.equal(await page.textContent('#done'), '0 of 5');
  assert.match(await page.textContent('#do'), /Press Space.*training/);
  assert.match(await page.textContent('#how'), /A mouse gives no force/);
  assert.match(await page.textContent('#how'), /Esc lets go/);
  assert.deepEqual(await violations(page), []);
  await picture('welcome');
});

test('Escape before the puncture lets go, and the penetration comes again', async () => {
  await page.keyboard.press('Space');
  await stage('ready');
  await page.waitForFunction(() => window.protocol.frame?.seen !== undefined);
  await picture('ready');
  const box = await page.locator('#field').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const {along, seen} = await frame();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60 * along[0], y - 60 * along[1], {steps: 8});
  await stage('inserting');
  await page.waitForFunction(([x, y]) => Math.hypot(window.protocol.frame.seen.c[0] - x, window.protocol.frame.seen.c[1] - y) > 5, seen.c);
  await picture('inserting');
  await page.keyboard.press('Escape');
  await stage('resting');
  await page.mouse.up();
  assert.equal((await state()).done, 0);
  assert.match(await page.textContent('#told'), /comes again/);
});

test('a page that is opened later takes over, and the first one says so', async () => {
  const second = await browser.context.newPage();
  await second.goto(page.url());
  await second.waitForFunction(() => window.protocol?.state !== undefined);
  await page.waitForFunction(() => window.protocol.taken, undefined, {polling: 100});
  assert.match(await page.textContent('#do'), /Another page has taken over/);
  await second.close();
  await page.bringToFront();
  await page.reload();
  await stage('resting');
});

test('after the training, the overshoot is told', async () => {
  const {last, done} = await pushUntilItGivesWay();
  assert.equal(done, 1);
  assert.equal(last.what, 'training');
  assert.ok(last.through && last.overshoot > 0.2 && last.overshoot < 60, JSON.stringify(last));
  assert.equal(await page.textContent('#told'), `Training: ${last.overshoot.toFixed(1)} mm overshoot`);
  assert.equal(await page.textContent('#done'), '1 of 5');
  assert.deepEqual(await violations(page), []);
  await picture('told');
});

const overshoots = [];
test('Ctrl-C in the middle tells the figures so far, and the same command goes on', async () => {
  overshoots.push((await pushUntilItGivesWay()).last.overshoot);
  child.kill('SIGINT');
  await child.over;
  assert.equal(child.exitCode, 0, child.heard);
  assert.match(child.heard, /p07: 2 of 5 penetrations/);
  assert.match(child.heard, /not finished/);
  await start();
  assert.equal((await state()).done, 2);
  assert.match(child.heard, /2 of 5 penetrations are done/);
});

test('the page is whole in the light theme and 800 pixels wide', async () => {
  await checkNarrowInLight(page, picture);
});

test('when all is done, the program ends, and its report has the figures of this hand', async () => {
  while (overshoots.length < 4) overshoots.push((await pushUntilItGivesWay()).last.overshoot);
  await child.over;
  assert.equal(child.exitCode, 0, child.heard);
  assert.match(await page.textContent('#do'), /Finished/);
  const rows = readFileSync(join(out, 'trials.csv'), 'utf8').split('\n').filter((row) => /^\d/.test(row)).map((row) => row.split(','));
  assert.equal(rows.length, overshoots.length);
  rows.forEach((cells, i) => assert.ok(Math.abs(1e3 * Number(cells[8]) - overshoots[i]) < 1e-6, `told ${overshoots[i]} mm, kept ${cells[8]} m`));
  assert.ok(rows.every((cells) => cells[1] === 'both' && cells.at(-2) === 'p07' && cells.at(-1) === 'browser; force shown as a bar'));
  const {both, finished} = JSON.parse(readFileSync(join(out, 'study.json'), 'utf8'));
  const mean = overshoots.reduce((sum, mm) => sum + mm, 0) / 4;
  assert.ok(finished && Math.abs(both.all.mean_mm - mean) < 1e-6, `${both.all.mean_mm} and ${mean}`);
  assert.equal(both.broken_off, 1);
  assert.match(child.heard, new RegExp(`^all +${mean.toFixed(1).replace('.', '\\.')} \\(`, 'm'));
  await page.goto(`file://${join(out, 'report.html')}`);
  assert.match(await page.textContent('body'), /force shown as a bar/);
  assert.ok(await page.locator('svg').count() >= 2, 'plots');
  await picture('report', {fullPage: true});
  assert.deepEqual(browser.problems.filter((problem) => !/WebSocket|ERR_CONNECTION/.test(problem)), []);
});
