// The eight parameters of a linkage: their values in mm and rad, as a list for telepalp-study has them, and as the page
// shows them, with angles in degrees.
const DEGREE = Math.PI / 180;

/** `unit`: what one shown unit is in mm or rad. */
export const PARAMETERS = [
  {name: 'l1', shown: 'l1', says: 'length of link 1, from pivot A to the needle', least: 20, most: 250, step: 1, unit: 1, sign: 'mm'},
  {name: 'l2', shown: 'l2', says: 'length of link 2, which carries the needle', least: 20, most: 300, step: 1, unit: 1, sign: 'mm'},
  {name: 'l3', shown: 'l3', says: 'length of link 3, which carries the handle', least: 20, most: 250, step: 1, unit: 1, sign: 'mm'},
  {name: 'l4', shown: 'l4', says: 'length of link 4, which is fixed', least: 20, most: 350, step: 1, unit: 1, sign: 'mm'},
  {name: 'theta', shown: 'θ', says: 'angle of the needle to link 2', least: -180, most: 180, step: 0.5, unit: DEGREE, sign: '°'},
  {name: 'phi', shown: 'φ', says: 'angle of the handle to link 3, clockwise', least: -180, most: 180, step: 0.5, unit: DEGREE, sign: '°'},
  {name: 'h', shown: 'h', says: 'where the handle begins on link 3, from pivot O', least: 0, most: 200, step: 1, unit: 1, sign: 'mm'},
  {name: 'l_h', shown: 'lₕ', says: 'length of the handle', least: 0, most: 300, step: 1, unit: 1, sign: 'mm'},
];

/** At most `digits` decimals, without zeros at the end. */
export const short = (value, digits = 2) => String(Number(value.toFixed(digits)));
export const shown = (parameter, value) => short(value / parameter.unit, 1);

/** S4's Table 1 (docs/sources.md). S4 does not give l4: here it is 0.875 l2, the middle of the study's range. */
export function presets() {
  const links = [[80, 150, 120, -0.31], [100, 100, 100, -0.17], [120, 150, 80, 0.31]];
  const angles = [['0', 0], ['π/2', Math.PI / 2], ['5π/6', 5 * Math.PI / 6]];
  const all = [];
  for (const [index, [l1, l2, l3, theta]] of links.entries())
    for (const [word, phi] of angles)
      for (const h of [0, 80])
        for (const l_h of [140, 180])
          all.push({name: `S4 linkage ${index + 1}, φ ${word}, h ${h}, lₕ ${l_h}`,
                    values: {l1, l2, l3, l4: 0.875 * l2, theta, phi, h, l_h}});
  return all;
}

/** `l1=80 l2=150 …`, as a list for telepalp-study. */
export const lineOf = (values) => PARAMETERS.map(({name}) => `${name}=${short(values[name], 5)}`).join(' ');
export const listed = (values) => PARAMETERS.map(({name}) => short(values[name], 5)).join(',');

/** The values in a list of numbers as listed() writes it; undefined: it is none. */
export function unlisted(text) {
  const numbers = (text ?? '').split(',').map(Number);
  if (numbers.length !== PARAMETERS.length || !numbers.every((number, at) => Number.isFinite(number) && text.split(',')[at] !== '')) return undefined;
  return Object.fromEntries(PARAMETERS.map(({name}, at) => [name, numbers[at]]));
}

export const same = (one, other) => PARAMETERS.every(({name}) => Math.abs(one[name] - other[name]) < 1e-4);

/** Sliders with number boxes in `parent`. `changed()` is called when the user has moved one. */
export class Sliders {
  constructor(parent, values, changed) {
    this.values = {...values};
    this.fields = new Map();
    for (const parameter of PARAMETERS) parent.append(this.row(parameter, changed));
    this.show();
  }

  row(parameter, changed) {
    const row = document.createElement('div');
    row.className = 'slider';
    row.dataset.of = parameter.name;
    row.title = parameter.says;
    const name = document.createElement('b');
    name.textContent = parameter.shown;
    const range = this.field(parameter, 'range', `${parameter.shown}: ${parameter.says}`);
    const number = this.field(parameter, 'number', `${parameter.shown} in ${parameter.sign === '°' ? 'degrees' : 'mm'}`);
    number.id = `value-${parameter.name}`;
    range.id = `slider-${parameter.name}`;
    const unit = document.createElement('span');
    unit.className = 'unit';
    unit.textContent = parameter.sign;
    for (const field of [range, number])
      field.addEventListener('input', () => {
        if (field.value === '' || !Number.isFinite(field.valueAsNumber)) return;
        this.values[parameter.name] = field.valueAsNumber * parameter.unit;
        this.show(field);
        changed();
      });
    number.addEventListener('change', () => this.show());
    this.fields.set(parameter, [range, number]);
    row.append(name, range, number, unit);
    return row;
  }

  field({least, most, step}, type, label) {
    const field = document.createElement('input');
    Object.assign(field, {type, min: least, max: most, step: type === 'range' ? step : 'any'});
    if (type === 'number') field.removeAttribute('max'), field.removeAttribute('min');
    field.setAttribute('aria-label', label);
    return field;
  }

  set(values) {
    this.values = {...values};
    this.show();
  }

  /** Writes the values to all fields but the one in which the user types. */
  show(but) {
    for (const [parameter, fields] of this.fields)
      for (const field of fields)
        if (field !== but) field.value = shown(parameter, this.values[parameter.name]);
  }
}
