// A server that stops without closing its connections, and one that pauses: node silence_test.mjs BIN_DIR VIEWER_FILES
// With TELEPALP_PICTURES=DIR the page with a stopped server is written there.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, status, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';
import {stopServer, untilLive} from './silence.mjs';

const pictures = process.env.TELEPALP_PICTURES;
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('silence');
const session = join(place.folder, 'session.mcap');
let live, browser;

before(async () => {
  live = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--source', 'synthetic:torso,width=160']);
  place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${live.port}`]);
  browser = await openBrowser(place.folder, {width: 640, height: 480});
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

test('light, banner, picture and numbers say within 0.3 s that the server is silent, and the numbers are gone within 1 s', async () => {
  const {page, problems} = browser;
  await page.goto(`http://127.0.0.1:${live.http_port}/`);
  await untilStatus(page, 'the hand presses', (now) => now.force_N > 0.3);
  const said = await stopServer(page, live.child);
  const words = JSON.stringify(said);
  for (const part of ['light_ms', 'banner_ms', 'dimmed_ms', 'numbersMarked_ms'])
    assert.ok(said[part] <= said.allowed_ms, `${part}: ${words}`);
  assert.ok(said.numbersGone_ms <= 1000, words);
  assert.ok(said.handHidden, 'hand and force leave the picture with the numbers');
  console.log(words);
  await untilLive(page);
  assert.deepEqual(problems, []);
});

test('the words of a silent server do not blame the network or claim that the connection works', async () => {
  const {page} = browser;
  live.child.kill('SIGSTOP');
  await until('the banner says so', async () => /^Nothing has come from the server for 2 s/.test(await page.textContent('#banner-text')));
  if (pictures !== undefined) {
    await page.setViewportSize({width: 1400, height: 900});
    await page.screenshot({path: join(pictures, 'silent_server.png')});
    await page.setViewportSize({width: 640, height: 480});
  }
  live.child.kill('SIGCONT');
  await untilLive(page);
});

test('a paused session is not stale, and its numbers stay, whoever paused it', async () => {
  const {page} = browser;
  await promisify(execFile)(join(binDir, 'telepalp-record'),
    ['--connect', `127.0.0.1:${live.port}`, '--out', session, '--seconds', '6']);
  const {http_port} = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--source', `session:${session}`]);
  await page.goto(`http://127.0.0.1:${http_port}/`);
  await untilStatus(page, 'it plays', (now) => now.meshVertices > 0 && now.numbersInstant_ms !== undefined);
  const command = (body) => fetch(`http://127.0.0.1:${http_port}/playback`, {method: 'POST', body});
  await command('{"play": false}');
  await untilStatus(page, 'the page knows', (now) => now.paused);
  await sleep(1000);
  // A station that stuttered while it was recorded has no numbers for some pictures.
  for (let tries = 0; tries < 10 && (await status(page)).numbersInstant_ms === undefined; ++tries) {
    await command('{"step": 1}');
    await sleep(1000);
  }
  await sleep(3000);
  const {stale, numbersInstant_ms, pictureInstant_ms} = await status(page);
  assert.equal(stale, false);
  assert.ok(Math.abs(numbersInstant_ms - pictureInstant_ms) <= 5.001, 'the numbers of the picture');
  assert.equal(await page.getAttribute('body', 'data-old'), 'false');
  assert.equal(await page.textContent('#banner-title'), 'Paused');
  assert.equal(await page.getAttribute('#link', 'data-state'), 'live');
});
