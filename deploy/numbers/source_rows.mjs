// The figures that the sources alone give.
import {functionsIn, membersOf} from './cpp_blocks.mjs';
import {codeLines, codeOf} from './cpp_text.mjs';
import {atLeast, atMost, measured} from './rows.mjs';

const MOST_LINES = 60;
const MOST_MEMBERS = {Station: 15, ClientLink: 20, SessionPlayer: 20, Connection: 20, HapticLoop: 20};

const linesOf = (product) => [...product.values()].reduce((sum, text) => sum + codeLines(text), 0);
const isBelow = (file, path) => file === path || file.startsWith(`${path.replace(/\/$/, '')}/`);
const only = (product, keeps) => new Map([...product].filter(([file]) => keeps(file)));

/**
 * Lines that went since `before`, less those that came. `apart`: files and folders whose lines are counted in a row of
 * their own.
 */
export function removedLines(before, product, apart) {
  const isApart = (file) => apart.some((path) => isBelow(file, path));
  const change = (keeps) => linesOf(only(before, keeps)) - linesOf(only(product, keeps));
  const rows = [atLeast('C++ lines outside tests/ removed since the base, less those added', change((file) => !isApart(file)), 'lines', 3000)];
  if (apart.length > 0) rows.push(measured(`lines added apart: ${apart.join(', ')}`, -change(isApart), 'lines'));
  return rows;
}

/** The sequence sample, tick, apply: the haptic loop's input, its tick, and its force handed to a device. */
const drivesTheTick = (text) => /\bTickIn\b[\s\S]*\.\s*tick\s*\([\s\S]*\b(apply|step)\s*\([^;]*\bforce\b/.test(codeOf(text));

function counted(name, files, unit, reach, notes) {
  if (files.length > 0) notes.push(`${name}: ${files.join(', ')}`);
  return atMost(name, files.length, unit, reach);
}

/** A class that is gone or renamed has no figure, and its row does not hold, so that the list above is kept. */
function memberRows(product, notes) {
  return Object.entries(MOST_MEMBERS).map(([name, reach]) => {
    const found = [...product.values()].map((text) => membersOf(text, name)).filter((members) => members !== undefined);
    if (found.length === 0) notes.push(`there is no class ${name}. fix: correct MOST_MEMBERS in deploy/numbers/source_rows.mjs`);
    const most = found.length === 0 ? NaN : Math.max(...found.map(({length}) => length));
    return atMost(`members of ${name}`, most, 'members', reach);
  });
}

function longFunctions(product) {
  return [...product].flatMap(([file, text]) => functionsIn(text).filter(({lines}) => lines > MOST_LINES)
    .map(({name, line, lines}) => `${file}:${line} ${name} (${lines})`));
}

/** `notes` gets the places that a row counts. */
export function rowsOf(product, notes) {
  return [
    counted("copies of the tick's sequence", [...product].filter(([, text]) => drivesTheTick(text)).map(([file]) => file), 'files', 1, notes),
    ...memberRows(product, notes),
    counted(`functions over ${MOST_LINES} lines`, longFunctions(product), 'functions', 0, notes),
  ];
}
