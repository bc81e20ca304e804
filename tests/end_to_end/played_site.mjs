// A recorded session that the real server plays, and what of the page its cards leave to the patient.
import {execFile} from 'node:child_process';
import {copyFileSync, mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {promisify} from 'node:util';

/**
 * Records `seconds` of the synthetic patient and a palpating station, and plays them on a server that can compare them
 * with a second session, `other.mcap`. Resolves with the page's address.
 */
export async function playRecording(place, binDir, viewer, seconds) {
  const program = (name) => join(binDir, name);
  const folder = join(place.folder, 'sessions');
  mkdirSync(folder);
  const file = join(folder, 'session.mcap');
  const live = await place.server(program('telepalp-server'), ['--viewer', viewer]);
  const station = place.start(program('telepalp-station'), ['--connect', `127.0.0.1:${live.port}`]);
  await promisify(execFile)(program('telepalp-record'),
      ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', String(seconds)]);
  station.kill('SIGTERM');
  live.child.kill('SIGTERM');
  copyFileSync(file, join(folder, 'other.mcap'));
  const played = await place.server(program('telepalp-server'),
      ['--viewer', viewer, '--source', `session:${file}`, '--compare-dir', folder]);
  return `http://127.0.0.1:${played.http_port}/`;
}

/**
 * The share of the page that no card, bar, badge or banner covers, and the share of the largest rectangle without any
 * of them. Measured on a grid of 4 px.
 */
export const patientShares = (page) => page.evaluate(() => {
  const STEP_PX = 4;
  const [columns, rows] = [Math.floor(innerWidth / STEP_PX), Math.floor(innerHeight / STEP_PX)];
  const covers = [...document.querySelectorAll('.card, .badge, .banner, .hand-notice')]
      .map((part) => part.getBoundingClientRect()).filter(({width, height}) => width > 0 && height > 0);
  const heights = new Array(columns).fill(0);  // of the free column that ends in this row
  let [free, largest] = [0, 0];
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const [x, y] = [(column + 0.5) * STEP_PX, (row + 0.5) * STEP_PX];
      const covered = covers.some(({left, right, top, bottom}) => x > left && x < right && y > top && y < bottom);
      heights[column] = covered ? 0 : heights[column] + 1;
      if (!covered) ++free;
    }
    for (let from = 0; from < columns; ++from)
      for (let to = from, lowest = Infinity; to < columns; ++to) {
        lowest = Math.min(lowest, heights[to]);
        if (lowest * (columns - from) <= largest) break;
        largest = Math.max(largest, lowest * (to - from + 1));
      }
  }
  return {uncovered: free / (columns * rows), rectangle: largest / (columns * rows)};
});
