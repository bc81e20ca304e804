// QA sees one instant: picture, badge, Compare and snapshot: node one_instant_test.mjs BIN_DIR VIEWER_FILES
// With TELEPALP_PICTURES=DIR the snapshot is written there.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const SECONDS = 14;  // two presses of the simulated hand
const KNOWN_MS = 2200;  // after a seek, the page waits before it asks which image the server shows
const pictures = process.env.TELEPALP_PICTURES;
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('one_instant');
const folder = join(place.folder, 'sessions');
const program = (name) => join(binDir, name);
let browser, page, http_port;

before(async () => {
  mkdirSync(folder);
  const live = await place.server(program('telepalp-server'), ['--viewer', viewer, '--source', 'synthetic:torso,width=160']);
  const station = place.start(program('telepalp-station'), ['--connect', `127.0.0.1:${live.port}`]);
  await promisify(execFile)(program('telepalp-record'),
      ['--connect', `127.0.0.1:${live.port}`, '--out', join(folder, 'anna.mcap'), '--seconds', String(SECONDS)]);
  for (const child of [station, live.child]) child.kill('SIGTERM');
  ({http_port} = await place.server(program('telepalp-server'),
      ['--viewer', viewer, '--source', `session:${join(folder, 'anna.mcap')},paused=yes`, '--compare-dir', folder]));
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  await page.goto(`http://127.0.0.1:${http_port}/?view=qa`);
  await untilStatus(page, 'the mesh is drawn', (now) => now.meshVertices > 0);
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

/** Force and phase of the badge and, of the same run, of Compare, in one turn of the page. */
const shown = () => page.evaluate(() => {
  const text = (id) => document.getElementById(id).textContent;
  const [, force, phase] = /A ([\d.]+) N, \d+ mm, ([^;]*);/.exec(text('comparison-moment')) ?? [];
  const {force_N, phase: badge} = window.telepalp;
  return {force_N, badge, text: text('phase-name'), compared_N: Number(force), compared: phase, moment: text('comparison-moment')};
});

const comparison = async () => (await fetch(`http://127.0.0.1:${http_port}/playback/comparison`)).json();

/** The middle of a rise of the force [s], where an instant that is 50 ms off shows another force. */
function rise({a, begin_s, bin_s}) {
  const bins = Math.round(0.15 / bin_s);
  const gain = a.force_N.map((force, at) => (at < bins ? 0 : force - a.force_N[at - bins]));
  const steepest = gain.indexOf(Math.max(...gain));
  assert.ok(gain[steepest] > 0.3, `a rise of ${gain[steepest]} N in 0.15 s`);
  return begin_s + steepest * bin_s;
}

test('badge and Compare show one instant, image by image through a press', async () => {
  await page.waitForSelector('#comparison-card', {state: 'visible', timeout: 60_000});
  await page.selectOption('#comparison-with', 'anna.mcap');
  await page.waitForSelector('#comparison', {state: 'visible', timeout: 60_000});
  await until('both are read', async () => (await comparison()).complete);
  const runs = await comparison();
  const at_s = rise(runs);
  await fetch(`http://127.0.0.1:${http_port}/playback`, {method: 'POST', body: JSON.stringify({seek_s: at_s - 0.2})});
  await sleep(KNOWN_MS);
  const seen = [];
  for (let step = 0; step < 12; ++step) {
    await page.keyboard.press('.');
    await sleep(KNOWN_MS / 2);
    seen.push(await shown());
  }
  const pressed = seen.filter(({force_N}) => force_N > 0.1);
  assert.ok(pressed.length >= 4, JSON.stringify(seen));
  const near = runs.a.force_N.map((force, bin) => ({force, bin})).slice(Math.round((at_s - runs.begin_s - 0.5) / runs.bin_s));
  let phasesCompared = 0;
  for (const {force_N, badge, compared_N, compared, moment} of pressed) {
    const around = (bin) => runs.a.force_N.slice(bin - 1, bin + 2);  // a bin has the largest force of about two states
    const bin = near.filter(({force}) => force.toFixed(2) === compared_N.toFixed(2)).map((one) => one.bin)
        .find((at) => force_N > Math.min(...around(at)) - 0.03 && force_N < Math.max(...around(at)) + 0.03);
    assert.ok(bin !== undefined, `${force_N} N on the badge; ${moment}`);
    if (new Set(runs.a.phase.slice(bin - 1, bin + 2)).size > 1) continue;  // a bin shows the last phase of its states
    assert.equal(badge, compared);
    ++phasesCompared;
  }
  assert.ok(phasesCompared >= 3, `${phasesCompared} images far from a change of phase`);
});

/** Width and height of a PNG. */
const sizeOf = (png) => [png.readUInt32BE(16), png.readUInt32BE(20)];

test('a snapshot is the picture at its own size, with force, time and session below it', async () => {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#snapshot')]);
  const saved = join(place.folder, 'snapshot.png');
  await download.saveAs(saved);
  if (pictures !== undefined) copyFileSync(saved, join(pictures, 'snapshot.png'));
  assert.match(download.suggestedFilename(), /^telepalp_\d+\.\d\ds\.png$/);
  const [width, height] = sizeOf(readFileSync(saved));
  assert.equal(width, 1280);
  assert.ok(height > 840 && height < 920, `${height} pixels, with three lines of text`);
});
