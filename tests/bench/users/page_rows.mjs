// Rows of telepalp-bench users: node page_rows.mjs PROGRAMS VIEWER
import {execFile} from 'node:child_process';
import {join} from 'node:path';
import {promisify} from 'node:util';

import {bundler} from '../../clients/viewer/bundled.mjs';
import {imageArrivals, watchWith} from '../../clients/viewer/image_arrivals.mjs';
import {openBrowser, status, untilStatus} from '../../end_to_end/browser.mjs';
import {until, Workplace} from '../../end_to_end/running_program.mjs';
import {stopServer, untilLive} from '../../end_to_end/silence.mjs';

const [programs, viewer] = process.argv.slice(2);
const sources = new URL('../../../clients/viewer/src', import.meta.url).pathname;
const bundled = bundler(sources, join(viewer, '../clients/viewer/work'));

const STEPS = 100;
const TOGETHER_MS = 5.001;  // half a period of /station/state

const row = (...cells) => console.log(cells.join('\t'));
const place = new Workplace('page_rows');
const server = (args) => place.server(join(programs, 'telepalp-server'), ['--viewer', viewer, ...args]);

/** Silences of a server that never stops, marked in ten minutes of images over a network of proto/impaired. */
async function falseMarks() {
  const {SilenceWatch} = await bundled('link/silence_watch.ts');
  for (const [profile, kilobytes] of [['lte', 60], ['satellite', 180]]) {
    const {seen, image} = watchWith(SilenceWatch);
    imageArrivals(join(programs, 'telepalp-image-arrivals'), profile, kilobytes, 600).forEach(image);
    row(`page: false marks in 10 minutes, ${profile}, images of ${kilobytes} kB`, seen.marks.length, '', 'at_most', 1);
  }
}

async function silence(page, live) {
  await page.goto(`http://127.0.0.1:${live.http_port}/`);
  await untilStatus(page, 'the hand presses', (now) => now.force_N > 0.3);
  const said = await stopServer(page, live.child);
  await untilLive(page);
  const marked_ms = Math.max(said.light_ms, said.banner_ms, said.dimmed_ms, said.numbersMarked_ms);
  row('page: gap between images, 99 % of the time', said.imageGap_ms, 'ms', 'none', 0);
  row('page: server stopped, marked in light, banner, picture and numbers', marked_ms, 'ms', 'at_most', said.allowed_ms);
  row('page: server stopped, numbers and hand gone', said.handHidden ? said.numbersGone_ms : Infinity, 'ms', 'at_most', 1000);
}

const playback = async (http_port) => (await fetch(`http://127.0.0.1:${http_port}/playback`)).json();
const instantOf = ({shown_ns}) => Number(BigInt(shown_ns) / 1000n) / 1000;

/** Presses `key`; the place of the image that the page then shows with the station's values, or undefined. */
async function step(page, http_port, key) {
  const before = (await playback(http_port)).shown_ns;
  await page.keyboard.press(key);
  return until('the next image is shown with its values', async () => {
    const player = await playback(http_port);
    if (player.shown_ns === before) return false;
    const {pictureInstant_ms, numbersInstant_ms, phase, handInstant_ms} = await status(page);
    const together = Math.abs(numbersInstant_ms - pictureInstant_ms) <= TOGETHER_MS && handInstant_ms === numbersInstant_ms;
    return pictureInstant_ms === instantOf(player) && together && phase !== 'No station' && phase !== '–' && player.shown_s;
  }, 5000).catch(() => undefined);
}

async function steps(page, live) {
  const file = join(place.folder, 'session.mcap');
  await promisify(execFile)(join(programs, 'telepalp-record'),
      ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', '9']);
  const {http_port} = await server(['--source', `session:${file},paused=yes,from_s=1`]);
  await page.goto(`http://127.0.0.1:${http_port}/`);
  await untilStatus(page, 'it is paused', (now) => now.paused && now.meshVertices > 0);
  const forward = [];
  for (let count = 0; count < STEPS; ++count) forward.push(await step(page, http_port, '.'));
  const ahead = forward.filter((at_s, count) => at_s !== undefined && at_s > (forward[count - 1] ?? 0));
  row('page: steps forward that show the next image with the station', ahead.length, '', 'at_least', STEPS);
  const back = [];
  for (let count = 0; count < STEPS; ++count) back.push(await step(page, http_port, ','));
  // The last step leads to the image before the first step.
  const same = back.filter((at_s, count) => at_s !== undefined &&
      (count === STEPS - 1 ? at_s < forward[0] : at_s === forward[STEPS - 2 - count]));
  row('page: steps back that show the same images with the station', same.length, '', 'at_least', STEPS);
}

let browser;
try {
  await falseMarks();
  const live = await server(['--source', 'synthetic:torso,width=160']);
  place.start(join(programs, 'telepalp-station'), ['--connect', `127.0.0.1:${live.port}`]);
  browser = await openBrowser(place.folder, {width: 640, height: 480});
  await silence(browser.page, live);
  await steps(browser.page, live);
} finally {
  await browser?.context.close();
  await place.end();
}
