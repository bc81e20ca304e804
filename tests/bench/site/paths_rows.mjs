// Rows of telepalp-bench site, section paths: node paths_rows.mjs PROGRAMS
// The ways of datagrams between two sites behind routers of seven kinds, with the real programs and a real relay.
import {spawnSync} from 'node:child_process';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const programs = process.argv[2];
const here = dirname(fileURLToPath(import.meta.url));
const PAIRS = 49;

const row = (...cells) => console.log(cells.join('\t'));
const seconds = (text) => (text === '-' ? Infinity : Number(text));
const p95 = (values) => values.slice().sort((a, b) => a - b)[Math.min(values.length - 1, Math.ceil(0.95 * values.length) - 1)];

const run = spawnSync('bash', [join(here, 'paths_runs.sh'), join(here, '../../..'), programs], {encoding: 'utf8', maxBuffer: 1 << 24});
process.stderr.write(run.stderr);
if (run.status === 77) {
  process.stderr.write(run.stdout);
  row('paths: pairs that were tried', 0, '', 'at_least', PAIRS);
  process.exit(0);
}
const lines = run.stdout.split('\n').map((line) => line.split('\t'));
const pairs = lines.filter(([kind]) => kind === 'pair').map(([, patient, doctor, best, joined, first, reached]) =>
  ({patient, doctor, best, joined: seconds(joined), first: seconds(first), reached: seconds(reached)}));
for (const {patient, doctor, best, first, reached} of pairs)
  if (!(first <= 3 && reached <= 15)) process.stderr.write(`patient ${patient}, doctor ${doctor}: image after ${first} s, ${best} after ${reached} s\n`);

const came = pairs.filter(({joined, first}) => Number.isFinite(joined) && Number.isFinite(first));
row(`paths: joined, and a depth image came, of ${PAIRS} pairs`, came.length, '', 'at_least', PAIRS);
row('paths: first depth image by any path, p95', p95(pairs.map(({first}) => first)), 's', 'at_most', 3);
row(`paths: on the best path that the pair allows, of ${PAIRS}`, pairs.filter(({reached}) => reached <= 15).length, '', 'at_least', PAIRS);
row('paths: until the best path, the slowest pair', Math.max(...pairs.map(({reached}) => reached)), 's', 'at_most', 15);
for (const way of ['directly', 'over a relay (UDP)', 'over a relay (TCP)'])
  row(`paths: until the way ${way}, p95`, p95(pairs.filter(({best}) => best === way).map(({reached}) => reached)), 's', 'none', 0);
const changes = lines.filter(([kind]) => kind === 'change').map(([, what, gap]) => ({what, gap: seconds(gap)}));
for (const what of [...new Set(changes.map((one) => one.what))])
  row(`paths: ${what}: longest gap of the images`, Math.max(...changes.filter((one) => one.what === what).map(({gap}) => gap)), 's', 'none', 0);
row('paths: the network changes: gap of the images, p95', p95(changes.map(({gap}) => gap)), 's', 'at_most', 2);
