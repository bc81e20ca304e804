// What processes take of the memory, from /proc.
import {readdirSync, readFileSync} from 'node:fs';

const read = (pid, file) => readFileSync(`/proc/${pid}/${file}`, 'utf8');

/** Resident memory of a process [MB]. Throws if the process is gone. */
export function resident_MB(pid) {
  const found = /^VmRSS:\s+(\d+) kB$/m.exec(read(pid, 'status'));
  if (found === null) throw new Error(`process ${pid} has ended`);
  return Number(found[1]) * 1.024e-3;
}

/** The processes that `pid` started, and those that they started. */
export function descendants(pid) {
  const children = new Map();
  for (const name of readdirSync('/proc').filter((entry) => /^\d+$/.test(entry))) {
    try {
      const parent = Number(/^PPid:\s+(\d+)$/m.exec(read(name, 'status'))[1]);
      children.set(parent, [...(children.get(parent) ?? []), Number(name)]);
    } catch {
      // the process ended meanwhile
    }
  }
  const below = (at) => (children.get(at) ?? []).flatMap((child) => [child, ...below(child)]);
  return below(pid);
}

/** Of this program's Chromium: resident memory of all processes of one type, such as 'renderer' or 'gpu-process' [MB]. */
export function chromium_MB(type) {
  return descendants(process.pid).reduce((sum, pid) => {
    try {
      return read(pid, 'cmdline').split(/[\0 ]/).includes(`--type=${type}`) ? sum + resident_MB(pid) : sum;
    } catch {
      return sum;
    }
  }, 0);
}
