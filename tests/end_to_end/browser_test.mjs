// The real programs, seen in a browser: node browser_test.mjs SERVER STATION VIEWER_DIR
import assert from 'node:assert/strict';
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
