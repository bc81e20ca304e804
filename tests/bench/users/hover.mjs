// A pointer that sweeps over the patient in Chromium without a button, with the real server and station: node hover.mjs
// PROGRAMS VIEWER. Prints rows for `telepalp-bench users`.
import {join} from 'node:path';

import {openBrowser, status, untilStatus} from '../../end_to_end/browser.mjs';
import {connect} from '../../end_to_end/hand_client.mjs';
import {sleep, until, Workplace} from '../../end_to_end/running_program.mjs';

const [programs, viewer] = process.argv.slice(2);
const IN_CONTACT = [1, 5, 6, 7], OUT_BODY = 3, FAULTED = 9;
const CLEAR_MS = 5000;  // to fly over the patient after a sweep, the device takes up to 3.7 s of virtual time

/** Ways over the page, as shares of the picture: from the bed over arm and trunk to the other side, and back. */
const SWEEPS = [
  [0.5, 0.5, 0.5, 0.2], [0.5, 0.2, 0.5, 0.85], [0.5, 0.85, 0.4, 0.2], [0.4, 0.2, 0.65, 0.8], [0.65, 0.8, 0.3, 0.5],
  [0.3, 0.5, 0.7, 0.5], [0.7, 0.5, 0.5, 0.15], [0.5, 0.15, 0.5, 0.5],
];

const row = (name, value, unit, bound, reach) => console.log([name, value, unit, bound, reach].join('\t'));
const across_m = (a, b) => Math.hypot(a.x - b.x, a.z - b.z);

const workplace = new Workplace('hover');
let browser;
try {
  const {port, http_port} = await workplace.server(join(programs, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer]);
  const station = workplace.start(join(programs, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`, '--tracker', 'browser']);
  await until('the station ticks', () => station.heard.includes('control loop runs at 2 kHz'));
  const {client, heard} = await connect(http_port);
  browser = await openBrowser(workplace.folder, {width: 900, height: 700});
  const {page} = browser;
  await page.goto(`http://127.0.0.1:${http_port}/`);
  await untilStatus(page, 'the patient is drawn', (now) => now.connected && now.meshVertices > 200);
  await page.keyboard.press('t');
  const {x, y, width, height} = await page.locator('#scene').boundingBox();
  const place = (across, down) => [x + across * width, y + down * height];
  await page.mouse.move(...place(0.5, 0.5));
  await until('the hand is followed', () => heard.phase === OUT_BODY, 120_000);
  let entered = 0, faults = 0, moved = 0, drive_N = 0;
  for (const [fromX, fromY, toX, toY] of SWEEPS) {
    await page.mouse.move(...place(fromX, fromY));
    const [before, device] = [heard.states.length, heard.states.at(-1).device];
    await page.mouse.move(...place(toX, toY), {steps: 4});  // some tens of milliseconds: faster than 3 m/s over the patient
    await sleep(CLEAR_MS);
    const since = heard.states.slice(before);
    if (since.some(({phase}) => IN_CONTACT.includes(phase))) ++entered;
    if (since.some(({phase}) => phase === FAULTED)) ++faults;
    if (across_m(heard.states.at(-1).device, device) > 0.03) ++moved;
    drive_N = Math.max(drive_N, (await status(page)).force_N);
  }
  await until('the device waits', () => heard.phase === OUT_BODY, 20_000);
  await page.mouse.down();
  const pressed = await until('the skin is met', () => IN_CONTACT.includes(heard.phase), 20_000).catch(() => false);
  await page.mouse.up();
  row('hover in Chromium: sweeps without a button that enter the body, of 8', entered, '', 'at_most', 0);
  row('hover in Chromium: faults', faults, '', 'at_most', 0);
  row('hover in Chromium: sweeps that the device follows, of 8', moved, '', 'at_least', 7);
  row('hover in Chromium: largest force of contact that the page shows meanwhile', drive_N, 'N', 'at_most', 0);
  row('hover in Chromium: presses after the sweeps that meet the skin, of 1', pressed ? 1 : 0, '', 'at_least', 1);
  client.close();
} finally {
  await browser?.context.close();
  await workplace.end();
}
