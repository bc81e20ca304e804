// node own_session_test.mjs BIN_DIR VIEWER_FILES: a page opens a recorded session for itself: a shared moment, or one of the list.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {copyFileSync, mkdirSync, readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, ownPlayback, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('own_session');
const recordings = join(place.folder, 'recordings');
const server = (...args) => place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, ...args]);
let live, played, browser;

const address = (site, query = '') => `http://127.0.0.1:${site.http_port}/${query}`;
const playback = async (site = played) => (await fetch(address(site, 'playback'))).json();
const text = (id) => browser.page.textContent(`#${id}`);

before(async () => {
  mkdirSync(recordings);
  const file = join(place.folder, 'played.mcap');
  live = await server('--record-dir', recordings);
  await promisify(execFile)(join(binDir, 'telepalp-record'), ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', '8']);
  copyFileSync(file, join(recordings, 'session_20260301_120000.mcap'));
  played = await server('--source', `session:${file}`);
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

test('a shared moment opens for its reader alone, who may move on from it', async () => {
  const {page, problems} = browser;
  await page.goto(address(played, '?view=doctor&at_s=3.00'));
  await untilStatus(page, 'the picture of the moment is drawn', (now) => now.meshVertices > 200 && now.paused);
  await page.locator('#timeline').waitFor();
  await until('the bar stands at the moment', async () => (await text('timeline-time')).startsWith('0:03.0 / '));
  assert.match(await text('timeline-own'), /^Only this page shows this recorded session and moves it/);
  assert.equal(await page.isVisible('#timeline-own'), true);
  const before = await playback();
  assert.equal(before.playing, true, 'the session goes on for all others');
  await page.keyboard.press('.');
  await until('one image on, on this page', async () => (await ownPlayback(page)).position_s > 3);
  await page.locator('#timeline-slider').fill('6');
  await until('6 s, on this page', async () => (await ownPlayback(page)).position_s === 6);
  await sleep(500);
  const after = await playback();
  assert.equal(after.playing, true);
  assert.notEqual(after.position_s, before.position_s, 'the others saw it play on');
  assert.deepEqual(problems, []);
  await page.screenshot({path: join(place.folder, '..', 'own_session.png')});
  await page.click('#timeline-own a');
  await untilStatus(page, 'the page shows what all see', (now) => now.connected && !now.paused && now.meshVertices > 200);
  assert.equal(await page.isVisible('#timeline-own'), false);
});

test('a recording of the list is opened beside the live patient, and a moment of it is shared', async () => {
  const {page, problems} = browser;
  await page.goto(address(live, '?view=technician'));
  await untilStatus(page, 'the live patient is drawn', (now) => now.meshVertices > 200);
  const link = page.locator('#sessions a');
  await link.waitFor();
  assert.match(await link.textContent(), /^session_20260301_120000\.mcap\d{4}-\d\d-\d\d \d\d:\d\d UTC, \d+\.\d MB$/);
  await page.screenshot({path: join(place.folder, '..', 'sessions.png')});
  await link.click();
  await untilStatus(page, 'the recording plays', (now) => now.view === 'qa' && now.meshVertices > 200);
  await page.locator('#timeline-own').waitFor();
  assert.equal(await page.getAttribute('#sessions li', 'aria-current'), 'true');
  await page.locator('#timeline-play').click();
  await until('it stands still', async () => (await ownPlayback(page)).playing === false);
  await page.locator('#timeline-slider').fill('4');
  await until('4 s are reached', async () => (await ownPlayback(page)).position_s === 4);
  const {shown_s} = await ownPlayback(page);
  await until('the page knows', async () => /^0:0(3\.9|4\.0) /.test(await text('moment')));
  await page.click('#share');
  const shared = await until('the address names session and moment', () => {
    const {searchParams} = new URL(page.url());
    return searchParams.get('session') === 'session_20260301_120000.mcap' && searchParams.has('at_s') ? page.url() : undefined;
  });
  await page.goto('about:blank');
  await page.goto(shared);
  await untilStatus(page, 'the same picture is drawn', (now) => now.meshVertices > 200 && now.paused);
  await until('of the same moment', async () => (await ownPlayback(page)).shown_s === shown_s);
  assert.equal((await fetch(address(live, 'health'))).status, 200, 'the camera goes on');
  assert.deepEqual(problems, []);
});

test('a session file that is dropped on the page is sent to the server, checked, and opened for this page', async () => {
  const {page} = browser;
  await page.goto(address(live, '?view=qa'));
  await page.locator('#bring-session').waitFor();
  const drop = (name, bytes) => page.evaluate(([name, base64]) => {
    const files = new DataTransfer();
    files.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
    window.dispatchEvent(new DragEvent('drop', {dataTransfer: files, bubbles: true, cancelable: true}));
  }, [name, bytes.toString('base64')]);
  await drop('wrong.mcap', Buffer.from('this is no session'));
  await until('a file that is none is refused', async () => /this is no session file/.test(await text('sessions-said')));
  assert.deepEqual(readdirSync(recordings), ['session_20260301_120000.mcap'], 'nothing is left of it');
  await drop('brought.mcap', readFileSync(join(recordings, 'session_20260301_120000.mcap')));
  await until('the page opens it', () => page.url().endsWith('?view=qa&session=brought.mcap'));
  await untilStatus(page, 'it is drawn', (now) => now.meshVertices > 200);
  assert.deepEqual(readdirSync(recordings).sort().filter((name) => name.endsWith('.part')), []);
});

test('what cannot be opened is said, with what to do', async () => {
  const {page} = browser;
  await page.goto(address(live, '?session=gone.mcap'));
  await until('the name is unknown', async () => /no recorded session of this name/.test(await text('banner-text')));
  assert.equal(await text('banner-title'), 'The session is not opened');
  await page.goto(address(live, '?at_s=3'));
  await until('no session is played', async () => /this server plays no session now/.test(await text('banner-text')));
});
