// The real programs, seen in a browser: node browser_test.mjs SERVER STATION VIEWER_DIR
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import test from 'node:test';

import {lookAtMiddle, openBrowser, status, untilStatus} from './browser.mjs';
import {Workplace} from './running_program.mjs';

const [server, station, viewer] = process.argv.slice(2);

test('a browser sees the synthetic patient, and the force move while the station\'s hand palpates', async () => {
  const workplace = new Workplace('browser');
  let browser;
  try {
    const {port, http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer]);
    workplace.start(station, ['--connect', `127.0.0.1:${port}`]);
    browser = await openBrowser(workplace.folder);
    const {context, page, problems} = browser;
    await page.goto(`http://127.0.0.1:${http_port}/`);
    await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
    const pressed = await untilStatus(page, 'the hand presses', (now) => now.force_N > 0.3);
    const moved = await untilStatus(page, 'the force moves', (now) => Math.abs(now.force_N - pressed.force_N) > 0.2);
    assert.ok(moved.force_N <= 10.001, 'the limiter holds');
    assert.ok(pressed.handPosition_m.every(Number.isFinite));
    assert.ok(pressed.surfaceAge_ms > 0, 'the felt surface has an age');
    const seen = await lookAtMiddle(context, await page.screenshot({timeout: 120_000}));
    assert.ok(seen.drawn > 0.5 && seen.colors > 200, JSON.stringify(seen));
    assert.deepEqual(problems, []);
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

test('temporal depth is followed mid-group, and again after the page was stuck for two seconds', async () => {
  const workplace = new Workplace('browser_temporal');
  let browser;
  try {
    const options = ['--source', 'synthetic', '--viewer', viewer, '--depth-mode', 'temporal', '--key-every', '60000'];
    const {http_port} = await workplace.server(server, options);
    browser = await openBrowser(workplace.folder);
    const {page, problems} = browser;
    await page.goto(`http://127.0.0.1:${http_port}/`);
    await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
    await page.evaluate(() => {
      for (const end = performance.now() + 2000; performance.now() < end;);
    });
    const {frames} = await status(page);
    await untilStatus(page, 'frames are shown again', (now) => now.frames > frames + 20 && now.pictureAge_ms < 1000);
    assert.equal((await status(page)).undecodable, 0, 'what the page is given, it can decode');
    assert.deepEqual(problems, []);
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});

test('a doctor signs in by the form of a server with keys, after a mistyped token, and signs out', async () => {
  const workplace = new Workplace('browser_keys');
  let browser;
  try {
    const folder = join(workplace.folder, 'keys');
    const keys = (...words) => execFileSync(join(dirname(server), 'telepalp-keys'), [...words, '--dir', folder]);
    keys('authority', '--host', '127.0.0.1');
    keys('server', '--host', '127.0.0.1');
    keys('token', '--name', 'dora', '--role', 'doctor');
    const [, token] = /^token: (.*)$/m.exec(readFileSync(join(folder, 'dora.token'), 'utf8'));
    const {http_port} = await workplace.server(
        server, ['--source', 'synthetic', '--viewer', viewer, '--key', join(folder, 'server.key')]);
    browser = await openBrowser(workplace.folder, undefined, {ignoreHTTPSErrors: true});  // the authority is the test's own
    const {page} = browser;
    const signIn = async (typed) => {
      await page.fill('input[name=token]', typed);
      await page.check('input[name=consent]');
      await page.keyboard.press('Enter');
    };
    await page.goto(`https://127.0.0.1:${http_port}/?view=qa`);
    await signIn('mistyped');
    await page.waitForSelector('[role=alert]');
    await signIn(token);
    await page.waitForSelector('#scene');
    assert.equal(new URL(page.url()).search, '?view=qa', 'the address that was asked for');
    await page.waitForFunction(() => window.telepalp?.connected && window.telepalp.role === 'doctor');
    await page.goto(`https://127.0.0.1:${http_port}/sign-out`);
    await page.click('button');
    await page.waitForSelector('input[name=token]');
  } finally {
    await browser?.context.close();
    await workplace.end();
  }
});
