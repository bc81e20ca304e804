// The search over a box of parameters, and the front that it finds.
import {axes, svg} from './chart.js';
import {PARAMETERS, short, shown} from './parameters.js';

const byId = (id) => document.getElementById(id);
/** The box of S4's Table 1, in what the page shows. l4 varies over the study's range for linkage 1. */
const FIRST_BOX = {l1: [60, 140], l2: [80, 200], l3: [60, 160], l4: [80, 200], theta: [-30, 30], phi: [0, 150], h: [0, 100], l_h: [100, 200]};

export class SearchCard {
  /** `values()`: the present linkage. `send(text)`: to the program. `load(values)`: show this linkage. */
  constructor(values, send, load) {
    Object.assign(this, {values, send, load, rows: new Map(), front: [], paper: []});
    for (const parameter of PARAMETERS) this.addRow(parameter);
    byId('search').addEventListener('click', () => this.begin());
    byId('cancel').addEventListener('click', () => {
      this.send('cancel');
      byId('cancel').disabled = true;
      byId('search-note').textContent = 'Ends after the linkage that is being judged.';
    });
    new ResizeObserver(() => this.draw()).observe(byId('front-chart'));
  }

  addRow(parameter) {
    const [least, most] = FIRST_BOX[parameter.name];
    const label = document.createElement('label');
    const varies = document.createElement('input');
    varies.type = 'checkbox';
    varies.checked = true;
    varies.id = `vary-${parameter.name}`;
    varies.title = `Vary ${parameter.shown}; otherwise it stays as it is`;
    label.append(varies, parameter.shown);
    const limits = [least, most].map((value, at) => {
      const field = document.createElement('input');
      Object.assign(field, {type: 'number', step: 'any', value, id: `${at === 0 ? 'least' : 'most'}-${parameter.name}`});
      field.setAttribute('aria-label', `${at === 0 ? 'least' : 'most'} ${parameter.shown}`);
      return field;
    });
    varies.addEventListener('change', () => limits.forEach((field) => (field.disabled = !varies.checked)));
    const unit = document.createElement('span');
    unit.className = 'unit';
    unit.textContent = parameter.sign;
    byId('box').append(label, ...limits, unit);
    this.rows.set(parameter, {varies, limits});
  }

  begin() {
    const values = this.values();
    const ranges = [...this.rows].map(([parameter, {varies, limits}]) => {
      const number = (value) => short(value, 5);
      const [least, most] = limits.map((field) => number(field.valueAsNumber * parameter.unit));
      return `${parameter.name}=${varies.checked ? `${least}:${most}` : number(values[parameter.name])}`;
    });
    byId('search-refused').hidden = true;
    this.running(true);
    byId('searching').removeAttribute('value');
    byId('search-note').textContent = 'The operators begin.';
    this.send(`search ${byId('evaluations').value || 0} ${ranges.join(' ')}`);
  }

  running(yes) {
    byId('search').hidden = yes;
    byId('cancel').hidden = !yes;
    byId('cancel').disabled = false;
    byId('searching').hidden = !yes;
  }

  refused({what, fix}) {
    this.running(false);
    byId('search-note').textContent = '';
    byId('search-refused').hidden = false;
    byId('search-refused').textContent = `${what}. ${fix}.`;
  }

  progress({held_out, done, all, front}) {
    byId('searching').max = Math.max(all, 1);
    byId('searching').value = done;
    byId('search-note').textContent = held_out
      ? `Other operators judge the best: ${done} of ${all}`
      : `${done} of ${all} linkages judged${front.length > 0 ? `; least overshoot so far ${front.at(-1).overshoot[0].toFixed(1)} mm` : ''}`;
    this.front = front;
    this.draw();
  }

  found({front, paper, stopped}) {
    this.running(false);
    Object.assign(this, {front, paper});
    const best = front.at(-1);
    const other = best?.held_out ? ` Operators who took no part give the last one ${best.held_out[0].toFixed(1)} mm (${best.held_out[1].toFixed(1)} to ${best.held_out[2].toFixed(1)}).` : '';
    byId('search-note').textContent = best
      ? `${stopped ? 'Ended early. ' : ''}${front.length} linkages that no other one beats in both.${other}`
      : 'No linkage of this box could be used by all operators. Widen a range.';
    this.draw();
  }

  draw() {
    byId('front').hidden = this.front.length === 0;
    if (this.front.length === 0) return;
    const chart = byId('front-chart');
    const focused = [...chart.querySelectorAll('.front')].indexOf(document.activeElement);
    const all = [...this.front, ...this.paper];
    const most = (of) => 1.12 * Math.max(...all.map(of));
    const scale = axes(chart, {least: 0, most: most(({hand}) => hand[0]), title: 'largest force at the hand, N'},
                       {least: 0, most: most(({overshoot}) => overshoot[0]), title: 'overshoot, mm'});
    for (const {overshoot, hand} of this.paper)
      chart.append(svg('circle', {class: 'paper', r: 3, cx: scale.x(hand[0]), cy: scale.y(overshoot[0])}));
    for (const one of this.front) chart.append(this.point(one, scale));
    if (this.paper.length > 0) {
      const {width} = chart.getBoundingClientRect();
      chart.append(svg('text', {x: width - 8, y: 16, 'text-anchor': 'end'}, 'grey: S4’s linkages'));
    }
    if (focused >= 0) chart.querySelectorAll('.front')[focused]?.focus();
  }

  point(one, scale) {
    const [x, y] = [scale.x(one.hand[0]), scale.y(one.overshoot[0])];
    const words = PARAMETERS.filter(({name}) => one.design[name] !== null)
                      .map((parameter) => `${parameter.shown} ${shown(parameter, one.design[parameter.name])}`).join(', ');
    const label = `overshoot ${one.overshoot[0].toFixed(1)} mm, ${one.hand[0].toFixed(2)} N at the hand: ${words}`;
    const group = svg('g', {class: 'front', tabindex: 0, role: 'button', 'aria-label': label},
                      svg('title', {}, label), svg('line', {x1: x, x2: x, y1: scale.y(one.overshoot[1]), y2: scale.y(Math.max(one.overshoot[2], 0))}),
                      svg('circle', {r: 5, cx: x, cy: y, 'stroke-width': 1.5}));
    const load = () => this.load({...this.values(), ...Object.fromEntries(Object.entries(one.design).filter(([name, value]) => value !== null && name !== 'needle'))});
    group.addEventListener('click', load);
    group.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      load();
    });
    return group;
  }
}
