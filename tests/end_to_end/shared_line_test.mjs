// What the people at a page are told while a download shares the line to the station: shared_line_test.sh runs it as node
// shared_line_test.mjs PID_IN_THE_DOCTORS_NETWORK BIN_DIR VIEWER_DIR [PICTURES]
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import net from 'node:net';
import {join} from 'node:path';
import test from 'node:test';

import {openBrowser, untilStatus} from './browser.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [doctor, binDir, viewer, pictures] = process.argv.slice(2);
const PATIENT = '10.9.0.1';
const DOCTOR = '10.9.0.2';
const SINK = "require('net').createServer((socket) => socket.resume()).listen(9000, () => console.log('listening'))";
const TITLE = 'Something else uses this line';

/** A program in the doctor's network. */
const atDoctor = (place, program, args) => place.start('nsenter', ['-t', doctor, '-n', program, ...args]);

/** A download by the doctor, which takes what the line gives until it is destroyed. */
function download() {
  const socket = net.connect({host: DOCTOR, port: 9000});
  const block = Buffer.alloc(1 << 16);
  const more = () => { while (socket.write(block)); };
  socket.on('connect', more).on('drain', more).on('error', () => {});
  return socket;
}

test('a download on the line is told on the page, with the share that is left, and the touch goes on', async () => {
  const place = new Workplace('shared_line');
  let browser;
  let flow;
  try {
    const folder = join(place.folder, 'keys');
    const keys = (...words) => execFileSync(join(binDir, 'telepalp-keys'), [...words, '--dir', folder]);
    keys('authority', '--host', PATIENT);
    keys('server', '--host', PATIENT);
    keys('client', '--name', 'dora', '--role', 'doctor');
    keys('token', '--name', 'tom', '--role', 'technician');
    const [, token] = /^token: (.*)$/m.exec(readFileSync(join(folder, 'tom.token'), 'utf8'));
    const {port, http_port} = await place.server(join(binDir, 'telepalp-server'),
        ['--source', 'synthetic', '--bind', PATIENT, '--viewer', viewer, '--key', join(folder, 'server.key')]);
    const sink = atDoctor(place, process.execPath, ['-e', SINK]);
    const station = atDoctor(place, join(binDir, 'telepalp-station'),
        ['--connect', `${PATIENT}:${port}`, '--key', join(folder, 'dora.key')]);
    await until('the station touches', () => station.heard.includes('control loop runs at 2 kHz'));
    await until('the download can begin', () => sink.heard.includes('listening'));

    browser = await openBrowser(place.folder, {width: 900, height: 640}, {ignoreHTTPSErrors: true});
    const {page} = browser;
    await page.goto(`https://${PATIENT}:${http_port}/`);
    await page.fill('input[name=token]', token);
    await page.check('input[name=consent]');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#scene');
    await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
    const title = () => page.textContent('#banner-title');
    await sleep(4000);
    assert.notEqual(await title(), TITLE, 'nothing is said of a line that is free');

    flow = download();
    await until('the page tells of the download', async () => await page.isVisible('#banner') && (await title()) === TITLE, 20_000);
    const said = await page.textContent('#banner-text');
    const [, left_Mbit_per_s] = /^About ([\d.]+) Mbit\/s are left for the station/.exec(said) ?? [];
    assert.ok(left_Mbit_per_s > 0.5 && left_Mbit_per_s < 20, said);
    if (pictures) await page.screenshot({path: join(pictures, 'shared_line.png')});
    await untilStatus(page, 'the skin is touched meanwhile', (now) => now.force_N > 0.2, 20_000);

    flow.destroy();
    await until('the page takes it back', async () => !(await page.isVisible('#banner')) || (await title()) !== TITLE, 30_000);
  } finally {
    flow?.destroy();
    await browser?.context.close();
    await place.end();
  }
});
