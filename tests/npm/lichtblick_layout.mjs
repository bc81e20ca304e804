// The layout that ships for Lichtblick and Foxglove, and what it needs of a server or of a file.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';

export const layout = JSON.parse(readFileSync(new URL('../../docs/lichtblick.layout.json', import.meta.url), 'utf8'));

/** Every topic, with the field behind it if there is one, that the layout names: "/station/state.force_N.x". */
export function pathsOfLayout() {
  const found = [];
  const look = (value) => {
    if (typeof value === 'string' && value.startsWith('/')) found.push(value);
    else if (value !== null && typeof value === 'object') {
      for (const [key, inner] of Object.entries(value)) {
        if (key.startsWith('/')) found.push(key);
        look(inner);
      }
    }
  };
  look(layout.configById);
  return found;
}

/** The type of the last field of `path`, a list of names; fails unless it leads to a field of `type`'s messages. */
export function fieldOf(type, path) {
  let at = type;
  for (const name of path) {
    const field = at.fields[name];
    assert.ok(field, `${type.name} has no ${path.join('.')}`);
    at = field.resolve().resolvedType ?? field.type;
  }
  return at;
}
