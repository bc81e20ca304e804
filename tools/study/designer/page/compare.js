// Linkages that are kept beside each other, and the page's address, which holds them and the present one: a page that
// is loaded again, or opened from a copied address, shows the same.
import {listed, PARAMETERS, shown, unlisted} from './parameters.js';

const MOST = 8;

/** What the address says: {values?, kept}. A kept linkage is {name, values, prediction?}. */
export function fromAddress(hash) {
  const said = new URLSearchParams(hash.replace(/^#/, ''));
  const kept = [];
  for (const row of said.getAll('k').slice(0, MOST)) {
    const [name, numbers, predicted] = row.split('~');
    const values = unlisted(numbers);
    if (!values) continue;
    const [mean, low, high, hand] = (predicted ?? '').split(',').map(Number);
    const prediction = [mean, low, high, hand].every(Number.isFinite) && predicted ? {overshoot: [mean, low, high], hand: [hand]} : undefined;
    kept.push({name: name.slice(0, 12), values, prediction});
  }
  return {values: unlisted(said.get('d')), kept};
}

export function toAddress(values, kept) {
  const said = new URLSearchParams();
  said.set('d', listed(values));
  for (const {name, values: numbers, prediction} of kept) {
    const predicted = prediction ? [...prediction.overshoot, prediction.hand[0]].map((value) => value.toFixed(2)).join(',') : '';
    said.append('k', [name, listed(numbers), predicted].join('~'));
  }
  return `#${said}`;
}

/** The least letter that no kept linkage has. */
const nextName = (kept) => [...'ABCDEFGH'].find((letter) => kept.every(({name}) => name !== letter)) ?? '?';

export class Comparison {
  /** `load(values)`: show this linkage. `changed()`: another one is kept. */
  constructor(kept, load, changed) {
    this.kept = kept;
    this.load = load;
    this.changed = changed;
    const cells = ['', 'overshoot', 'hand', ...PARAMETERS.map((parameter) => parameter.shown), ''];
    const row = document.createElement('tr');
    for (const text of cells) {
      const cell = document.createElement(text === '' ? 'td' : 'th');
      if (text !== '') cell.scope = 'col';
      cell.textContent = text;
      row.append(cell);
    }
    document.getElementById('compare-head').append(row);
    this.show();
  }

  keep(values, prediction) {
    if (this.kept.length >= MOST) this.kept.shift();
    this.kept.push({name: nextName(this.kept), values: {...values}, prediction});
    this.changed();
    this.show();
  }

  show() {
    document.getElementById('compare-empty').hidden = this.kept.length > 0;
    document.getElementById('compare-scroll').hidden = this.kept.length === 0;
    const best = (of) => Math.min(...this.kept.map(({prediction}) => (prediction ? of(prediction) : Infinity)));
    const [least, lightest] = [best(({overshoot}) => overshoot[0]), best(({hand}) => hand[0])];
    document.getElementById('compare-body').replaceChildren(...this.kept.map((one) => this.row(one, least, lightest)));
  }

  row(one, least, lightest) {
    const row = document.createElement('tr');
    const name = document.createElement('th');
    name.scope = 'row';
    const load = document.createElement('button');
    load.type = 'button';
    load.textContent = one.name;
    load.setAttribute('aria-label', `Load linkage ${one.name}`);
    load.addEventListener('click', () => this.load(one.values));
    name.append(load);
    const {prediction} = one;
    const cells = [[prediction ? `${prediction.overshoot[0].toFixed(1)} mm` : '–', prediction?.overshoot[0] === least],
                   [prediction ? `${prediction.hand[0].toFixed(2)} N` : '–', prediction?.hand[0] === lightest],
                   ...PARAMETERS.map((parameter) => [shown(parameter, one.values[parameter.name]), false])];
    row.append(name, ...cells.map(([text, isBest]) => {
      const cell = document.createElement('td');
      cell.textContent = text;
      if (isBest && this.kept.length > 1) cell.className = 'best';
      return cell;
    }));
    const last = document.createElement('td');
    const drop = document.createElement('button');
    drop.type = 'button';
    drop.textContent = 'Drop';
    drop.setAttribute('aria-label', `Drop linkage ${one.name}`);
    drop.addEventListener('click', () => {
      this.kept = this.kept.filter((other) => other !== one);
      this.changed();
      this.show();
    });
    last.append(drop);
    row.append(last);
    return row;
  }
}
