import {resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {buildRows} from './build_time.mjs';
import {lawRows} from './law_rows.mjs';
import {packageRows} from './packages.mjs';
import {machineName, toJson, toTable} from './rows.mjs';
import {removedLines, rowsOf} from './source_rows.mjs';
import {commitOf, defaultBase, git, productAt, productOf} from './sources.mjs';

const HELP = `deploy/size: counts the sources, each figure against its budget

usage: deploy/size [options]
Exits with 1 if a figure misses its budget, and with 2 if it was asked wrongly.

options:
  --base COMMIT    compare with this commit [where this branch left the main
                   branch; on the main branch: the commit before the last]
  --apart PATH     count lines of this file or folder in a row of its own;
                   may be given again
  --build          build base and HEAD in turn, twice, and compare their
                   processor time (hours on two cores); else it is skipped
  --packages DIR   folder of telepalp-clients_*.deb and telepalp-data_*.deb
                   [build]; without them, their rows are skipped
  --source DIR     the checkout that is counted [this one]
  --json           print the rows as telepalp-bench NAME --json does
  -h, --help       print this

example: deploy/size --base HEAD~20 --json`;

function fail(status, what, fix) {
  process.stderr.write(`error: deploy/size: ${what}. fix: ${fix}\n`);
  process.exit(status);
}

const WITH_VALUE = ['--base', '--apart', '--packages', '--source'];

function optionsOf(words) {
  const given = {apart: [], build: false, json: false};
  for (let at = 0; at < words.length; ++at) {
    const word = words[at];
    const name = word.replace(/^--/, '');
    if (word === '-h' || word === '--help') given.help = true;
    else if (word === '--build' || word === '--json') given[name] = true;
    else if (!WITH_VALUE.includes(word)) fail(2, `'${word}' is not an option`, 'see deploy/size --help');
    else if (!words[at + 1]) fail(2, `${word} lacks its value`, 'see deploy/size --help');
    else if (name === 'apart') given.apart.push(words[++at]);
    else if (name in given) fail(2, `${word} is given twice`, 'give it once');
    else given[name] = words[++at];
  }
  return given;
}

/** The full name of the base; undefined if none was named and there is none, as in a shallow clone. */
function baseOf(checkout, name) {
  const base = name === undefined ? defaultBase(checkout) : commitOf(checkout, name);
  if (name !== undefined && base === undefined) fail(2, `there is no commit ${name} in ${checkout}`, 'name another commit, or fetch it: git fetch --unshallow');
  return base;
}

async function rowsFor(checkout, {base: name, apart, build, packages}, notes) {
  const base = baseOf(checkout, name);
  const rows = [];
  if (!build) notes.push('skipped: the processor time of a build. fix: give --build, and hours');
  else if (base === undefined) notes.push('skipped: the processor time of a build, because there is no commit to compare with');
  else rows.push(...await buildRows(checkout, base, commitOf(checkout, 'HEAD')));
  const product = productOf(checkout);
  if (base === undefined) notes.push('skipped: the lines removed, because there is no commit to compare with. fix: give --base COMMIT');
  else {
    rows.push(...removedLines(await productAt(checkout, base), product, apart));
    notes.push(`compared with ${base.slice(0, 8)}: ${git(checkout, 'log', '-1', '--format=%s', base)}`);
  }
  rows.push(...lawRows(checkout, notes));
  rows.push(...rowsOf(product, notes));
  rows.push(...packageRows(resolve(checkout, packages ?? 'build'), notes));
  return rows;
}

const options = optionsOf(process.argv.slice(2));
if (options.help) {
  console.log(HELP);
  process.exit(0);
}
const checkout = resolve(options.source ?? fileURLToPath(new URL('../..', import.meta.url)));
if (commitOf(checkout, 'HEAD') === undefined) fail(2, `${checkout} is no checkout of git`, 'give --source DIR');
const modified = git(checkout, 'status', '--porcelain', '--untracked-files=no') === '' ? '' : '-modified';
const notes = [];
let rows;
try {
  rows = await rowsFor(checkout, options, notes);
} catch (problem) {
  fail(1, problem.message.split('\n')[0], 'see the message; deploy/size without --build builds nothing');
}
const report = {bench: 'size', commit: git(checkout, 'rev-parse', '--short=8', 'HEAD') + modified, machine: machineName(), rows};
process.stdout.write(options.json ? toJson(report) : toTable(report));
process.stderr.write(notes.map((note) => `  ${note}\n`).join(''));
process.exitCode = rows.every(({holds}) => holds) ? 0 : 1;
