// node room_voice_test.mjs BIN_DIR VIEWER_FILES: the server hears the patient's room by ALSA, whose microphone is a sound
// file and whose loudspeaker another. The technician's page opens it; recordings have it with consent alone.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {existsSync, readFileSync, renameSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, untilStatus} from './browser.mjs';
import {until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const run = promisify(execFile);
const place = new Workplace('room_voice');
const RATE_HZ = 48_000;
let recordings = 0;

/** ALSA's configuration; with `there`, it has the device `room`. */
function configure(there) {
  const file = (name) => JSON.stringify(join(place.folder, name));
  writeFileSync(join(place.folder, 'asoundrc.new'), `
    pcm.nothing { type null }
    pcm.room_in { type file slave.pcm nothing file /dev/null infile ${file('said.raw')} format raw }
    pcm.room_out { type file slave.pcm nothing file ${file('played.raw')} format raw }
    ${there ? 'pcm.room { type asym capture.pcm room_in playback.pcm room_out }' : ''}`);
  renameSync(join(place.folder, 'asoundrc.new'), join(place.folder, 'asoundrc'));
}

function sound(seconds) {
  const bytes = Buffer.alloc(2 * RATE_HZ * seconds);
  for (let i = 0; i < RATE_HZ * seconds; ++i)
    bytes.writeInt16LE(Math.round(8000 * Math.sin(2 * Math.PI * 180 * i / RATE_HZ) * Math.sin(Math.PI * 3 * i / RATE_HZ) ** 2), 2 * i);
  return bytes;
}

async function voiceMessages(server, more) {
  const file = join(place.folder, `session_${++recordings}.mcap`);
  await run(join(binDir, 'telepalp-record'), ['--connect', server, '--out', file, '--seconds', '3', '--topics', '*', ...more]);
  const {stdout} = await run(join(binDir, 'telepalp-record'), ['info', file, '--json']);
  return JSON.parse(stdout).topics.find(({name}) => name === '/patient/voice')?.messages ?? 0;
}

const state = async () => (await fetch(`${address}room_voice`)).json();
const card = (page) => page.evaluate(() => {
  const [box, button] = [document.getElementById('room-voice'), document.getElementById('room-microphone')];
  return box === null ? undefined :
      {shown: box.offsetParent !== null, text: button.textContent, light: button.getAttribute('aria-pressed'), says: box.innerText};
});

let address, server, browser;
before(async () => {
  writeFileSync(join(place.folder, 'said.raw'), sound(60));
  configure(true);
  process.env.ALSA_CONFIG_PATH = join(place.folder, 'asoundrc');
  const ports = await place.server(join(binDir, 'telepalp-server'),
      ['--source', 'synthetic:torso,width=160', '--viewer', viewer, '--voice', 'alsa:room', '--health-port', '0']);
  address = `http://127.0.0.1:${ports.http_port}/`;
  server = `127.0.0.1:${ports.port}`;
  browser = await openBrowser(place.folder, {width: 1000, height: 800});
  await browser.page.goto(`${address}?view=technician&mesh=off`);
  await untilStatus(browser.page, 'the page is connected', (now) => now.connected);
  if (!(await browser.page.isVisible('#side'))) await browser.page.keyboard.press('d');
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

test('the microphone begins closed, the loudspeaker plays, and only the technician\'s view has the card', async () => {
  await until('the card is shown', async () => (await card(browser.page))?.shown);
  const {text, light, says} = await card(browser.page);
  assert.deepEqual([text, light], ['Open the microphone', 'false']);
  assert.match(says, /nobody hears the room/);
  assert.equal(await browser.page.locator('#room-voice > h2 > button').getAttribute('aria-expanded'), 'true', 'the card can be folded');
  assert.equal((await state()).open, false);
  await until('the loudspeaker takes sound', () => existsSync(join(place.folder, 'played.raw')) && readFileSync(join(place.folder, 'played.raw')).length > 10_000);
  assert.equal(await voiceMessages(server, ['--voice-consent', 'asked']), 0);
});

test('a press opens it, a light says so, and only recordings with consent have what the room says', async () => {
  const {page} = browser;
  await page.$eval('#room-microphone', (one) => one.click());
  await until('the light is on', async () => (await card(page)).light === 'true');
  assert.equal((await card(page)).text, '● Close the microphone');
  assert.equal((await state()).hears, true);
  if (process.env.TELEPALP_PICTURES !== undefined) await page.screenshot({path: join(process.env.TELEPALP_PICTURES, 'room_voice.png')});
  const withConsent = await voiceMessages(server, ['--voice-consent', 'asked by the nurse']);
  const without = await voiceMessages(server, []);
  assert.ok(withConsent > 80, `${withConsent} messages in 3 s`);
  assert.equal(without, 0);
  const metrics = await (await fetch(`${address}metrics`)).text();
  assert.match(metrics, /^telepalp_room_microphone_open 1$/m);
});

test('a device that is taken away is said, and nothing else suffers; it is heard again when it is back', async () => {
  const {page} = browser;
  await page.$eval('#room-microphone', (one) => one.click());
  await until('the light is off', async () => (await card(page)).light === 'false');
  configure(false);
  await page.$eval('#room-microphone', (one) => one.click());
  await until('the card says why', async () => /The room is not heard: /.test((await card(page)).says));
  assert.equal((await card(page)).light, 'false');
  await untilStatus(page, 'pictures go on', (now) => now.connected && now.frames > 0);
  configure(true);
  await until('it is heard again', async () => (await card(page)).light === 'true');
});

test('the page had no problem', () => assert.deepEqual(browser.problems, []));
