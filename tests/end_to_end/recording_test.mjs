// node recording_test.mjs BIN_DIR VIEWER_FILES: the technician's page begins and ends a recording on the server's
// machine. It needs the tick for consent. The file is complete, names the consent, and can be played.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {mkdirSync, readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {lookAtMiddle, openBrowser, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const run = promisify(execFile);
const place = new Workplace('recording');
const folder = join(place.folder, 'recordings');
let browser, page, address;

before(async () => {
  mkdirSync(folder);
  const {http_port} = await place.server(
      join(binDir, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer, '--record-dir', folder]);
  address = `http://127.0.0.1:${http_port}/`;
  browser = await openBrowser(place.folder);
  page = browser.page;
  await page.goto(`${address}?view=technician`);
  await untilStatus(page, 'a picture is drawn', (now) => now.connected && now.frames > 0);
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const ask = async (command) => {
  const reply = await fetch(`${address}recording`, command && {method: 'POST', body: JSON.stringify(command)});
  return {status: reply.status, text: await reply.text()};
};
const state = async () => JSON.parse((await ask()).text);

test('nobody is recorded without consent, nor by a page of another origin', async () => {
  const refused = await ask({record: true});
  assert.equal(refused.status, 400);
  assert.match(refused.text, /consent/);
  const foreign = await fetch(`${address}recording`, {
    method: 'POST', headers: {Origin: 'https://elsewhere.example'}, body: '{"record":true,"consent":"x"}',
  });
  assert.equal(foreign.status, 403);
  assert.deepEqual(readdirSync(folder), []);
});

test('the technician ticks the consent, records, and ends it; the file is whole', async () => {
  if (!(await page.isVisible('#side'))) await page.keyboard.press('d');
  await page.waitForSelector('#recording', {state: 'visible'});
  assert.equal(await page.isDisabled('#record'), true, 'without the tick there is nothing to press');
  await page.fill('#consent-note', 'study 17, signed');
  await page.check('#consent-given');
  await page.check('#voice-consent');
  await page.click('#record');
  await until('it records', async () => (await state()).phase === 'PHASE_RECORDING' && Number((await state()).bytes) > 100_000);
  await until('the page says so', async () => (await page.textContent('#recording-rows')).includes('Nowrecording'));
  await page.keyboard.press('m');
  await until('the moment is marked', async () => (await page.textContent('#mark')) === 'Mark · 1');
  const second = await ask({record: true, consent: 'x'});
  assert.match(second.text, /a recording is running/);
  await page.focus('#record');
  await page.keyboard.press('Enter');
  const over = await until('it has ended', async () => {
    const now = await state();
    return now.phase === 'PHASE_IDLE' ? now : undefined;
  });
  assert.equal(over.problem, '');
  assert.deepEqual(readdirSync(folder), [over.file]);
  const file = join(folder, over.file);
  await run(join(binDir, 'telepalp-record'), ['verify', file]);
  const {stdout} = await run(join(binDir, 'telepalp-record'), ['info', file]);
  assert.match(stdout, /ticked in the web viewer by local: study 17, signed/);
  assert.match(stdout, /consent to recording what is said: ticked in the web viewer/);
  await until('the next recording needs a new tick', async () => (await page.isDisabled('#record')) && !(await page.isChecked('#consent-given')));
  assert.equal(await page.isChecked('#voice-consent'), false);
  assert.deepEqual(browser.problems, []);
});

test('words and an arrow on the patient reach the other pages', async () => {
  const other = await browser.context.newPage();
  await other.goto(`${address}?view=doctor`);
  await untilStatus(other, 'a picture is drawn', (now) => now.connected && now.frames > 0);
  await page.bringToFront();
  await page.keyboard.press('w');
  await page.fill('#say-text', 'turn him to the left');
  await page.click('#say-point');
  await page.mouse.click(450, 300);
  await until('the press gave the place', async () => (await page.getAttribute('#say-point', 'aria-pressed')) === 'false');
  await page.keyboard.press('Enter');
  await until('the writer sees the words', async () => (await page.textContent('#said')).includes('turn him to the left'));
  await other.bringToFront();
  await until('the other page has them', async () => (await other.textContent('#said')).includes('turn him to the left'));
  const said = (await (await fetch(`${address}marks`)).json()).newest.at(-1);
  // On a slow machine the page greys the picture as stale, and the arrow with it.
  await other.evaluate(() => document.getElementById('scene').style.setProperty('filter', 'none', 'important'));
  const arrow = await until('the other page draws the arrow', async () => {
    // An arrow stands for 20 s, which a slow machine can take for one picture of a page: it is said again before that.
    await fetch(`${address}marks`, {method: 'POST', body: JSON.stringify({text: said.text, at_m: said.at_m})});
    await other.bringToFront();  // counting the colours opens a page of its own, and a page that is not in front draws nothing
    await sleep(500);
    const seen = await lookAtMiddle(browser.context, await other.screenshot(), [255, 95, 162]);
    return seen.alike > 50 ? seen : undefined;
  });
  assert.ok(arrow.alike > 50);
  const {text, at_m} = said;
  assert.equal(text, 'turn him to the left');
  assert.ok(at_m.z > 0.3 && at_m.z < 2, `the place is ${JSON.stringify(at_m)}`);
  await other.close();
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#say-form'), false);
});

test('the moment that was marked with the key M is a note on the timeline of the recording, and in its report', async () => {
  const [file] = readdirSync(folder);
  const {http_port} = await place.server(join(binDir, 'telepalp-server'), ['--source', `session:${join(folder, file)}`, '--viewer', viewer]);
  const {notes} = await (await fetch(`http://127.0.0.1:${http_port}/playback/notes`)).json();
  assert.equal(notes.length, 1);
  assert.equal(notes[0].text, 'marked');
  const {duration_s} = await (await fetch(`http://127.0.0.1:${http_port}/playback`)).json();
  assert.ok(notes[0].at_s >= 0 && notes[0].at_s <= duration_s, `${notes[0].at_s} of ${duration_s} s`);
  const {page} = browser;
  await page.goto(`http://127.0.0.1:${http_port}/?view=qa`);
  await until('the note is listed', async () => (await page.textContent('#notes')).includes('marked'));
  assert.equal(await page.isHidden('#mark'), true, 'a played session has no moment to mark');
  await run(join(binDir, 'telepalp-report'), [join(folder, file), '--out', join(place.folder, 'report')]);
  assert.match(readFileSync(join(place.folder, 'report', 'report.json'), 'utf8'), /"marked"/);
});

test('a server that ends completes the recording', async () => {
  const begun = await ask({record: true, consent: 'study 18, signed'});
  const {file} = JSON.parse(begun.text);
  await until('bytes come', async () => Number((await state()).bytes) > 100_000);
  const server = place.programs[0];
  server.kill('SIGTERM');
  await server.over;
  await run(join(binDir, 'telepalp-record'), ['verify', join(folder, file)]);
});
