// node designer_test.mjs BIN_DIR: the designer's page in Chromium, served by the real telepalp-study: sliders, the handle
// turned by key and mouse until the sac gives way, linkages that cannot be built, what the address keeps, the search,
// strangers at the door, and Ctrl-C.
import assert from 'node:assert/strict';
import {request} from 'node:http';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {checkNarrowInLight, violations} from './accessibility.mjs';
import {openBrowser, savePicture} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [binDir, pictures] = process.argv.slice(2);  // PICTURES: a folder for screenshots, to be looked at
const place = new Workplace('designer');
let browser, page, address, child;

before(async () => {
  child = place.start(join(binDir, 'telepalp-study'), ['designer', '--operators', '3', '--threads', '1']);
  address = await until('the address is printed', () => {
    if (child.exitCode !== null) throw new Error(child.heard);
    return /^http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}$/m.exec(child.heard)?.[0];
  });
  browser = await openBrowser(place.folder, {width: 1280, height: 800});
  page = browser.page;
  await page.goto(address);
  await live();
});
after(async () => {
  await browser?.context.close();
  await place.end();
});

const live = () => page.waitForFunction(() => window.designer.design !== undefined && document.getElementById('state').dataset.state === 'live');
const frame = () => page.evaluate(() => window.designer.frame);
const force = ([x, y]) => Math.hypot(x, y);
const predicted = () => page.waitForFunction(() => window.designer.prediction !== undefined);
const picture = (name, options) => savePicture(page, pictures, name, options);
async function setNumber(id, value) {
  await page.fill(`#${id}`, String(value));
  await page.press(`#${id}`, 'Tab');
}

test('the linkage is drawn over the tissue, and its overshoot is predicted with an interval', async () => {
  await predicted();
  const {overshoot, hand, operators} = await page.evaluate(() => window.designer.prediction);
  assert.equal(operators, 3);
  assert.ok(overshoot[1] <= overshoot[0] && overshoot[0] <= overshoot[2] && overshoot[0] > 1 && overshoot[0] < 40, String(overshoot));
  assert.ok(hand[0] > 0.1);
  assert.equal(await page.textContent('#overshoot'), overshoot[0].toFixed(1));
  assert.match(await page.textContent('#facts'), /rocker|crank/);
  assert.equal(await page.locator('#dead-points path').count(), 4, 'both ends of both ways');
  assert.deepEqual(await violations(page), []);
  await picture('whole');
});

test('keys push the needle through the sac, and the force at the hand falls', async () => {
  await page.focus('#handle');
  let most = 0;
  for (let i = 0; i < 200; ++i) {
    await page.keyboard.press('ArrowRight');
    const now = await frame();
    most = Math.max(most, force(now.hand_N));
    if (now.layers.sac === 'inside') break;
  }
  await until('the sac is punctured', async () => (await frame()).layers.sac === 'inside');
  await until('the fall is told', async () => /^Sac punctured at \d+\.\d mm: the force at the hand fell/.test(await page.textContent('#puncture')));
  const {before, after} = (await frame()).punctures.at(-1);
  assert.ok(after < 0.6 * before, `${before} N to ${after} N`);
  assert.ok(most > 0.2, `${most} N at the hand`);
  assert.match(await page.getAttribute('#handle', 'aria-valuetext'), /below the skin/);
  assert.deepEqual(await violations(page), []);
  await picture('punctured');
});

test('the handle follows the mouse, back to whole tissue', async () => {
  await page.click('#renew');
  await until('the needle is outside', async () => (await frame()).layers.skin === 'outside' && (await frame()).punctures.length === 0);
  const box = await page.locator('#handle .d-knob').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const {c} = await frame();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 40, {steps: 10});
  await page.mouse.move(x - 60, y - 60, {steps: 15});
  await page.mouse.up();
  await until('the handle has moved', async () => force((await frame()).c.map((value, axis) => value - c[axis])) > 5);
});

test('any part follows the mouse from where it is taken', async () => {
  for (const [part, one, other] of [['link1', 'a', 'p'], ['needle', 'p', 'tip']]) {
    const at = await frame();
    const middle = at[one].map((value, axis) => 0.3 * value + 0.7 * at[other][axis]);
    const [x, y] = await page.evaluate(([mmX, mmY]) => {
      const seen = new DOMPoint(mmX, -mmY).matrixTransform(document.getElementById('drawing').getScreenCTM());
      return [seen.x, seen.y];
    }, middle);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await until(`the ${part} is held`, async () => (await frame()).held === part);
    let most = 0;  // of the tip; the part moves along one of the ways alone
    for (const [right, down] of [[30, 0], [0, 30], [-30, 0], [0, -30]]) {
      await page.mouse.move(x + right, y + down, {steps: 10});
      await sleep(300);
      most = Math.max(most, force((await frame()).tip.map((value, axis) => value - at.tip[axis])));
    }
    assert.ok(most > 3, `the tip moved by ${most} mm`);
    if (part === 'link1') await picture('link-held');
    await page.mouse.up();
  }
  await page.focus('#handle');
  await page.keyboard.press('ArrowLeft');
  await until('a key takes the handle', async () => (await frame()).held === 'handle');
  assert.deepEqual(await violations(page), []);
});

test('a slider changes the linkage while the needle is in, and the prediction says that it is old', async () => {
  await page.click('#renew');
  await until('the tissue is whole', async () => (await frame()).punctures.length === 0);
  await page.click('#push');
  await until('the sac is punctured', async () => (await frame()).layers.sac === 'inside');
  const deep = -(await frame()).tip[1];
  await predicted();
  await page.focus('#slider-l_h');
  for (let i = 0; i < 30; ++i) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => window.designer.prediction === undefined);
  assert.match(await page.textContent('#prediction-note'), /as it was/);
  await until('the needle is as deep', async () => Math.abs(-(await frame()).tip[1] - deep) < 3);
  assert.equal(await page.inputValue('#value-l_h'), '170');
  await predicted();
  assert.doesNotMatch(await page.textContent('#prediction-note'), /as it was/);
});

test('links that cannot close are refused with their lengths, and the last linkage stays drawn', async () => {
  const drawn = await page.getAttribute('.d-l3', 'd');
  await setNumber('value-l4', 400);
  await page.waitForSelector('#refused:not([hidden])');
  assert.match(await page.textContent('#refused'), /l4 = 400 mm cannot close.*longest link shorter/s);
  assert.equal(await page.getAttribute('.d-l3', 'd'), drawn);
  assert.deepEqual(await violations(page), []);
  await picture('refused');
  await setNumber('value-l4', 135);
  await page.waitForSelector('#refused', {state: 'hidden'});
});

test('linkages are kept for comparison, and the address brings them back', async () => {
  await predicted();
  await page.click('#save');
  await page.selectOption('#preset', {index: 24});
  await predicted();
  await page.click('#save');
  await page.waitForFunction(() => location.hash.includes('k=B'));
  const kept = await page.textContent('#compare-body');
  const line = await page.textContent('#line');
  await page.reload();
  await live();
  assert.equal(await page.textContent('#line'), line);
  assert.equal(await page.textContent('#compare-body'), kept);
  assert.deepEqual(await violations(page), []);
  await picture('compared', {fullPage: true});
  await page.click('#compare-body tr:first-child th button');
  assert.equal(await page.inputValue('#value-l4'), '135');
});

test('a search finds a front, whose points load into the sliders', async () => {
  await page.fill('#evaluations', '40');
  await page.click('#search');
  await page.waitForSelector('#front:not([hidden])');
  await page.waitForSelector('#search:not([hidden])');
  assert.match(await page.textContent('#search-note'), /linkages that no other one beats/);
  const before = await page.textContent('#line');
  await page.locator('#front-chart .front').first().focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction((line) => document.getElementById('line').textContent !== line, before);
  assert.equal(await page.isVisible('#refused'), false);
  assert.deepEqual(await violations(page), []);
  await picture('front', {fullPage: true});
});

test('a search can be cancelled, and a box without a range is refused', async () => {
  await page.fill('#evaluations', '2000');
  await page.click('#search');
  await page.waitForFunction(() => document.getElementById('searching').value > 0);
  await page.click('#cancel');
  await page.waitForSelector('#search:not([hidden])');
  await page.fill('#least-l1', '200');
  await page.click('#search');
  await page.waitForSelector('#search-refused:not([hidden])');
  assert.match(await page.textContent('#search-refused'), /l1/);
});

test('the page is whole in the light theme and 800 pixels wide, without a bar at the bottom', async () => {
  await checkNarrowInLight(page, picture);
  assert.deepEqual(browser.problems, []);
});

/** The status of a request with these headers. */
const ask = (target, headers) => new Promise((resolve, reject) => {
  const {hostname, port} = new URL(address);
  request({hostname, port, path: target, headers}, ({statusCode}) => resolve(statusCode)).on('error', reject).end();
});
const UPGRADE = {Connection: 'Upgrade', Upgrade: 'websocket', 'Sec-WebSocket-Version': '13', 'Sec-WebSocket-Key': 'dGhlIHNhbXBsZSBub25jZQ=='};

test('strangers are refused: another host, another site, no token, a large request', async () => {
  const {host, search} = new URL(address);
  assert.equal(await ask('/', {host}), 200);
  assert.equal(await ask('/', {host: `evil.example:${new URL(address).port}`}), 421);
  assert.equal(await ask(`/live${search}`, {...UPGRADE, host, origin: 'http://evil.example'}), 403);
  assert.equal(await ask('/live?token=0', {...UPGRADE, host, origin: `http://${host}`}), 401);
  await assert.rejects(ask('/', {host, 'x-large': 'x'.repeat(20_000)}));
  assert.equal(await ask('/', {host}), 200, 'and the program goes on');
});

test('a port that is taken is told, and Ctrl-C ends the program with status 0', async () => {
  const second = place.start(join(binDir, 'telepalp-study'), ['designer', '--port', new URL(address).port]);
  await second.over;
  assert.equal(second.exitCode, 1);
  assert.match(second.heard, /another program listens at this port.*--port 0/);
  child.kill('SIGINT');
  await child.over;
  assert.equal(child.exitCode, 0, child.heard);
  await page.waitForFunction(() => document.getElementById('state').dataset.state === 'lost');
  assert.match(await page.textContent('#state-text'), /has ended/);
});
