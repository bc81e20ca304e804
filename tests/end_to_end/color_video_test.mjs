// node color_video_test.mjs BIN_DIR VIEWER_FILES: colour as video over the real server, to the page, to telepalp-view and
// to telepalp-record, and back out of the session. Where the browser decodes no video, the page takes pictures.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, untilStatus} from './browser.mjs';
import {until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const run = promisify(execFile);
const program = (name, args) => run(join(binDir, name), args);
const place = new Workplace('color_video');
let browser, page, address, server;

before(async () => {
  const ports = await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer]);
  address = `http://127.0.0.1:${ports.http_port}/`;
  server = `127.0.0.1:${ports.port}`;
  browser = await openBrowser(place.folder, {width: 1280, height: 800});  // narrower, the page closes its details
  page = browser.page;
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const colorSaid = async () => page.textContent('#color-said');

/** The mean bytes of a message of `topic`, as telepalp-view counts them while the page runs. */
async function bytesOfOne(topic, coding) {
  const {stdout} = await program('telepalp-view', ['--connect', server, '--stats', '--json', '--seconds', '4', '--color', coding]);
  const {per_s, bytes_per_s} = JSON.parse(stdout).topics[topic];
  assert.ok(per_s > 2, `${topic}: ${per_s} a second`);
  return bytes_per_s / per_s;
}

test('the page shows the patient in the colours of the video', async () => {
  await page.goto(`${address}?view=technician&color=video`);
  await until('the page takes video', async () => /as video/.test(await colorSaid()));
  await untilStatus(page, 'pictures are drawn', (now) => now.connected && now.frames > 10);
  const topics = await page.textContent('#network');
  assert.match(topics, /color\/video/, `the card Network names the topic: ${topics}`);
});

test('a tick gives pictures again, and the choice is remembered', async () => {
  const ready = () => page.waitForSelector('body[data-view="technician"]');  // the page's script has read the kept choice
  await page.goto(`${address}?view=technician`);
  await ready();
  assert.equal(await page.isChecked('#color-video'), false, 'the address alone is not remembered');
  await page.check('#color-video');
  await until('the page takes video', async () => /as video/.test(await colorSaid()));
  await page.reload();
  await ready();
  assert.equal(await page.isChecked('#color-video'), true);
  await page.uncheck('#color-video');
  await until('the page says nothing more', async () => (await colorSaid()) === '');
});

test('video takes a fraction of the bytes of pictures', async () => {
  const [video, pictures] = [await bytesOfOne('/camera/color/video', 'vp8'), await bytesOfOne('/camera/color', 'jpeg')];
  assert.ok(video < 0.3 * pictures, `${video} of ${pictures} bytes`);
});

test('telepalp-view draws the patient by video, and refuses another coding', async () => {
  const file = join(place.folder, 'view.png');
  await program('telepalp-view', ['--connect', server, '--snapshot', file, '--color', 'vp8']);
  assert.ok(readFileSync(file).length > 10_000);
  const wrong = await program('telepalp-view', ['--connect', server, '--snapshot', file, '--color', 'h264']).catch((problem) => problem);
  assert.equal(wrong.code, 2);
  assert.match(wrong.stderr, /fix: give jpeg/);
});

test('a session with video is recorded, described, exported and played', async () => {
  const [session, foxglove] = [join(place.folder, 'a.mcap'), join(place.folder, 'foxglove.mcap')];
  await program('telepalp-record', ['--connect', server, '--out', session, '--seconds', '4', '--color', 'vp8']);
  const {stdout} = await program('telepalp-record', ['info', session]);
  assert.match(stdout, /\/camera\/color\/video/);
  assert.doesNotMatch(stdout, /\/camera\/color\s/);
  await program('telepalp-export', [session, '--foxglove', foxglove]);
  const exported = await program('telepalp-record', ['info', foxglove]);
  assert.match(exported.stdout, /\/camera\/color\s/);
  const played = await place.server(
      join(binDir, 'telepalp-server'), ['--source', `session:${session}`, '--viewer', viewer]);
  await page.goto(`http://127.0.0.1:${played.http_port}/?view=technician`);
  await untilStatus(page, 'the session is drawn', (now) => now.connected && now.frames > 10);
  await until('the page takes the video of the session', async () =>
    /color\/video/.test(await page.textContent('#subscribers') + await page.textContent('#network')));
});

test('where the browser decodes no video, the page takes pictures and says why', async () => {
  const other = await browser.context.newPage();
  await other.route('**/link_worker.js', async (route) => {
    const answer = await route.fetch();
    await route.fulfill({response: answer, body: `delete self.VideoDecoder;${await answer.text()}`});
  });
  await other.goto(`${address}?view=technician&color=video`);
  await until('it says so', async () => /decodes no video/.test(await other.textContent('#color-said')));
  await other.close();
});
