// node voice_test.mjs BIN_DIR VIEWER_FILES: doctor and technician talk through the real server, from the microphone of one
// browser to the loudspeaker of another. Microphones are sound files; what they give, and what loudspeakers get, is kept
// by taps in the pages. A recording has the words only with the patient's consent, and plays them again.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, status, untilStatus} from './browser.mjs';
import {until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const run = promisify(execFile);
const place = new Workplace('voice');
const RATE_HZ = 48_000;
const BLOCK = 16_384;  // samples in a block of a tap
const COARSE = 12;  // samples in one of the coarse search

/** A sound like speech as a WAV file: syllables of a voice whose pitch rises and falls. `pitch`: its middle [Hz]. */
function speech(pitch, seconds) {
  const bytes = Buffer.alloc(44 + 2 * RATE_HZ * seconds);
  bytes.write('RIFF', 0);
  bytes.writeUInt32LE(bytes.length - 8, 4);
  bytes.write('WAVEfmt ', 8);
  bytes.writeUInt32LE(16, 16);
  bytes.writeUInt16LE(1, 20);
  bytes.writeUInt16LE(1, 22);
  bytes.writeUInt32LE(RATE_HZ, 24);
  bytes.writeUInt32LE(2 * RATE_HZ, 28);
  bytes.writeUInt16LE(2, 32);
  bytes.writeUInt16LE(16, 34);
  bytes.write('data', 36);
  bytes.writeUInt32LE(bytes.length - 44, 40);
  for (let i = 0, turns = 0; i < RATE_HZ * seconds; ++i) {
    const at_s = i / RATE_HZ;
    turns += (pitch + 25 * Math.cos(4 * Math.PI * at_s) + 20 * Math.cos(2 * Math.PI * at_s / 7)) / RATE_HZ;
    const syllable = Math.sin(Math.PI * (3 + Math.sin(at_s / 2)) * at_s) ** 2;
    let sum = 0;
    for (let harmonic = 1; harmonic <= 10; ++harmonic) sum += Math.sin(2 * Math.PI * harmonic * turns) / harmonic;
    bytes.writeInt16LE(Math.round(6000 * syllable * sum), 44 + 2 * i);
  }
  return bytes;
}

/** Keeps what the microphone gives, and what the loudspeaker gets. Runs in the page, before its scripts. */
function keepSound() {
  window.sound = {microphone: [], loudspeaker: []};
  const connect = AudioNode.prototype.connect;
  AudioNode.prototype.connect = function(to, ...rest) {
    const isLoudspeaker = to === this.context.destination && this.numberOfInputs === 0;
    const kept = isLoudspeaker ? window.sound.loudspeaker :
        this instanceof MediaStreamAudioSourceNode ? window.sound.microphone : undefined;
    if (kept !== undefined) {
      const tap = this.context.createScriptProcessor(16384, 1, 1);
      tap.onaudioprocess = ({inputBuffer}) => kept.push(inputBuffer.getChannelData(0).slice());
      connect.call(this, tap);
      connect.call(tap, this.context.destination);
    }
    return connect.call(this, to, ...rest);
  };
}

async function person(name, view, address, pitch) {
  const folder = join(place.folder, name);
  mkdirSync(folder);
  const file = join(folder, 'speech.wav');
  writeFileSync(file, speech(pitch, 20));
  const browser = await openBrowser(folder, {width: 600, height: 500}, {args: [
    '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream',
    `--use-file-for-fake-audio-capture=${file}`,
  ]});
  await browser.page.addInitScript(keepSound);
  await browser.page.goto(`${address}?view=${view}&mesh=off`);
  await untilStatus(browser.page, `${name}'s page is connected`, (now) => now.connected);
  return browser;
}

/** The last blocks of a kept sound, joined. They cross as text: a list of numbers takes a minute. */
async function kept(page, what, blocks) {
  const text = await page.evaluate(([what, blocks]) => {
    const last = window.sound[what].slice(-blocks);
    const all = new Float32Array(last.length * 16384);
    last.forEach((block, at) => all.set(block, at * 16384));
    const bytes = new Uint8Array(all.buffer);
    let letters = '';
    for (let at = 0; at < bytes.length; at += 8192) letters += String.fromCharCode(...bytes.subarray(at, at + 8192));
    return btoa(letters);
  }, [what, blocks]);
  const bytes = Buffer.from(text, 'base64');
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}

function correlation(a, from, b, at, length) {
  let [ab, aa, bb] = [0, 0, 0];
  for (let i = 0; i < length; ++i) {
    const [x, y] = [a[from + i], b[at + i]];
    ab += x * y;
    aa += x * x;
    bb += y * y;
  }
  return aa > 0 && bb > 0 ? ab / Math.sqrt(aa * bb) : 0;
}

const coarse = (sound) => Array.from({length: Math.floor(sound.length / COARSE)}, (_, at) =>
  sound.slice(at * COARSE, (at + 1) * COARSE).reduce((sum, one) => sum + one, 0) / COARSE);

/** How alike the quarter of a second of `heard` from sample `from` on is, sample by sample, to the place in `said` that fits best. */
function alike(said, heard, from) {
  const length = RATE_HZ / 4;
  const [few, sought] = [coarse(said), coarse(heard.slice(from, from + length))];
  let best = {at: 0, alike: -1};
  const keep = (at, alike) => (best = alike > best.alike ? {at, alike} : best);
  for (let at = 0; at + sought.length <= few.length; ++at) keep(at * COARSE, correlation(sought, 0, few, at, sought.length));
  const middle = best.at;
  best = {at: 0, alike: -1};
  for (let at = Math.max(0, middle - 4 * COARSE); at <= middle + 4 * COARSE && at + length <= said.length; ++at)
    keep(at, correlation(heard, from, said, at, length));
  return best.alike;
}

const button = (page) => page.$eval('#voice', (one) => ({text: one.textContent, open: one.getAttribute('aria-pressed')}));
/** A press that does not wait for a still picture, which a busy machine draws once a second. */
const press = (page) => page.$eval('#voice', (one) => one.click());
const counts = async (page) => (await status(page)).voice;
const untilHeard = (page, side, frames) => untilStatus(
    page, `${frames} frames of ${side} are heard`, (now) => (now.voice?.heard[side]?.played ?? 0) >= frames);
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

let address, server, doctor, technician;
before(async () => {
  const ports = await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic:torso,width=160', '--viewer', viewer]);
  address = `http://127.0.0.1:${ports.http_port}/`;
  server = `127.0.0.1:${ports.port}`;
  doctor = await person('doctor', 'doctor', address, 140);
  technician = await person('technician', 'technician', address, 190);
});
after(async () => {
  await Promise.all([doctor?.context.close(), technician?.context.close()]);
  await place.end();
});

test('nothing is loaded before the button is pressed, and joining leaves the microphone closed', async () => {
  for (const {page} of [doctor, technician]) {
    assert.deepEqual(await button(page), {text: 'Voice', open: null});
    assert.equal(await counts(page), undefined);
    await page.click('#voice');
    await until('the page has joined', async () => (await button(page)).text === 'Muted');
  }
  await pause(1000);
  for (const {page} of [doctor, technician]) {
    assert.equal((await counts(page)).sent, 0, 'nothing is sent while the microphone is closed');
    assert.equal((await page.evaluate(() => window.sound.microphone)).length, 0, 'the microphone is not even asked for');
  }
});

test('what the doctor says is heard at the patient\'s side as it was said', async () => {
  await press(doctor.page);
  await until('the light is on', async () => (await button(doctor.page)).open === 'true');
  assert.deepEqual(await button(doctor.page), {text: '● Speaking', open: 'true'});
  await untilHeard(technician.page, '/doctor/voice', 200);
  const heard = await kept(technician.page, 'loudspeaker', 8);
  const said = await kept(doctor.page, 'microphone', 30);
  // A tap on a busy page loses whole blocks, so each block is sought alone, and the best half of them counts.
  const found = Array.from({length: Math.floor(heard.length / BLOCK)}, (_, at) => alike(said, heard, at * BLOCK + 2000));
  found.sort((a, b) => b - a);
  assert.ok(found[Math.floor(found.length / 2)] > 0.7, `the sound of the loudspeaker is like the microphone's: ${found}`);
  const {concealed, played} = (await counts(technician.page)).heard['/doctor/voice'];
  assert.ok(concealed <= 0.05 * played, `${concealed} of ${played} frames were made up`);
});

test('while muted nothing is sent, and the key V talks while it is held', async () => {
  await press(doctor.page);
  await until('the light is off', async () => (await button(doctor.page)).open === 'false');
  await pause(300);
  const {sent} = await counts(doctor.page);
  await pause(1000);
  assert.equal((await counts(doctor.page)).sent, sent);
  await doctor.page.keyboard.down('v');
  await until('words are sent', async () => (await counts(doctor.page)).sent > sent + 20);
  await doctor.page.keyboard.up('v');
  await until('the light is off again', async () => (await button(doctor.page)).open === 'false');
});

/** The number of messages by topic in a session file. */
async function topicsOf(file) {
  const {stdout} = await run(join(binDir, 'telepalp-record'), ['info', file, '--json']);
  return Object.fromEntries(JSON.parse(stdout).topics.map(({name, messages}) => [name, messages]));
}

test('both are heard at once; only with the patient\'s consent a recording has what they say', async () => {
  const files = [join(place.folder, 'with.mcap'), join(place.folder, 'without.mcap')];
  const record = (file, more) => run(join(binDir, 'telepalp-record'),
      ['--connect', server, '--out', file, '--seconds', '6', '--topics', '*', ...more]);
  const recordings = Promise.all([record(files[0], ['--voice-consent', 'asked by the nurse']), record(files[1], [])]);
  const before = (await counts(doctor.page)).heard['/patient/voice']?.played ?? 0;
  await press(technician.page);
  await press(doctor.page);
  await untilHeard(doctor.page, '/patient/voice', before + 100);
  await recordings;
  const [withConsent, without] = await Promise.all(files.map(topicsOf));
  assert.ok(withConsent['/doctor/voice'] > 100 && withConsent['/patient/voice'] > 100, JSON.stringify(withConsent));
  assert.ok(without['/camera/depth'] > 0);
  assert.deepEqual(Object.keys(without).filter((name) => name.endsWith('/voice')), []);
  const {stdout} = await run(join(binDir, 'telepalp-record'), ['info', files[0]]);
  assert.match(stdout, /asked by the nurse/);
  const clean = join(place.folder, 'clean.mcap');
  await run(join(binDir, 'telepalp-export'), [files[0], '--deidentify', clean]);
  assert.deepEqual(Object.keys(await topicsOf(clean)).filter((name) => name.endsWith('/voice')), []);
});

test('the doctor\'s page had no problem', async () => {
  assert.deepEqual(doctor.problems, []);
  await doctor.context.close();
  doctor = undefined;
});

test('a played session lets both sides be heard again, and nobody can speak into it', async () => {
  const ports = await place.server(
      join(binDir, 'telepalp-server'), ['--source', `session:${join(place.folder, 'with.mcap')}`, '--viewer', viewer]);
  await technician.page.goto(`http://127.0.0.1:${ports.http_port}/?view=technician&mesh=off`);
  await untilStatus(technician.page, 'the session is shown', (now) => now.connected);
  await technician.page.waitForSelector('#timeline', {state: 'visible'});
  await technician.page.click('#voice');
  await until('the page listens', async () => (await button(technician.page)).text === 'Listening');
  await untilHeard(technician.page, '/doctor/voice', 50);
  await untilHeard(technician.page, '/patient/voice', 50);
  const lanes = await technician.page.$$eval('#voice-lanes [data-lane]', (all) => all.map((lane) => [lane.dataset.lane, lane.querySelectorAll('i').length]));
  assert.deepEqual(lanes.map(([name]) => name), ['Patient', 'Doctor'], 'both have a lane on the timeline');
  assert.ok(lanes.every(([, bars]) => bars >= 1), JSON.stringify(lanes));
});

test('at another speed the voices are silent and the button says so; at speed 1 they are heard again', async () => {
  const {page} = technician;
  await page.selectOption('#timeline-speed', '10');
  await until('the button says it', async () => (await button(page)).text === 'Silent at 10 ×');
  await pause(500);
  const {played} = (await counts(page)).heard['/doctor/voice'];
  await pause(1500);
  assert.ok((await counts(page)).heard['/doctor/voice'].played - played <= 2, 'nothing is played');
  await page.selectOption('#timeline-speed', '1');
  await until('the button says it', async () => (await button(page)).text === 'Listening');
  await untilHeard(page, '/doctor/voice', played + 100);
});

test('the technician\'s page had no problem', () => assert.deepEqual(technician.problems, []));
