// What a minimal Debian must fetch to install telepalp-clients.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';

import {atMost} from './rows.mjs';

const BANNED = /^lib(pcl|openni2)/;

/** One paragraph of dpkg's status as {Package: …, Depends: …}; continued lines are left out. */
export const fieldsOf = (paragraph) => Object.fromEntries(
  [...paragraph.matchAll(/^([A-Za-z-]+): (.*)$/gm)].map(([, name, value]) => [name, value]));

export const namesIn = (depends = '') => depends.split(/[,|]/).map((one) => one.trim().split(/[ :(]/)[0]).filter((name) => name !== '');

/**
 * The paragraphs of dpkg's `status` that a minimal Debian has, too: essential and required packages, apt, and what these
 * depend on.
 */
export function minimalStatus(status) {
  const packages = new Map(status.split(/\n\n+/).filter((text) => text.trim() !== '').map((text) => [fieldsOf(text).Package, text]));
  const isMinimal = ({Package, Essential, Priority}) => Essential === 'yes' || Priority === 'required' || Package === 'apt';
  const open = [...packages.values()].map(fieldsOf).filter(isMinimal).map(({Package}) => Package);
  const kept = new Set();
  while (open.length > 0) {
    const name = open.pop();
    if (kept.has(name) || !packages.has(name)) continue;
    kept.add(name);
    const {Depends, 'Pre-Depends': before} = fieldsOf(packages.get(name));
    open.push(...namesIn(Depends), ...namesIn(before));
  }
  return [...kept].map((name) => `${packages.get(name).trimEnd()}\n`).join('\n');
}

/** Names and bytes of the archives in the output of `apt-get --print-uris`. */
export const archivesIn = (output) => [...output.matchAll(/^'[^']*' (\S+?)_\S* (\d+)(?: |$)/gm)].map(([, name, bytes]) => ({name, bytes: Number(bytes)}));

/**
 * What apt would fetch for the package files `files` on a computer with dpkg's `status`, with these files themselves. apt
 * prints it, and installs nothing.
 */
function toFetch(files, status) {
  const work = mkdtempSync(join(tmpdir(), 'size-'));
  try {
    writeFileSync(join(work, 'status'), status);
    const options = [`Dir::State::status=${join(work, 'status')}`, `Dir::Cache::archives=${work}`, 'Debug::NoLocking=true'];
    const words = ['install', '--print-uris', '-y', '--no-install-recommends', ...options.flatMap((option) => ['-o', option])];
    return archivesIn(execFileSync('apt-get', [...words, ...files], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']}));
  } finally {
    rmSync(work, {recursive: true, force: true});
  }
}

/** The package files in `folder` that telepalp-clients consists of; undefined: it has not been built. */
function packagesIn(folder) {
  const names = readdirSync(folder, {withFileTypes: true}).map(({name}) => name);
  const found = ['telepalp-clients', 'telepalp-data'].map((name) => names.find((file) => file.startsWith(`${name}_`) && file.endsWith('.deb')));
  return found.includes(undefined) ? undefined : found.map((file) => resolve(folder, file));
}

/** The rows of the packages in `folder`; a note instead, if they or apt are not there. */
export function packageRows(folder, notes) {
  let files;
  try {
    files = packagesIn(folder);
  } catch {
    // no such folder
  }
  if (files === undefined) {
    notes.push(`skipped: ${folder} has no package telepalp-clients. fix: run deploy/package, or give --packages DIR`);
    return [];
  }
  try {
    const fetched = toFetch(files, minimalStatus(readFileSync('/var/lib/dpkg/status', 'utf8')));
    if (!fetched.some(({name}) => name === 'telepalp-clients')) throw new Error('its list lacks telepalp-clients');
    const bytes = fetched.reduce((sum, archive) => sum + archive.bytes, 0);
    const banned = fetched.filter(({name}) => BANNED.test(name)).map(({name}) => name);
    if (banned.length > 0) notes.push(`telepalp-clients needs ${banned.join(', ')}`);
    return [
      atMost('packages libpcl*, libopenni2* that telepalp-clients needs', banned.length, 'packages', 0),
      atMost('telepalp-clients to fetch on a minimal Debian', Math.round(bytes / 1e5) / 10, 'MB', 40),
    ];
  } catch (problem) {
    notes.push(`skipped: apt cannot tell what telepalp-clients needs: ${String(problem.stderr ?? problem).trim().split('\n')[0]}`);
    return [];
  }
}
