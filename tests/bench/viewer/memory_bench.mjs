// Does memory grow while a doctor watches? node tests/bench/viewer/memory_bench.mjs BIN_DIR VIEWER_FILES [--json]
// [--seconds 3600] [--every 30] [--log FILE]. Server, station and Chromium without a graphics card run side by side. Each
// reading follows a forced garbage collection and is a line of FILE (JSON). The first twelfth of the time is left out: the
// plots fill and the browser compiles. Prints rows {name, value, unit, reach, holds} like telepalp-bench: by how much the
// median of the last sixth of the time differs from that of the first sixth after that twelfth.
import {appendFileSync, writeFileSync} from 'node:fs';
import {loadavg} from 'node:os';
import {join} from 'node:path';

import {openBrowser, status, untilStatus} from '../../end_to_end/browser.mjs';
import {sleep, Workplace} from '../../end_to_end/running_program.mjs';
import {heapReader} from './heap_reader.mjs';
import {chromium_MB, resident_MB} from './process_memory.mjs';

const [binDir, viewer, ...options] = process.argv.slice(2);
if (viewer === undefined) {
  console.error('error: memory_bench: the folders of the programs and of the viewer are not given. fix: run ' +
      'node tests/bench/viewer/memory_bench.mjs build/release/bin build/release/viewer');
  process.exit(2);
}
const option = (name) => (options.includes(name) ? options[options.indexOf(name) + 1] : undefined);
const seconds = Number(option('--seconds') ?? 3600);
const every_s = Number(option('--every') ?? 30);
const log = option('--log');
const FLAT_PERCENT = 5;
const PATIENCE_MS = 600_000;  // at the lowest priority on a busy machine, the programs need minutes to start
const KINDS = {
  heap_MB: 'script heap of the page', workers_MB: 'script heap of the page\'s workers',
  renderers_MB: 'memory of the page\'s processes', graphics_MB: 'memory of the graphics process',
  server_MB: 'memory of the server', station_MB: 'memory of the station',
};

/** Reads the memory each `every_s` for `seconds`, and ends all programs. */
async function measure() {
  const place = new Workplace('memory_bench');
  let browser;
  try {
    const {child: server, port, http_port} =
        await place.server(join(binDir, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer]);
    const station = place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`]);
    browser = await openBrowser(place.folder, {width: 900, height: 640});
    const {page} = browser;
    await page.goto(`http://127.0.0.1:${http_port}/?view=doctor`);
    await untilStatus(page, 'a picture with a hand', (now) => {
      if (station.exitCode !== null) throw new Error(`the station ended: ${station.heard}`);
      return now.frames > 3 && now.handPosition_m !== undefined;
    }, PATIENCE_MS);
    const readHeap = await heapReader(page);
    const readings = [];
    const began_ms = performance.now();
    for (let due_s = every_s; due_s <= seconds; due_s += every_s) {
      await sleep(Math.max(0, began_ms + 1000 * due_s - performance.now()));
      const heap = await readHeap();
      const {frames, phase} = await status(page);
      readings.push({
        at_s: (performance.now() - began_ms) / 1000, heap_MB: heap.page_MB, workers_MB: heap.workers_MB,
        renderers_MB: chromium_MB('renderer'), graphics_MB: chromium_MB('gpu-process'), server_MB: resident_MB(server.pid),
        station_MB: resident_MB(station.pid), frames, phase, load: loadavg()[0],
      });
      if (log !== undefined) appendFileSync(log, `${JSON.stringify(readings.at(-1))}\n`);
    }
    return readings;
  } finally {
    await browser?.context.close();
    await place.end();
  }
}

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];
const between = (readings, from, to) => readings.filter(({at_s}) => at_s >= from * seconds && at_s < to * seconds);

function rowsOf(readings) {
  const early = between(readings, 1 / 12, 3 / 12);
  const late = between(readings, 10 / 12, Infinity);
  const row = (name, value, unit, reach, holds) => ({name, value: Number(value.toFixed(2)), unit, reach, holds});
  const rows = Object.entries(KINDS).flatMap(([kind, name]) => {
    const [before_MB, after_MB] = [early, late].map((part) => median(part.map((reading) => reading[kind])));
    const grown_percent = 100 * (after_MB / before_MB - 1);
    return [
      row(name, after_MB, 'MB', null, true),
      row(`${name}, growth during the run`, grown_percent, '%', FLAT_PERCENT, Math.abs(grown_percent) <= FLAT_PERCENT),
    ];
  });
  const still = readings.filter(({frames}, at) => at > 0 && frames === readings[at - 1].frames).length;
  return [
    ...rows,
    row('pictures drawn', readings.at(-1).frames, '', null, true),
    row('readings without a new picture', still, '', 0, still === 0),
    row('load of the machine, mean', mean(readings.map(({load}) => load)), 'processes', null, true),
  ];
}

if (!(every_s >= 1 && seconds >= 24 * every_s)) {
  console.error('error: memory_bench: too few readings to compare. fix: give --seconds at least 24 times --every, and --every at least 1');
  process.exit(2);
}
if (log !== undefined) writeFileSync(log, '');
const rows = rowsOf(await measure());
if (options.includes('--json')) console.log(JSON.stringify({bench: 'viewer memory', seconds, every_s, rows}, null, 1));
else for (const {name, value, unit, reach, holds} of rows)
  console.log(`${holds ? 'holds' : 'FAILS'}  ${name}: ${value} ${unit}${reach === null ? '' : ` (budget ${reach})`}`);
process.exit(rows.every(({holds}) => holds) ? 0 : 1);
