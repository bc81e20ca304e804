// The viewer's states, one by one, on a scripted stage: node viewer_test.mjs STAGE VIEWER_DIR
import assert from 'node:assert/strict';
import {readdirSync} from 'node:fs';
import http from 'node:http';
import test from 'node:test';

import {lookAtMiddle, openBrowser, status, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [stage, viewer] = process.argv.slice(2);

async function startStage(workplace, port = 0) {
  const child = workplace.start(stage, ['--http-port', String(port), '--viewer', viewer]);
  const address = await until('the stage listens', () => /http:\S+/.exec(child.heard)?.[0]);
  return {child, address, port: Number(new URL(address).port)};
}

const banner = (page) => page.textContent('#banner:not([hidden])', {timeout: 60_000});

/** Waits until the banner's text matches `says`. The error after a time-out quotes the banner's last text. */
async function untilBanner(page, says) {
  let last;
  await until('the banner', async () => says.test(last = await page.textContent('#banner'))).catch((error) => {
    throw new Error(`${error.message}: it says '${last}' and not ${says}`);
  });
}

test('the viewer draws the patient, follows the hand, and says when what it shows is old', async () => {
  const workplace = new Workplace('viewer');
  let browser;
  try {
    let running = await startStage(workplace);
    browser = await openBrowser(workplace.folder);
    const {context, page, problems} = browser;
    await page.goto(running.address);
    await untilStatus(page, 'the mesh is drawn', (now) => now.meshVertices > 200);
    const pressed = await untilStatus(page, 'the hand presses', (now) => now.force_N > 2 && now.phase === 'Pressing the skin' && now.handPosition_m !== undefined);
    assert.ok(pressed.indentation_m > 0.02 && pressed.indentation_m < 0.04, `${pressed.indentation_m} m`);
    assert.equal(pressed.handPosition_m.length, 3);
    await untilStatus(page, 'the hand leaves', (now) => now.force_N === 0 && now.phase === 'Above the skin');
    const seen = await lookAtMiddle(context, await page.screenshot({timeout: 120_000}));
    assert.ok(seen.drawn > 0.5 && seen.colors > 200, `the patient fills the middle, shaded: ${JSON.stringify(seen)}`);
    assert.deepEqual(problems, [], 'nothing breaks the page\'s own content policy');

    await page.keyboard.press('?');
    await page.waitForSelector('#help[open]');
    await page.keyboard.press('Escape');
    await page.waitForSelector('#help:not([open])', {state: 'attached'});
    await page.keyboard.press('h');
    assert.equal(await page.getAttribute('#show-hand', 'aria-pressed'), 'false');
    await untilStatus(page, 'the hand is hidden', (now) => now.handPosition_m === undefined);
    await page.click('#show-hand');

    assert.equal(await page.isVisible('#depth'), false, 'depth as measured needs no words');
    running.child.stdin.write('bounded on\n');
    await page.waitForSelector('#depth-off:text-is("off by up to 2.85 mm at 1 m")');
    assert.equal(await page.textContent('#depth-mode'), 'depth: bounded');
    assert.equal((await status(page)).depth, 'bounded, off by up to 2.85 mm at 1 m');
    running.child.stdin.write('bounded off\n');
    await page.waitForSelector('#depth', {state: 'hidden'});

    running.child.stdin.write('hand off\n');
    await untilStatus(page, 'no hand is drawn when there is none', (now) => now.handPosition_m === undefined);
    await until('the page says so', async () => (await banner(page)).includes('No hand'));
    await page.keyboard.press('t');
    await page.mouse.move(450, 400);
    await until('Touch says what it wants', async () => (await banner(page)).includes('deploy/demo --hand browser'));
    await page.keyboard.press('t');
    running.child.stdin.write('hand on\n');
    await untilStatus(page, 'the hand is drawn again', (now) => now.handPosition_m !== undefined);

    running.child.stdin.write('phase PHASE_CYLINDER_UPPER\n');
    await page.waitForSelector('#phase-name:text-is("On an inner object")');
    running.child.stdin.write('phase PHASE_FAULTED\n');
    await until('the banner names the fault', async () => (await banner(page)).includes('Station faulted'));
    running.child.stdin.write('phase PHASE_OUT_BODY\nstale on\n');
    await until('the banner names the stale surface', async () => (await banner(page)).includes('No surface to feel'));
    running.child.stdin.write('stale off\npause\n');
    await until('the banner names the stale picture', async () => (await banner(page)).includes('Stale picture'));

    running.child.stdin.end();
    await running.child.over;
    await until('the banner names the lost server', async () => (await banner(page)).includes('Disconnected'));
    assert.equal((await status(page)).connected, false);
    const before = (await status(page)).frames;
    running = await startStage(workplace, running.port);
    await untilStatus(page, 'it comes back by itself', (now) => now.connected && now.frames > before);
    await page.waitForSelector('#banner', {state: 'hidden'});
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

/** Notes the distance from the camera [m] of each hand that the page sends. */
const noteHands = (page) => page.addInitScript(() => {
  window.handDistances_m = [];
  const send = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function(message, ...rest) {
    const at = message?.hand?.handCamera;
    if (at !== undefined) window.handDistances_m.push(Math.hypot(at.x, at.y, at.z));
    return send.call(this, message, ...rest);
  };
});

test('a device that swings is told, and the press is let go until the button is up', async () => {
  const workplace = new Workplace('viewer_swing');
  let browser;
  try {
    const {child, address} = await startStage(workplace);
    browser = await openBrowser(workplace.folder, {width: 640, height: 480});
    const {page, problems} = browser;
    await noteHands(page);
    await page.goto(address);
    await untilStatus(page, 'the mesh is drawn', (now) => now.meshVertices > 200);
    const height_m = (from) => page.evaluate(() => window.handDistances_m.at(-1)).then((now) => from - now);
    await page.keyboard.press('t');
    await page.mouse.move(320, 260);
    await until('the hand hovers', () => page.evaluate(() => window.handDistances_m.length > 50));
    const hover_m = await page.evaluate(() => window.handDistances_m.at(-1));
    await page.mouse.down();
    await until('the hand presses', async () => await height_m(hover_m) < -0.07);
    assert.equal((await status(page)).unsteady, undefined);
    child.stdin.write('swing on\n');
    await untilBanner(page, /The device swings.*by 6 mm, 4 times a second, and the hand rests\. Your press is let go/);
    await until('the hand has risen, with the button down', async () => Math.abs(await height_m(hover_m)) < 0.02);
    child.stdin.write('swing off\n');
    await untilStatus(page, 'the device is steady', (now) => now.unsteady === undefined);
    await sleep(500);
    assert.ok(Math.abs(await height_m(hover_m)) < 0.02, 'the same press does not begin again');
    await page.mouse.up();
    await page.mouse.down();
    await until('a new press goes in', async () => await height_m(hover_m) < -0.07);
    assert.deepEqual(problems, []);
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

const SAFETY = ['force', 'indentation', 'phase-name', 'surface-age', 'picture-age', 'link-age', 'computer-age', 'late'];

/** Those of `ids` that cannot be read: not shown, not completely in the window, or covered. */
const unreadable = (page, ids) => page.evaluate((wanted) => {
  const boxOf = (element) => element.getBoundingClientRect();
  const covers = [...document.querySelectorAll('.banner:not([hidden]), .tools, .top')];
  return wanted.filter((id) => {
    const element = document.getElementById(id);
    const box = boxOf(element);
    if (box.width === 0 || box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight) return true;
    return covers.map(boxOf).some((cover) => cover.width > 0 && box.left < cover.right && cover.left < box.right &&
        box.top < cover.bottom && cover.top < box.bottom);
  });
}, ids);

test('the safety readings stay in view in a small window, with a banner and a note on depth beside them', async () => {
  const workplace = new Workplace('viewer_small');
  let browser;
  try {
    const {child, address} = await startStage(workplace);
    browser = await openBrowser(workplace.folder);
    const {page} = browser;
    await page.goto(address);
    await untilStatus(page, 'the mesh is drawn', (now) => now.meshVertices > 200);
    child.stdin.write('bounded on\nphase PHASE_CYLINDER_LATERAL\nstale on\n');
    await page.waitForSelector('#banner:not([hidden])');
    for (const [width, height] of [[1400, 900], [900, 640], [390, 760], [390, 500], [700, 420], [640, 320], [320, 568]]) {
      await page.setViewportSize({width, height});
      await page.waitForFunction((wide) => innerWidth === wide, width);
      let hidden;  // the page measures its rows again after the window changed, so the first look can come too early
      await until(`all readings at ${width} x ${height}`, async () => (hidden = await unreadable(page, SAFETY)).length === 0)
          .catch((late) => assert.fail(`${late.message}: ${hidden}`));
    }
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

/** Reads the page `times` times: the drawn instants and numbers, and the texts beside them. */
async function looks(page, times) {
  const found = [];
  for (let look = 0; look < times; ++look) {
    found.push(await page.evaluate(() => {
      const text = (id) => document.getElementById(id).textContent;
      const shown = window.telepalp;  // in the same turn of the page, so that nothing is drawn between
      return {...shown, force: text('force'), indentation: text('indentation'), banner: text('banner-text')};
    }));
    await sleep(100);
  }
  return found;
}

test('an overloaded viewer says that this computer is slow, and its numbers stay with its picture', async () => {
  const workplace = new Workplace('viewer_overloaded');
  let browser;
  try {
    const {address} = await startStage(workplace);
    browser = await openBrowser(workplace.folder);
    const {context, page} = browser;
    await page.goto(address);
    await untilStatus(page, 'the mesh is drawn', (now) => now.meshVertices > 200);
    const devtools = await context.newCDPSession(page);
    await devtools.send('Emulation.setCPUThrottlingRate', {rate: 20});
    await page.evaluate(() => window.setInterval(() => {  // and another program that wants the same core
      for (const end = performance.now() + 500; performance.now() < end;);
    }, 600));
    await until('the banner names this computer', async () => (await banner(page)).includes('This computer'));
    const seen = await looks(page, 40);
    const drawn = seen.filter(({handInstant_ms}) => handInstant_ms !== undefined);
    assert.ok(drawn.length > 20, 'a hand is drawn');
    for (const {pictureInstant_ms, handInstant_ms} of drawn)
      assert.ok(Math.abs(pictureInstant_ms - handInstant_ms) <= 5.001, `the hand is ${handInstant_ms - pictureInstant_ms} ms away`);
    for (const {pictureInstant_ms, numbersInstant_ms, force, force_N, indentation, indentation_m} of seen) {
      const apart_ms = numbersInstant_ms - pictureInstant_ms;
      assert.ok(!(Math.abs(apart_ms) > 5.001) || apart_ms > 250, `${apart_ms}: without a new picture, numbers go on after 250 ms`);
      assert.equal(force, numbersInstant_ms === undefined ? '–' : force_N.toFixed(1));
      assert.equal(indentation, numbersInstant_ms === undefined ? '–' : (1000 * indentation_m).toFixed(0));
    }
    const warned = seen.filter(({banner: text}) => text !== '');
    assert.ok(warned.length > 20, 'a slow page is warned of');
    const right = warned.filter(({banner: text}) => text.includes('This computer'));
    assert.ok(right.length > 0.8 * warned.length, 'and not the patient\'s site or the network');
    const links = seen.map(({linkAge_ms}) => linkAge_ms).sort((a, b) => a - b);
    assert.ok(links[20] < 1000, `the queue does not grow: the link is ${links[20]} ms old`);
    assert.ok(new Set(seen.map(({numbersInstant_ms}) => numbersInstant_ms)).size > 3, 'it goes on');
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

/** Files that the page loads only when the user asks for what they do. */
const LATER = ['later_cards.js', 'mixed.js', 'voice.js', 'voice_lanes.js', 'voice_worker.js', 'voice_worklet.js'];

/** Bytes over the wire of everything that the page loads by itself. */
async function weight(address) {
  const files = readdirSync(viewer).filter((name) => !name.endsWith('.br') && name !== 'third_party.txt' && !LATER.includes(name));
  const sizes = await Promise.all(files.map((name) => new Promise((resolve, reject) => {
    http.get(address + name, {headers: {'accept-encoding': 'gzip, br'}}, (reply) => {
      let bytes = 0;
      reply.on('data', (part) => (bytes += part.length)).on('end', () => resolve(bytes));
    }).on('error', reject);
  })));
  return sizes.reduce((sum, bytes) => sum + bytes, 0);
}

/** The cards of the details that are shown. */
const cards = (page) => page.evaluate(() => [...document.querySelectorAll('#side h2')]
    .filter((title) => title.offsetParent !== null).map((title) => title.textContent));

async function viewsTest(page, address) {
  await page.goto(`${address}?view=technician`);
  await untilStatus(page, 'the address chooses the view', (now) => now.view === 'technician' && now.connected);
  await page.goto(address);
  await untilStatus(page, 'without one it is the doctor\'s', (now) => now.view === 'doctor' && now.role === 'local');
  assert.deepEqual(await cards(page), [], 'a small window begins without details');
  await page.keyboard.press('d');
  assert.deepEqual(await cards(page), ['Here now', 'Delay to the hand', 'Compensated']);
  await page.keyboard.press('3');
  await untilStatus(page, 'a key chooses', (now) => now.view === 'qa');
  assert.equal(new URL(page.url()).search, '?view=qa');
  assert.equal(await page.getAttribute('#view-qa', 'aria-current'), 'page');
  await page.click('#view-doctor');
  await untilStatus(page, 'a click chooses', (now) => now.view === 'doctor');
  await page.goBack();
  await untilStatus(page, 'and back goes back', (now) => now.view === 'qa');
}

test('window.telepalp can be read and not set; views are chosen by address, key and click', async () => {
  const workplace = new Workplace('viewer_status');
  let browser;
  try {
    const running = await startStage(workplace);
    browser = await openBrowser(workplace.folder);
    await browser.page.goto(running.address);
    await untilStatus(browser.page, 'the page runs', () => true);
    const after = await browser.page.evaluate(() => {
      try {
        window.telepalp = {connected: 'no'};
      } catch {
        // in strict mode the attempt throws, which is as good
      }
      return {frozen: Object.isFrozen(window.telepalp), connected: typeof window.telepalp.connected};
    });
    assert.deepEqual(after, {frozen: true, connected: 'boolean'});
    const bytes = await weight(running.address);
    assert.ok(bytes <= 250_000, `the page weighs ${bytes} bytes`);
    await viewsTest(browser.page, running.address);
    assert.deepEqual(browser.problems, []);
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});
