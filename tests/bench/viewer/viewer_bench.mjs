// What the viewer does on this computer: node tests/bench/viewer/viewer_bench.mjs BIN_DIR VIEWER_FILES [--json] [--seconds S]
// Server, station and Chromium without a graphics card run side by side, four times: with the mesh; without the mesh,
// as the upper bound; with an ultrasound probe on the skin, for which the station makes 25 images a second; and with a
// quarter of the pixels, so that the computer keeps up. Prints rows {name, value, unit, reach, holds} like
// telepalp-bench. Run nothing else on the machine meanwhile.
import {mkdirSync, readdirSync, readFileSync, statSync} from 'node:fs';
import {loadavg} from 'node:os';
import {join} from 'node:path';
import {gzipSync} from 'node:zlib';

import {openBrowser, status, untilStatus} from '../../end_to_end/browser.mjs';
import {sceneOfASteadyProbe, sleep, Workplace} from '../../end_to_end/running_program.mjs';

const [binDir, viewer, ...options] = process.argv.slice(2);
if (viewer === undefined) {
  console.error('error: viewer_bench: the folders of the programs and of the viewer are not given. fix: run ' +
      'node tests/bench/viewer/viewer_bench.mjs build/release/bin build/release/viewer');
  process.exit(2);
}
const asJson = options.includes('--json');
const seconds = Number(options[options.indexOf('--seconds') + 1]) || 20;
const SCENES = new URL('../../../haptic_station/scenes', import.meta.url).pathname;
const SIZE = {width: 1280, height: 800};
const SMALL = {size: {width: 640, height: 400}, source: 'synthetic:torso,width=320'};

/**
 * Runs before the page's own scripts: notes long tasks, the first picture and each drawn picture's age. It also looks at
 * the page every 4 ms, between two of its tasks: whether the hand and numbers that it shows are of the picture's instant.
 */
function watch() {
  const seen = (window.seen = {longTasks: [], first_ms: undefined, ages_ms: [], decodes_ms: []});
  const TOGETHER_MS = 5.001;  // half a period of /station/state
  window.restart = () => Object.assign(seen, {looks: 0, handApart: 0, numbersApart: 0, unknown: 0}) &&
      (seen.longTasks.length = seen.ages_ms.length = seen.decodes_ms.length = 0);
  window.restart();
  const compare = ({pictureInstant_ms, handInstant_ms, numbersInstant_ms, force_N}) => {
    if (pictureInstant_ms === undefined) return;
    const isApart = (at_ms) => at_ms !== undefined && Math.abs(at_ms - pictureInstant_ms) > TOGETHER_MS;
    const force = numbersInstant_ms === undefined ? '–' : force_N.toFixed(1);
    ++seen.looks;
    if (isApart(handInstant_ms)) ++seen.handApart;
    if (isApart(numbersInstant_ms) || document.getElementById('force').textContent !== force) ++seen.numbersApart;
    if (numbersInstant_ms === undefined) ++seen.unknown;
  };
  new PerformanceObserver((list) => seen.longTasks.push(...list.getEntries().map(({duration}) => duration)))
      .observe({type: 'longtask', buffered: true});
  let frames = 0;
  setInterval(() => {
    const now = window.telepalp;
    if (now === undefined) return;
    compare(now);
    if (now.frames === frames) return;
    frames = now.frames;
    seen.first_ms ??= performance.now();
    seen.ages_ms.push(now.pictureAge_ms);
    seen.decodes_ms.push(now.decode_ms);
  }, 4);
}

/** Runs before the page's own scripts: notes the first picture, and nothing else. */
function watchFirst() {
  const timer = setInterval(() => {
    if (!(window.telepalp?.frames > 0)) return;
    window.first_ms = performance.now();
    clearInterval(timer);
  }, 8);
}

const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))] ?? NaN;

/** `withProbe`: the hand holds an ultrasound probe on the skin. `source`: the server's option --source. */
async function measure(query, {withProbe = false, size = SIZE, source = 'synthetic', lasts_s = seconds} = {}) {
  const place = new Workplace('viewer_bench');
  let browser;
  try {
    const {port, http_port} = await place.server(join(binDir, 'telepalp-server'), ['--source', source, '--viewer', viewer]);
    const scene = withProbe ? ['--scene', sceneOfASteadyProbe(SCENES, place.folder)] : [];
    const station = place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`, ...scene]);
    browser = await openBrowser(place.folder, size);
    const {page} = browser;
    await page.addInitScript(watch);
    await page.goto(`http://127.0.0.1:${http_port}/${query}`);
    await untilStatus(page, 'a picture with a hand', (now) => {
      if (station.exitCode !== null) throw new Error(`the station ended: ${station.heard}`);
      return now.frames > 3 && now.handPosition_m !== undefined;
    });
    if (withProbe) await untilStatus(page, 'an ultrasound image', (now) => now.probeImages > 3);
    const before = await status(page);
    const began_ms = performance.now();
    await page.evaluate(() => window.restart());
    await sleep(1000 * lasts_s);
    const after = await status(page);
    const took_s = (performance.now() - began_ms) / 1000;
    return {
      ...(await page.evaluate(() => window.seen)),
      pictures_per_s: (after.frames - before.frames) / took_s,
      images_per_s: (after.probeImages - before.probeImages) / took_s,
    };
  } finally {
    await browser?.context.close();
    await place.end();
  }
}

/**
 * Times from navigation to the first picture [ms], each in a new browser that has run for 5 s, and when its page is then
 * opened again. The bench does not talk to the browser meanwhile.
 */
async function firstPictures(runs) {
  const place = new Workplace('viewer_bench_first');
  const times = {new_ms: [], again_ms: []};
  try {
    const {port, http_port} = await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer]);
    place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`]);
    for (let run = 0; run < runs; ++run) {
      const folder = join(place.folder, String(run));
      mkdirSync(folder);
      const {context, page} = await openBrowser(folder, SIZE);
      await page.addInitScript(watchFirst);
      await sleep(5000);
      for (const into of [times.new_ms, times.again_ms]) {
        await page.goto(`http://127.0.0.1:${http_port}/`);
        await sleep(4000);
        into.push(await page.evaluate(() => window.first_ms));
      }
      await context.close();
    }
  } finally {
    await place.end();
  }
  return times;
}

/** Bytes of all files of the page as they cross the network. */
function weight() {
  return readdirSync(viewer).filter((name) => !name.endsWith('.br') && name !== 'third_party.txt').reduce((sum, name) => {
    const compressed = join(viewer, `${name}.br`);
    try {
      return sum + statSync(compressed).size;
    } catch {
      return sum + gzipSync(readFileSync(join(viewer, name)), {level: 9}).length;  // not compressed by the build
    }
  }, 0);
}

const bound = await measure('?mesh=off');
const meshed = await measure('', {lasts_s: 3 * seconds});
const probing = await measure('', {withProbe: true});
const small = await measure('', SMALL);
const first = await firstPictures(3);
const row = (name, value, unit, reach, holds) =>
  ({name, value: Number.isFinite(value) ? Number(value.toFixed(2)) : null, unit, reach, holds});
const most = (name, value, unit, limit) => row(name, value, unit, limit, Number.isFinite(value) && value <= limit);
const rows = [
  row('pictures drawn', meshed.pictures_per_s, '1/s', 15, meshed.pictures_per_s >= 15),
  row('pictures drawn without the mesh', bound.pictures_per_s, '1/s', null, true),
  row('pictures drawn with the mesh, divided by those without',
      meshed.pictures_per_s / bound.pictures_per_s, '', null, true),
  row('ultrasound images drawn in the panel', probing.images_per_s, '1/s', 20, probing.images_per_s >= 20),
  row('pictures drawn beside the ultrasound panel', probing.pictures_per_s, '1/s', null, true),
  row('load of the machine, mean of a minute', loadavg()[0], 'processes', null, true),
  most('time to decode a depth image with its statistics, p50', quantile(meshed.decodes_ms, 0.5), 'ms', 12),
  most('longest block of the main thread', Math.max(0, ...meshed.longTasks), 'ms', 50),
  most('size of the page, compressed', weight() / 1000, 'kB', 250),
  most('time until the first picture, in a browser that has just been launched', meshed.first_ms, 'ms', 1000),
  most('time until the first picture, in a new browser that has run for 5 s, median', quantile(first.new_ms, 0.5), 'ms', 1000),
  most('time until the first picture, when the page is opened again, median', quantile(first.again_ms, 0.5), 'ms', 1000),
  row('pictures drawn with a quarter of the pixels', small.pictures_per_s, '1/s', null, true),
  most('time from capture to drawn picture, p50, a quarter of the pixels', quantile(small.ages_ms, 0.5), 'ms', 60),
  most('time from capture to drawn picture, p50', quantile(meshed.ages_ms, 0.5), 'ms', 60),
  most('time from capture to drawn picture, longest', Math.max(...meshed.ages_ms), 'ms', 250),
  most('checks that find the hand of another instant than the picture',
       meshed.looks === 0 ? NaN : meshed.handApart, '', 0),
  most('checks that find numbers of another instant than the picture',
       meshed.looks === 0 ? NaN : meshed.numbersApart, '', 0),
  row('share of checks that find a picture without numbers',
      meshed.unknown / meshed.looks, '', 0.01, meshed.unknown <= 0.01 * meshed.looks),
  row('number of checks, one every 4 ms', meshed.looks, '', null, true),
];
if (asJson) console.log(JSON.stringify({bench: 'viewer', seconds, size: SIZE, rows}, null, 1));
else for (const {name, value, unit, reach, holds} of rows)
  console.log(`${holds ? 'holds' : 'FAILS'}  ${name}: ${value} ${unit}${reach === null ? '' : ` (budget ${reach})`}`);
process.exit(rows.every(({holds}) => holds) ? 0 : 1);
