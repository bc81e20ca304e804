// Processor time of whole builds: two commits in turn, twice, so that a machine that becomes slower is slower for both.
import {spawnSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {availableParallelism, cpus} from 'node:os';
import {join} from 'node:path';

import {atMost, measured} from './rows.mjs';
import {withTree} from './sources.mjs';

const ROUNDS = 2;
const jobs = () => (typeof availableParallelism === 'function' ? availableParallelism() : cpus().length);

/** User and system time of `cmake --build` of all targets, without ccache and npm [s]. The configuration is not counted. */
function build_s(tree) {
  const build = join(tree, 'build-measured');
  const log = join(tree, 'build-measured.log');
  const run = (script, ...words) => {
    const {status, stdout} = spawnSync('bash', ['-c', script, 'bash', log, ...words], {encoding: 'utf8'});
    if (status !== 0) throw new Error(`a build failed: ${readFileSync(log, 'utf8').trim().split('\n').slice(-5).join(' | ')}`);
    return stdout;
  };
  // OFF, not NOTFOUND: CMake would look for the program again, and find it.
  const settings = ['-DCMAKE_BUILD_TYPE=Release', '-DNPM=OFF', '-DTELEPALP_NPM=OFF', '-DCCACHE=OFF'];
  run('cmake -S "$2" -B "$3" -G Ninja "${@:4}" >"$1" 2>&1', tree, build, ...settings);
  const said = run('TIMEFORMAT="%U %S"; { time CCACHE_DISABLE=1 cmake --build "$2" --parallel "$3" >"$1" 2>&1; } 2>&1', build, String(jobs()));
  const [user_s, system_s] = said.trim().split(/\s+/).slice(-2).map(Number);
  return user_s + system_s;
}

/**
 * The row of the ratio, and one for each commit. `base` and `head`: full names of commits. Prints each build's time when
 * it is known, because a later build may fail after hours.
 */
export async function buildRows(checkout, base, head) {
  const sums = {[base]: 0, [head]: 0};
  for (let round = 1; round <= ROUNDS; ++round)
    for (const commit of [base, head]) {
      process.stderr.write(`deploy/size: building ${commit.slice(0, 8)}, round ${round} of ${ROUNDS}\n`);
      const spent_s = await withTree(checkout, commit, build_s);
      sums[commit] += spent_s;
      process.stderr.write(`deploy/size: ${commit.slice(0, 8)} took ${spent_s.toFixed(1)} s of processor time\n`);
    }
  return [
    atMost("processor time of a build, of the base's", Number((sums[head] / sums[base]).toFixed(3)), 'x', 0.6),
    measured('processor time of a build of the base', Number((sums[base] / ROUNDS).toFixed(1)), 's'),
    measured('processor time of a build', Number((sums[head] / ROUNDS).toFixed(1)), 's'),
  ];
}
