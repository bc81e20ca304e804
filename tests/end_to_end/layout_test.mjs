// node layout_test.mjs BIN_DIR VIEWER_FILES: cards that fold and stay folded, what a phone, a 3D screen, forced colours
// and a screen reader get, and a session that stands still. The real server plays a recorded session.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {violations} from './accessibility.mjs';
import {openBrowser, untilStatus} from './browser.mjs';
import {patientShares, playRecording} from './played_site.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const WIDE = {width: 1400, height: 900};
const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('layout');
let browser, page, address;

before(async () => {
  address = await playRecording(place, binDir, viewer, 10);
  browser = await openBrowser(place.folder, WIDE);
  page = browser.page;
  await open('doctor');
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

async function open(view) {
  await page.goto(`${address}?view=${view}`);
  await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
}
const fold = (name) => page.locator('.card > h2 > button', {hasText: name}).first();
const isFolded = async (name) => (await fold(name).getAttribute('aria-expanded')) === 'false';
const heightOf = async (selector) => (await page.locator(selector).first().boundingBox())?.height ?? 0;
const text = (id) => page.textContent(`#${id}`);
const play = (now) => fetch(`${address}playback`, {method: 'POST', body: JSON.stringify({play: now})});

test('a card folds to one line with its value, by mouse and by key, and stays folded in its view', async () => {
  const open_px = await heightOf('#readings .reading');
  await fold('Force').click();
  assert.ok(open_px > 100 && (await heightOf('#readings .reading')) < 45, 'one line');
  assert.ok(await page.isVisible('#force'), 'with its value');
  assert.equal(await page.isVisible('#force-plot'), false);
  await fold('Compensated').focus();
  await page.keyboard.press('Enter');
  await page.click('#view-qa');
  assert.equal(await isFolded('Force'), false, 'QA\'s view has its own folds');
  await page.keyboard.press('d');
  await open('doctor');
  assert.deepEqual([await isFolded('Force'), await isFolded('Compensated'), await isFolded('Freshness')], [true, true, false]);
  assert.ok(await page.isVisible('#side'), 'closed in QA\'s view only');
  await open('qa');
  assert.equal(await page.isVisible('#side'), false, 'the closed details stay closed, too');
  await page.keyboard.press('d');
});

test('with folded cards the patient has 70 % of the page in each view, and beside two compared runs', async () => {
  for (const view of ['doctor', 'technician', 'qa']) {
    await open(view);
    if ((await page.getAttribute('#fold-all', 'aria-pressed')) !== 'true') await page.keyboard.press('z');
    if (view === 'qa') {
      await page.waitForSelector('#comparison-card', {state: 'visible'});
      await fold('Compare').click();
      await page.selectOption('#comparison-with', 'other.mcap');
      await page.waitForSelector('#comparison', {state: 'visible'});
      await fold('Compare').click();
    }
    const {uncovered} = await patientShares(page);
    assert.ok(uncovered >= 0.7, `${view}: ${uncovered}`);
    assert.deepEqual(await violations(page), [], view);
    await page.keyboard.press('z');
    assert.equal(await isFolded('Force'), false, 'and the same key unfolds them');
  }
  await page.click('#view-doctor');  // while two sessions are compared in QA's view
});

test('the tones under the plots are explained, and both plots have an axis of time', async () => {
  const bands = await page.evaluate(() => [...document.querySelectorAll('.tones i')].map(({dataset}) => dataset.tone).sort());
  assert.deepEqual(bands, ['alarm', 'between', 'contact', 'free', 'inner', 'quiet']);
  for (const plot of ['#force-plot', '#indentation-plot'])
    await page.locator(`${plot} .u-axis`).first().waitFor({state: 'visible'});  // the plots are drawn 5 times a second
});

test('the details leave phase and alarm of a phone free', async () => {
  await page.setViewportSize({width: 390, height: 760});
  await page.waitForSelector('#side', {state: 'hidden'});
  await play(false);
  await page.waitForSelector('#banner:not([hidden])');
  await page.keyboard.press('d');
  await page.waitForSelector('#side', {state: 'visible'});
  await until('nothing is covered', () => page.evaluate(() => {
    const side = document.getElementById('side').getBoundingClientRect();
    return side.height > 100 && ['badge', 'banner'].every((id) => document.getElementById(id).getBoundingClientRect().bottom <= side.top);
  }), 5000);
  await page.keyboard.press('d');
  await play(true);
  await page.setViewportSize(WIDE);
});

test('a session that stands still is paused, and not old', async () => {
  await play(false);
  await page.waitForSelector('#banner-title:text-is("Paused")');
  await sleep(2500);
  assert.equal(await text('banner-title'), 'Paused');
  assert.deepEqual([await text('picture-age'), await text('site-age'), await text('link-age'), await text('computer-age')],
                   ['paused', '–', '–', '–']);
  await play(true);
});

test('on a 3D screen no card lies over an eye, and both eyes see the same line', async () => {
  await page.focus('#scene');
  await page.keyboard.press('s');
  const seen = await page.evaluate(async () => {
    for (let drawn = 0; drawn < 3; ++drawn) await new Promise(requestAnimationFrame);
    const scene = document.getElementById('scene').getBoundingClientRect();
    const over = [...document.querySelectorAll('.card, .badge, .banner, .hand-notice')]
        .filter((part) => part.getBoundingClientRect().height > 0 && part.getBoundingClientRect().top < scene.bottom)
        .map((part) => part.id || part.className);
    const eyes = [...document.querySelectorAll('.eye')].map((eye) => ({text: eye.textContent, box: eye.getBoundingClientRect()}));
    return {over, texts: eyes.map((eye) => eye.text), apart: eyes[1].box.left - eyes[0].box.left, half: scene.width / 2};
  });
  assert.deepEqual(seen.over, []);
  assert.match(seen.texts[0], /^.+ · [\d.–]+ N/);
  assert.equal(seen.texts[0], seen.texts[1]);
  assert.equal(seen.apart, seen.half);
  await page.keyboard.press('s');
});

test('forced colours leave a pressed button, the current view and a warning to be seen', async () => {
  await page.emulateMedia({forcedColors: 'active'});
  const background = (selector) => page.evaluate((of) => getComputedStyle(document.querySelector(of)).backgroundColor, selector);
  assert.notEqual(await background('#show-hand'), await background('#show-stereo'), 'pressed');
  assert.notEqual(await background('#view-doctor'), await background('#view-qa'), 'current');
  const [age, banner] = await page.evaluate(() => {  // in one turn, because the page writes both again
    const [old, box] = ['surface-age', 'banner'].map((id) => document.getElementById(id));
    old.dataset.old = 'true';
    box.hidden = false;
    box.dataset.level = 'warn';
    const [word, warned] = [getComputedStyle(old, '::before').content, getComputedStyle(box).borderStyle];
    box.dataset.level = 'alarm';
    return [word, `${warned}, then ${getComputedStyle(box).borderStyle}`];
  });
  assert.match(age, /⚠/);
  assert.equal(banner, 'dashed, then double');
  await page.emulateMedia({forcedColors: 'none'});
});

test('in 20 s of palpation the page speaks a few times, and a running time is not spoken again', async () => {
  await open('doctor');
  await page.evaluate(() => {
    window.spoken = [];
    const listen = new MutationObserver((changes) => {
      for (const region of new Set(changes.map(({target}) => (target.closest ? target : target.parentElement).closest('[role=status], [role=alert], [aria-live]'))))
        if (region?.ariaLive !== 'off' && region?.textContent !== '') window.spoken.push(region.textContent.trim());
    });
    for (const region of document.querySelectorAll('[role=status], [role=alert], [aria-live]'))
      listen.observe(region, {childList: true, characterData: true, subtree: true});
  });
  await sleep(20_000);
  const spoken = await page.evaluate(() => window.spoken);
  assert.ok(spoken.length >= 1 && spoken.length <= 8, JSON.stringify(spoken));
  assert.deepEqual(browser.problems, []);
});
