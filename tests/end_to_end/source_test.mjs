// node source_test.mjs BIN_DIR VIEWER_FILES: a technician chooses the source that the server shows to all, and the exposure
// of its colour images, on the page.
import assert from 'node:assert/strict';
import {execFile, execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, untilStatus} from './browser.mjs';
import {KeyedWeb} from './keyed_web.mjs';
import {until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('source');
const recordings = join(place.folder, 'recordings');
const server = (...args) => place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--record-dir', recordings, ...args]);
let live, browser, page;

const state = async (path) => (await fetch(`http://127.0.0.1:${live.http_port}/${path}`)).json();
const text = (id) => page.textContent(`#${id}`);
const present = () => untilStatus(page, 'a picture comes', (now) => now.connected && now.meshVertices > 200);

before(async () => {
  mkdirSync(recordings);
  live = await server('--source', 'synthetic:width=160');
  await promisify(execFile)(join(binDir, 'telepalp-record'),
      ['--connect', `127.0.0.1:${live.port}`, '--out', join(recordings, 'earlier.mcap'), '--seconds', '5']);
  browser = await openBrowser(place.folder, {width: 1280, height: 900});
  page = browser.page;
  await page.goto(`http://127.0.0.1:${live.http_port}/?view=technician`);
  await present();
  if (!(await page.isVisible('#side'))) await page.keyboard.press('d');
  await page.waitForSelector('#source-card', {state: 'visible'});
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

test('the exposure of the synthetic patient is set, and the picture follows', async () => {
  await page.waitForSelector('#exposure-set', {state: 'visible'});
  assert.equal(await page.isChecked('#exposure-automatic'), true);
  assert.equal(await text('exposure-text'), '10 ms');
  const light = async () => Number(/Light[^(]*\((\d+)\)/.exec(await text('picture-problems'))?.[1]);
  const before = await until('the light is measured', async () => (await light()) > 0 && light());
  await page.focus('#exposure');
  await page.keyboard.press('Home');
  await until('the server has it', async () => (await state('exposure')).exposure === 0.5);
  assert.equal((await state('exposure')).automatic, false);
  await until('the page shows it', async () => (await text('exposure-text')) === '0.5 ms');
  await until('the picture is dark', async () => (await light()) < before / 3);
  await page.screenshot({path: join(place.folder, '..', 'source_dark.png')});
  await page.check('#exposure-automatic');
  await until('the picture is as before', async () => Math.abs((await light()) - before) <= 2);
});

test('another source is chosen: all see it, and what belongs to the old one goes', async () => {
  assert.match(await text('source-said'), /^All see synthetic:width=160\.$/);
  assert.equal(await page.isDisabled('#source-show'), true, 'it is shown already');
  await page.selectOption('#source-choice', 'session:earlier.mcap');
  await page.click('#source-show');
  await until('all see it', async () => (await text('source-said')) === 'All see session:earlier.mcap.');
  await page.waitForSelector('#timeline', {state: 'visible'});
  assert.equal(await page.isVisible('#exposure-card'), false, 'a recording has no exposure');
  assert.equal((await state('playback')).playing, true);
  await page.screenshot({path: join(place.folder, '..', 'source_recording.png')});
  await page.selectOption('#source-choice', 'synthetic');
  await page.click('#source-show');
  await until('all see the synthetic patient', async () => (await text('source-said')) === 'All see synthetic.');
  await page.waitForSelector('#timeline', {state: 'hidden'});
  await page.waitForSelector('#exposure-set', {state: 'visible'});
  assert.equal((await fetch(`http://127.0.0.1:${live.http_port}/playback`)).status, 404);
  assert.equal((await fetch(`http://127.0.0.1:${live.http_port}/health`)).status, 200);
  const {frames} = await page.evaluate(() => window.telepalp);
  await untilStatus(page, 'pictures go on', (now) => now.frames > frames + 5);
  assert.deepEqual(browser.problems, []);
});

test('only a technician may, and the audit log has it', async () => {
  const folder = join(place.folder, 'keys');
  const keys = (...words) => execFileSync(join(binDir, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
  keys('authority', '--host', '127.0.0.1');
  keys('server', '--host', '127.0.0.1');
  keys('client', '--name', 'recorder', '--role', 'technician');
  for (const [name, role] of [['dora', 'doctor'], ['tina', 'technician'], ['quinn', 'qa']]) keys('token', '--name', name, '--role', role);
  const {http_port} = await server('--source', 'synthetic:width=160', '--key', join(folder, 'server.key'), '--record-key', join(folder, 'recorder.key'));
  const web = new KeyedWeb(http_port, readFileSync(join(folder, 'authority.crt')));
  const bearer = (name) => ({authorization: `Bearer ${/^token: (.*)$/m.exec(readFileSync(join(folder, `${name}.token`), 'utf8'))[1]}`});
  const send = (name, path, command) => web.ask(path, {method: 'POST', headers: bearer(name), body: JSON.stringify(command)});
  for (const name of ['dora', 'quinn']) {
    assert.equal((await web.ask('/source', {headers: bearer(name)})).status, 403);
    assert.match((await send(name, '/source', {source: 'synthetic'})).text, /only technicians may choose the source/);
    assert.equal((await send(name, '/exposure', {automatic: true})).status, 403);
  }
  assert.match((await send('tina', '/source', {source: 'oni:/etc/passwd'})).text, /may not open a source of this name/);
  assert.equal((await send('tina', '/source', {source: 'session:earlier.mcap'})).status, 200);
  await until('it is shown', async () => JSON.parse((await web.ask('/source', {headers: bearer('tina')})).text).present === 'session:earlier.mcap');
  const audit = readFileSync(join(folder, 'audit.log'), 'utf8');
  assert.match(audit, /event=chose-source who=technician tina asked="\{'source':'session:earlier.mcap'\}" program=browser/);
  assert.doesNotMatch(audit, /event=chose-source who=doctor/);
});
