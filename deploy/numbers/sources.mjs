// The C++ sources of a checkout, and of a commit of it.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

export const git = (checkout, ...words) => execFileSync('git', ['-C', checkout, ...words], {encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe']}).trim();

const isCpp = (file) => /\.(h|cpp)$/.test(file);
const isProduct = (file) => !file.startsWith('tests/');

/** Calls `use` with a folder that holds the files of `commit`, and removes it. */
export async function withTree(checkout, commit, use) {
  const folder = mkdtempSync(join(tmpdir(), 'size-'));
  try {
    execFileSync('sh', ['-c', 'git -C "$1" archive "$2" | tar x -C "$3"', 'sh', checkout, commit, folder]);
    return await use(folder);
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
}

/** Path to text of each C++ file outside tests/, as it is in the working tree: files that git ignores are left out. */
export function productOf(checkout) {
  const files = git(checkout, 'ls-files', '--cached', '--others', '--exclude-standard', '-z').split('\0');
  return readAll(checkout, files);
}

/** The same of a commit. */
export const productAt = (checkout, commit) => withTree(checkout, commit, (folder) =>
  readAll(folder, git(checkout, 'ls-tree', '-r', '-z', '--name-only', commit).split('\0')));

function readAll(folder, files) {
  const texts = new Map();
  for (const file of files.filter((name) => isCpp(name) && isProduct(name)).sort()) {
    try {
      texts.set(file, readFileSync(join(folder, file), 'utf8'));
    } catch {
      // deleted in the working tree, but not in the index
    }
  }
  return texts;
}

/**
 * The commit with which the sources are compared unless another one is named: what a branch changes begins where it left
 * the main branch; on the main branch itself, with the last commit. undefined: there is no such commit, as in a shallow
 * clone.
 */
export function defaultBase(checkout) {
  const head = commitOf(checkout, 'HEAD');
  for (const main of ['origin/HEAD', 'origin/main', 'main']) {
    if (commitOf(checkout, main) === undefined) continue;
    const common = attempt(() => git(checkout, 'merge-base', 'HEAD', main));
    if (common !== undefined && common !== head) return common;
  }
  return commitOf(checkout, 'HEAD~1');
}

/** The full name of a commit; undefined: this checkout does not have it. */
export const commitOf = (checkout, name) => attempt(() => git(checkout, 'rev-parse', '--verify', '--quiet', `${name}^{commit}`));

function attempt(call) {
  try {
    return call();
  } catch {
    return undefined;
  }
}
