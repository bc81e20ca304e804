import {execFileSync, spawn, spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {availableParallelism, cpus, tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {machineName, toJson, toTable} from './rows.mjs';
import {commitOf, git} from './sources.mjs';
import {column, disturbance, quantile, ratioRows} from './tick_rows.mjs';

const HELP = `deploy/tick-ratio: compares the computing time of a tick with that of
another commit

usage: deploy/tick-ratio --base COMMIT [options]
Both stations run in turn against the same server with a synthetic patient; the
station's ticks are recorded. The first 2 s of each run are left out. Exits with
1 if the ratio misses its budget, and with 2 if it was asked wrongly.

options:
  --base COMMIT    compare with this commit; its station is built once, in
                   build/tick-ratio
  --base-bin DIR   compare with the telepalp-station of this folder instead
  --pairs N        runs of each station [10]
  --seconds S      length of a run [12]
  --scene SCENE    what is felt, a scene that both stations know [palpation]
  --json           print the rows as telepalp-bench NAME --json does
  -h, --help       print this

example: deploy/tick-ratio --base HEAD~20 --pairs 10`;

const REACH = 1.05;
const DISTURBED = 1.5;  // one unchanged program's p99.9, from run to run
const WARM_UP_S = 2;
const checkout = fileURLToPath(new URL('../..', import.meta.url));
const ownPrograms = process.env.TELEPALP_BIN ?? join(checkout, 'build/release/bin');
const WITH_VALUE = ['--base', '--base-bin', '--pairs', '--seconds', '--scene'];

function fail(status, what, fix) {
  process.stderr.write(`error: deploy/tick-ratio: ${what}. fix: ${fix}\n`);
  process.exit(status);
}

function optionsOf(words) {
  const given = {pairs: '10', seconds: '12', scene: 'palpation', json: false};
  for (let at = 0; at < words.length; ++at) {
    const word = words[at];
    if (word === '-h' || word === '--help') given.help = true;
    else if (word === '--json') given.json = true;
    else if (!WITH_VALUE.includes(word)) fail(2, `'${word}' is not an option`, 'see deploy/tick-ratio --help');
    else if (!words[at + 1]) fail(2, `${word} lacks its value`, 'see deploy/tick-ratio --help');
    else given[word.replace(/^--/, '')] = words[++at];
  }
  for (const name of ['pairs', 'seconds'])
    if (!(Number(given[name]) >= (name === 'pairs' ? 1 : WARM_UP_S + 1))) fail(2, `--${name} ${given[name]} is too small`, `give --${name} ${name === 'pairs' ? 1 : WARM_UP_S + 1} or more`);
  if (!given.help && !given.base && !given['base-bin']) fail(2, '--base is missing', 'name the commit to compare with');
  return given;
}

/** Runs a program to its end; its output goes to `log`. */
function run(log, program, ...words) {
  const {status} = spawnSync('bash', ['-c', 'exec "${@:2}" >>"$1" 2>&1', 'bash', log, program, ...words]);
  if (status !== 0) throw new Error(`${program} failed: ${readFileSync(log, 'utf8').trim().split('\n').slice(-4).join(' | ')}`);
}

/** The folder with the station of `commit`, built as users build it, if it is not built yet. */
function programsOf(commit) {
  const tree = join(checkout, 'build/tick-ratio', commit.slice(0, 12));
  const build = join(tree, 'build/release');
  if (!existsSync(join(build, 'bin/telepalp-station'))) {
    process.stderr.write(`deploy/tick-ratio: building the station of ${commit.slice(0, 8)} in ${tree}\n`);
    mkdirSync(tree, {recursive: true});
    execFileSync('sh', ['-c', 'git -C "$1" archive "$2" | tar x -C "$3"', 'sh', checkout, commit, tree]);
    const log = join(tree, 'build.log');
    run(log, 'cmake', '-S', tree, '-B', build, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release', '-DTELEPALP_NPM=OFF');
    const jobs = typeof availableParallelism === 'function' ? availableParallelism() : cpus().length;
    run(log, 'cmake', '--build', build, '--target', 'telepalp-station', '--parallel', String(jobs));
  }
  return join(build, 'bin');
}

const sleep = (ms) => new Promise((wake) => setTimeout(wake, ms));
const over = (child) => new Promise((done) => child.exitCode === null ? child.once('exit', done) : done());

async function portOf(ready, server) {
  for (let waited_ms = 0; waited_ms < 30_000; waited_ms += 50) {
    if (existsSync(ready)) return /^port=(\d+)$/m.exec(readFileSync(ready, 'utf8'))[1];
    if (server.exitCode !== null) break;
    await sleep(50);
  }
  throw new Error('the server does not listen');
}

/** Computing times of the ticks of one station [us]. */
async function ticksOf(station, {seconds, scene}, folder) {
  const ready = join(folder, 'ready');
  const session = join(folder, 'session.mcap');
  const quiet = {stdio: 'ignore'};
  rmSync(ready, {force: true});
  const server = spawn(join(ownPrograms, 'telepalp-server'), ['--source', 'synthetic', '--port', '0', '--ready-file', ready], quiet);
  try {
    const at = `127.0.0.1:${await portOf(ready, server)}`;
    const recorder = spawn(join(ownPrograms, 'telepalp-record'), ['--connect', at, '--out', session, '--topics', '/station/ticks'], quiet);
    const log = join(folder, 'station.log');
    try {
      run(log, station, '--connect', at, '--scene', scene, '--seconds', seconds, '--control', 'none', '--state-dir', folder);
    } finally {
      recorder.kill('SIGINT');
      await over(recorder);
    }
    const csv = execFileSync(join(ownPrograms, 'telepalp-export'), [session, '--csv', '/station/ticks'], {encoding: 'utf8', maxBuffer: 1 << 30});
    const work_us = column(csv, 'work_us').slice(WARM_UP_S * 2000);
    if (work_us.length < 1000) throw new Error(`only ${work_us.length} ticks were recorded: ${readFileSync(log, 'utf8').trim().split('\n').pop()}`);
    return {p50: quantile(work_us, 0.5), p999: quantile(work_us, 0.999)};
  } finally {
    server.kill('SIGINT');
    await over(server);
    rmSync(session, {force: true});
  }
}

async function pairsOf(options, base) {
  const folder = mkdtempSync(join(tmpdir(), 'tick-ratio-'));
  const stations = {base: join(base, 'telepalp-station'), head: join(ownPrograms, 'telepalp-station')};
  const pairs = [];
  try {
    for (let pair = 0; pair < Number(options.pairs); ++pair) {
      const times = {};
      for (const which of pair % 2 === 0 ? ['base', 'head'] : ['head', 'base']) times[which] = await ticksOf(stations[which], options, folder);
      pairs.push(times);
      process.stderr.write(`  pair ${pair + 1}: base p50 ${times.base.p50.toFixed(2)} p99.9 ${times.base.p999.toFixed(1)} us, this p50 ${times.head.p50.toFixed(2)} p99.9 ${times.head.p999.toFixed(1)} us\n`);
    }
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
  return pairs;
}

const options = optionsOf(process.argv.slice(2));
if (options.help) {
  console.log(HELP);
  process.exit(0);
}
const commit = options.base && commitOf(checkout, options.base);
if (options.base && !commit) fail(2, `there is no commit ${options.base} in ${checkout}`, 'name another commit, or fetch it');
try {
  const base = options['base-bin'] ? resolve(options['base-bin']) : programsOf(commit);
  const pairs = await pairsOf(options, base);
  const rows = ratioRows(pairs, REACH);
  if (disturbance(pairs) > DISTURBED) process.stderr.write('  the runs of the base differ much: other programs disturb them. fix: repeat it on a machine that does nothing else\n');
  const report = {bench: 'tick-ratio', commit: git(checkout, 'rev-parse', '--short=8', 'HEAD'), machine: machineName(), rows};
  process.stdout.write(options.json ? toJson(report) : toTable(report));
  process.exitCode = rows.every(({holds}) => holds) ? 0 : 1;
} catch (problem) {
  fail(1, problem.message.split('\n')[0], 'build this checkout (deploy/build), and see the message');
}
