// Rows in the format of `telepalp-bench NAME --json`.
import {readFileSync} from 'node:fs';
import {cpus} from 'node:os';

export const atMost = (name, value, unit, reach) => ({name, value, unit, reach, holds: value <= reach});
export const atLeast = (name, value, unit, reach) => ({name, value, unit, reach, holds: value >= reach, least: true});
export const measured = (name, value, unit) => ({name, value, unit, reach: null, holds: true});

/** Processor and number of cores, as the benches name them. */
export function machineName() {
  const model = /^model name\s*:\s*(.*)$/m.exec(readFileSync('/proc/cpuinfo', 'utf8'))?.[1];
  return model === undefined ? 'unknown' : `${model}, ${cpus().length} cores`;
}

export const toJson = ({bench, commit, machine, rows}) =>
  `${JSON.stringify({bench, commit, machine}).slice(0, -1)},"rows":[\n  ${rows.map(({least, ...row}) => JSON.stringify(row)).join(',\n  ')}\n]}\n`;

export function toTable({bench, commit, machine, rows}) {
  const wide = Math.max(20, ...rows.map(({name}) => name.length));
  const lines = rows.map(({name, value, unit, reach, holds, least}) =>
    `  ${name.padEnd(wide)} ${String(value).padStart(9)} ${unit.padEnd(9)}` +
    (reach === null ? '' : ` ${least ? '>=' : '<='} ${String(reach).padEnd(8)} ${holds ? 'holds' : 'MISSES'}`));
  return `${bench}  (${machine}, commit ${commit})\n${lines.join('\n')}\n`;
}
