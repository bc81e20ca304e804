// node timeline_test.mjs BIN_DIR VIEWER_FILES: a browser moves a session that the real server plays, by the page's timeline.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('timeline');
const file = join(place.folder, 'session.mcap');
const server = (args) => place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, ...args]);
let live, played, browser;

const state = async () => (await fetch(`http://127.0.0.1:${played.http_port}/playback`)).json();

/** Waits until `holds(state)` is true; a failure tells the last state. */
async function untilState(what, holds) {
  let last;
  await until(what, async () => holds((last = await state())), 20_000).catch((problem) => {
    throw new Error(`${problem.message}: ${JSON.stringify(last)}`);
  });
}
const shownTime = () => browser.page.locator('#timeline-time').textContent();
const isShown = (id) => browser.page.locator(`#${id}`).isVisible();

before(async () => {
  live = await server([]);
  await promisify(execFile)(join(binDir, 'telepalp-record'),
    ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', '12']);
  played = await server(['--source', `session:${file}`]);
  browser = await openBrowser(place.folder);
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

test('the page of a live server shows no timeline and never asks for one', async () => {
  const {page, problems} = browser;
  const asked = [];
  page.on('request', (request) => request.url().endsWith('/playback') && asked.push(request.method()));
  await page.goto(`http://127.0.0.1:${live.http_port}/`);
  await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 0);
  await sleep(1500);
  assert.equal(await isShown('timeline'), false);
  assert.deepEqual(asked, []);
  assert.deepEqual(problems, []);
});

test('space pauses: the position stands still, and the bar says so', async () => {
  const {page} = browser;
  await page.goto(`http://127.0.0.1:${played.http_port}/`);
  await page.locator('#timeline').waitFor();
  await page.keyboard.press('Space');
  await untilState('it is paused', ({playing}) => !playing);
  const {position_s} = await state();
  await sleep(1200);
  assert.equal((await state()).position_s, position_s);
  const shown = `0:${(Math.floor(position_s * 10) / 10).toFixed(1).padStart(4, '0')} / `;
  await until('the bar shows that position', async () => (await shownTime()).startsWith(shown), 20_000);
  assert.equal(await page.locator('#timeline-play').getAttribute('aria-label'), 'Play');
});

test('slider and arrows seek, period steps', async () => {
  const {page} = browser;
  await page.locator('#timeline-slider').fill('2');
  await untilState('the slider seeks to 2 s', ({position_s}) => position_s === 2);
  await page.keyboard.press('ArrowRight');
  await untilState('right: 5 s on', ({position_s}) => position_s === 7);
  await until('the bar shows it', async () => (await shownTime()).startsWith('0:07.0 / '));
  await page.keyboard.press('.');
  await untilState('one image on', ({position_s}) => position_s > 7 && position_s < 8);
  await page.keyboard.press(',');
  await page.keyboard.press('ArrowLeft');
  await untilState('left: 5 s back', ({position_s}) => position_s > 1.9 && position_s < 3);
});

test('speed, loop and play are reached by Tab, with a name and a visible focus', async () => {
  const {page} = browser;
  await page.locator('#timeline-play').focus();
  const names = [];
  for (const key of [undefined, 'Tab', 'Tab', 'Tab', 'Tab']) {
    if (key) await page.keyboard.press(key);
    names.push(await page.evaluate(() => {
      const {activeElement: at} = document;
      return [at.id, at.ariaLabel ?? at.textContent, getComputedStyle(at).outlineStyle].join(' ');
    }));
  }
  assert.deepEqual(names.slice(1), ['timeline-step Step one image forward solid',
    'timeline-slider Position in the session solid', 'timeline-speed Speed solid', 'timeline-loop Loop solid']);
  await page.keyboard.press('Space');
  await untilState('the loop is off', ({loop}) => !loop);
  await page.keyboard.press('Space');
  await untilState('the loop is on', ({loop}) => loop);
  await page.locator('#timeline-speed').selectOption('0.5');
  await untilState('half speed', ({speed}) => speed === 0.5);
  await page.locator('#timeline-play').click();
  const {position_s} = await state();
  await untilState('it plays on', (now) => now.playing && now.position_s !== position_s);
});

test('a refused command and a server that does not answer are explained on the page', async () => {
  const {page} = browser;
  const problem = page.locator('#timeline-problem');
  await page.route('**/playback', (route) => (route.request().method() === 'POST'
    ? route.fulfill({status: 403, body: 'moving a session is for technicians and QA'}) : route.continue()));
  await page.locator('#timeline-step').click();
  await until('the refusal is shown', async () => (await problem.textContent()) ===
    'The server refused: moving a session is for technicians and QA.');
  await page.unroute('**/playback');
  played.child.kill('SIGTERM');
  await until('the end of the server is shown', async () => /does not answer/.test(await problem.textContent()), 20_000);
});
