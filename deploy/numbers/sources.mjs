// The C++ sources of a checkout, and of a commit of it.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

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

/** The commit with which the sources are compared unless another one is named; undefined: there is none. */
export const defaultBase = (checkout) =>
  execFileSync(fileURLToPath(new URL('../base', import.meta.url)), [checkout], {encoding: 'utf8'}).trim() || undefined;

/** The full name of a commit; undefined: this checkout does not have it. */
export function commitOf(checkout, name) {
  try {
    return git(checkout, 'rev-parse', '--verify', '--quiet', `${name}^{commit}`);
  } catch {
    return undefined;
  }
}
