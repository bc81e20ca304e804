// node timeline_test.mjs BIN_DIR VIEWER_FILES: a browser moves a session that the real server plays, by the page's timeline.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {openBrowser, ownPlayback, status, untilStatus} from './browser.mjs';
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

test('a slider leaves letters and digits to the page', async () => {
  const {page} = browser;
  const side = await page.isVisible('#side');
  await page.locator('#timeline-slider').focus();
  await page.keyboard.press('d');
  await until('D shows or hides the details', async () => (await page.isVisible('#side')) !== side);
  await page.keyboard.press('d');
  await page.keyboard.press('2');
  await untilStatus(page, '2 chooses the technician\'s view', ({view}) => view === 'technician');
  await page.keyboard.press('1');
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

const part = async (name) => (await fetch(`http://127.0.0.1:${played.http_port}/playback/${name}`)).json();
const text = (id) => browser.page.textContent(`#${id}`);

test('QA impairs the network by mouse and by keyboard, and page and counts show what it does', async () => {
  const {page} = browser;
  await page.keyboard.press('3');
  if (!(await page.isVisible('#side'))) await page.keyboard.press('d');
  await page.locator('#impaired').waitFor();
  assert.match(await text('impaired-rows'), /In effectnone/);
  await page.locator('#timeline-play').click();
  await untilState('it is paused', ({playing}) => !playing);
  const {position_s} = await state();
  await page.locator('#impaired-delay_ms').focus();
  await page.keyboard.press('End');
  await until('the longest delay is in effect', async () => (await part('network')).delay_ms === 600);
  await page.keyboard.press('ArrowLeft');
  await until('one step less', async () => (await part('network')).delay_ms === 595);
  assert.equal((await state()).position_s, position_s, 'the arrow moved the slider, and not the session');
  await page.locator('#timeline-play').click();
  await until('images arrive late', async () => (await part('network')).image_delay_ms >= 595);
  await untilStatus(page, 'the picture is that old', (now) => now.pictureAge_ms >= 595);
  await page.locator('#impaired-loss_percent').click();  // in its middle
  const {loss_percent} = await until('loss is in effect', async () => {
    const now = await part('network');
    return now.loss_percent > 10 && now.loss_percent < 20 ? now : undefined;
  });
  await until('packets are lost', async () => Number((await part('network')).packets_lost) > 20);
  await until('the page counts them', async () => /Packets\d+, [1-9][\d.]* % lost/.test(await text('impaired-rows')));
  assert.match(await text('impaired-rows'), /In effectnone, changed/);
  assert.equal(await page.getAttribute('#impaired-loss_percent', 'aria-valuetext'), `${loss_percent} %`);
  await page.locator('#impaired-profile').selectOption('lte');
  await until('the profile is in effect', async () => (await part('network')).delay_ms === 25);
  await until('the slider follows', async () => (await page.getAttribute('#impaired-delay_ms', 'aria-valuetext')) === '25 ms');
  await page.locator('#impaired-profile').selectOption('none');
  await until('nothing is impaired', async () => /In effectnone, as recorded/.test(await text('impaired-rows')));
  const {frames} = await status(page);
  await untilStatus(page, 'pictures come again', (now) => now.frames > frames + 2);
});

test('QA notes a moment: it is kept beside the session, drawn, listed, shared, and removed', async () => {
  const {page} = browser;
  await page.locator('#timeline-play').click();
  await untilState('it is paused', ({playing}) => !playing);
  await page.locator('#timeline-slider').fill('5');
  await untilState('5 s are reached', ({position_s}) => position_s === 5);
  const shown_s = (await state()).shown_s;
  await until('the card names the moment of the shown picture', async () => /^0:0(4\.9|5\.0)$/.test(await text('note-at')));
  await sleep(2200);  // after a seek, the page waits before it asks again
  await page.locator('#note-text').focus();
  await page.keyboard.type('rebound, d. here');  // keys that move the session elsewhere
  await page.keyboard.press('Enter');
  const [note] = await until('the server has it', async () => {
    const {notes} = await part('notes');
    return notes.length === 1 ? notes : undefined;
  });
  assert.equal(note.text, 'rebound, d. here');
  assert.ok(note.at_s > shown_s && note.at_s < 5 && note.at_s - shown_s < 0.1, `behind the exposure at ${shown_s} s: ${note.at_s} s`);
  assert.deepEqual([(await state()).playing, (await state()).position_s], [false, 5]);
  assert.deepEqual(JSON.parse(readFileSync(`${file}.notes.json`, 'utf8')).notes, [note]);
  await until('it is on the timeline', async () => (await page.locator('#overview b.note').count()) === 1);
  await page.locator('#timeline-slider').fill('9');
  await untilState('it is elsewhere', ({position_s}) => position_s === 9);
  await page.locator('#notes .event').click();
  await untilState('the note leads back to the same picture', (now) => now.shown_s === shown_s);
  await until('the card knows it too', async () => /^0:0(4\.9|5\.0) /.test(await text('moment')));
  await sleep(2200);
  await page.click('#share');
  const at_s = (Math.ceil(100 * note.at_s - 1e-6) / 100).toFixed(2);
  await until('the address has moment and note', async () => new URL(page.url()).search === `?view=qa&at_s=${at_s}&note=${note.number}`);
  await page.locator('#timeline-slider').fill('9');
  await untilState('it is elsewhere again', ({position_s}) => position_s === 9);
  await page.reload();
  await until('the address shows this page the same picture', async () =>
    (await ownPlayback(page)).shown_s === shown_s);
  assert.equal((await state()).position_s, 9, 'and leaves the others where they are');
  await untilStatus(page, 'the page runs', () => true);
  if (!(await page.isVisible('#side'))) await page.keyboard.press('d');
  await page.locator('#notes li[aria-current]').waitFor();
  assert.match(await page.locator('#notes li[aria-current]').textContent(), /rebound, d. here/);
  await page.locator('#notes .remove').focus();
  await page.keyboard.press('Enter');
  await until('it is removed', async () => (await part('notes')).notes.length === 0);
  await until('and gone from the timeline', async () => (await page.locator('#overview b.note').count()) === 0);
});

test('a double click adds one note, and removes one', async () => {
  const {page} = browser;
  await page.goto(`http://127.0.0.1:${played.http_port}/?view=qa`);
  await page.locator('#timeline').waitFor();
  if (!(await page.isVisible('#side'))) await page.keyboard.press('d');
  await page.locator('#note-form').waitFor();
  const count = async () => (await part('notes')).notes.length;
  for (const text of ['first', 'second', 'third']) {
    await page.fill('#note-text', text);
    await page.dblclick('#note-form button');
    await until('the note is listed', async () => (await page.textContent('#notes')).includes(text));
  }
  assert.equal(await count(), 3);
  await page.click('#notes .remove >> nth=0', {clickCount: 2, delay: 100});
  await until('a note is removed', async () => (await page.locator('#notes .event').count()) < 3);
  await sleep(500);
  assert.equal(await count(), 2);
  assert.equal(await text('notes-said'), '');
});

test('a refused command and a server that does not answer are explained on the page', async () => {
  const {page} = browser;
  const problem = page.locator('#timeline-problem');
  await page.route('**/playback', (route) => (route.request().method() === 'POST'
    ? route.fulfill({status: 403, body: 'only technicians and QA may control a played session'}) : route.continue()));
  await page.locator('#timeline-step').click();
  await until('the refusal is shown', async () => (await problem.textContent()) ===
    'The server refused: only technicians and QA may control a played session.');
  await page.unroute('**/playback');
  played.child.kill('SIGTERM');
  await until('the end of the server is shown', async () => /does not answer/.test(await problem.textContent()), 20_000);
});
