// The linkage over the tissue, to scale: 1 unit of the drawing is 1 mm, y upwards is negated.
import {svg} from './chart.js';

const MM_PER_N = 26;  // of a force's arrow
const LONGEST_ARROW = 90;
const FAR = 4000;  // the tissue ends beyond the picture
const REACH_PX = 12;  // of a pointer that takes a part
const PARTS = {link1: 'l1', link2: 'l2', link3: 'l3', handle: 'handle', needle: 'needle'};  // of the program, and here

const at = ([x, y]) => `${x.toFixed(2)} ${(-y).toFixed(2)}`;
const way = (points) => `M ${points.map(at).join(' L ')}`;
const minus = ([a, b], [c, d]) => [a - c, b - d];
const length = ([x, y]) => Math.hypot(x, y);

/** A surface at the height `y`, pushed down to the tip while it touches, and open around the needle that is inside. */
function surface(y, tip, state) {
  if (state === 'touching' && tip[1] < y) {
    const points = [];
    for (let x = -60; x <= 60; x += 2) {
      const apart = Math.abs(x) / 60;
      points.push([tip[0] + x, y + (tip[1] - y) * (1 - apart) ** 2.6]);
    }
    return way([[-FAR, y], ...points, [FAR, y]]);
  }
  if (state === 'inside') return `${way([[-FAR, y], [tip[0] - 7, y], [tip[0] - 2.2, y - 2.6]])} ${way([[tip[0] + 2.2, y - 2.6], [tip[0] + 7, y], [FAR, y]])}`;
  return way([[-FAR, y], [FAR, y]]);
}

/** Distance of a place from the line between two others. */
function distance(place, from, to) {
  const along = minus(to, from);
  const squared = along[0] ** 2 + along[1] ** 2;
  const way = minus(place, from);
  const share = squared > 0 ? Math.min(1, Math.max(0, (way[0] * along[0] + way[1] * along[1]) / squared)) : 0;
  return length(minus(way, [share * along[0], share * along[1]]));
}

/** Where the needle crosses the height `y`. */
function crossing({p, tip}, y) {
  const share = (y - p[1]) / (tip[1] - p[1]);
  return [p[0] + share * (tip[0] - p[0]), y];
}

export class Drawing {
  /**
   * `taken(part, [x, y])`: the pointer takes a part there [mm]. `moved([x, y])`: it drags the part there. `turned(rad)`: a
   * key turned the handle.
   */
  constructor(element, taken, moved, turned) {
    this.element = element;
    this.parts = {};
    this.atDevice = false;  // a haptic device moves the linkage, and the pointer does not
    this.build();
    this.listen(taken, moved, turned);
    new ResizeObserver(() => this.fit(true)).observe(element);
  }

  part(name, element, attributes, parent = this.element) {
    this.parts[name] = svg(element, attributes);
    parent.append(this.parts[name]);
  }

  build() {
    this.part('muscle', 'path', {class: 'd-muscle'});
    this.part('fibre', 'path', {class: 'd-fibre'});
    this.part('fluid', 'path', {class: 'd-fluid'});
    this.part('sac', 'path', {class: 'd-sac', id: 'sac'});
    this.part('skin', 'path', {class: 'd-skin', id: 'skin'});
    for (const word of ['skin', 'muscle', 'sac']) this.part(`${word}Word`, 'text', {class: 'd-in'});
    this.part('handWay', 'path', {class: 'd-hand-way'});
    this.part('tipWay', 'path', {class: 'd-tip-way', id: 'tip-way'});
    this.part('dead', 'g', {id: 'dead-points'});
    this.part('base', 'path', {class: 'd-base'});
    this.part('ground', 'path', {class: 'd-ground'});
    this.part('l1', 'path', {class: 'd-link d-l1'});
    this.part('needle', 'path', {class: 'd-needle', id: 'needle'});
    this.part('hub', 'path', {class: 'd-hub'});
    this.part('l2', 'path', {class: 'd-link d-l2'});
    this.part('handle', 'path', {class: 'd-handle'});
    this.part('l3', 'path', {class: 'd-link d-l3'});
    for (const joint of ['a', 'o', 'b', 'p']) this.part(`joint-${joint}`, 'circle', {class: 'd-joint', r: 3.4});
    for (const word of ['a', 'o', 'l1', 'l2', 'l3', 'l4']) this.part(`word-${word}`, 'text', {class: 'd-label', 'text-anchor': 'middle'});
    this.part('hold', 'g', {class: 'd-hold', id: 'handle', tabindex: 0, role: 'slider', 'aria-label': 'Handle of the linkage', 'aria-orientation': 'horizontal'});
    this.part('knob', 'circle', {class: 'd-knob', r: 5.5}, this.parts.hold);
    this.part('grab', 'circle', {class: 'd-grab', r: 15}, this.parts.hold);
    this.part('grasp', 'circle', {class: 'd-grasp', id: 'grasp', r: 4});
    for (const who of ['needle', 'hand']) {
      this.part(`${who}Arrow`, 'path', {class: `d-arrow ${who}`});
      this.part(`${who}Head`, 'path', {class: `d-arrow-head ${who}`});
      this.part(`${who}Text`, 'text', {class: `d-force ${who}`, id: `${who}-arrow-text`});
    }
    this.part('scale', 'path', {class: 'd-scale'});
    this.part('scaleWord', 'text', {class: 'd-label'});
  }

  /** The place of a pointer [mm]. */
  placeOf({clientX, clientY}) {
    const {x, y} = new DOMPoint(clientX, clientY).matrixTransform(this.element.getScreenCTM().inverse());
    return [x, -y];
  }

  /** The moving part that a pointer at `place` takes; undefined: it is not near any. */
  partAt(place) {
    const {a, o, b, p, d, c, tip} = this.frame;
    const lines = {handle: [d, c], link1: [a, p], link2: [p, b], link3: [o, b], needle: [p, tip]};
    let [least, nearest] = [REACH_PX * this.unit, undefined];
    for (const [part, [from, to]] of Object.entries(lines)) {
      const far = distance(place, from, to);
      if (far < least) [least, nearest] = [far, part];
    }
    return nearest;
  }

  listen(taken, moved, turned) {
    const {hold} = this.parts;
    let held;  // the pointer that holds a part
    this.element.addEventListener('pointerdown', (event) => {
      if (this.atDevice || !this.frame) return;
      const place = this.placeOf(event);
      const part = hold.contains(event.target) ? 'handle' : this.partAt(place);
      if (!part) return;
      held = event.pointerId;
      this.element.setPointerCapture(held);
      event.preventDefault();
      if (part === 'handle') hold.focus({preventScroll: true});
      taken(part, place);
    });
    this.element.addEventListener('pointermove', (event) => {
      const place = this.placeOf(event);
      if (event.pointerId === held) return moved(place);
      if (this.frame) this.element.classList.toggle('d-near', !this.atDevice && this.partAt(place) !== undefined);
    });
    for (const end of ['pointerup', 'pointercancel']) this.element.addEventListener(end, () => (held = undefined));
    hold.addEventListener('keydown', (event) => {
      const way = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, PageDown: 8, PageUp: -8}[event.key];
      if (way === undefined) return;
      event.preventDefault();
      turned(way * (event.shiftKey ? 0.1 : 0.5) * Math.PI / 180);
    });
  }

  /** The survey of a new linkage. */
  survey(design) {
    this.design = design;
    const hands = design.reach.map(([, x, y]) => [x, y]);
    const tips = design.reach.map(([, , , x, y]) => [x, y]);
    this.parts.handWay.setAttribute('d', way(hands));
    this.parts.tipWay.setAttribute('d', way(tips));
    this.parts.dead.replaceChildren();
    if (!design.whole_turn)
      for (const end of [0, design.reach.length - 1])
        for (const [x, y] of [hands[end], tips[end]])
          this.parts.dead.append(svg('path', {class: 'd-dead', d: `M ${x - 4} ${-y} l 4 -4 l 4 4 l -4 4 Z`}),
                                 svg('text', {class: 'd-label d-dead-text', x: x + 7, y: -y + 4}, 'dead point'));
    this.points = [...hands, ...tips];
    this.pose(design.frame);
    this.fit(false);
  }

  /** Shows all that the linkage can reach. Leaves the view as it is while it shows that, and not much more. */
  fit(again) {
    if (!this.design || this.element.clientWidth === 0 || this.element.clientHeight === 0) return;
    const {a, o, b, p} = this.frame;
    const sac = -this.design.sac_depth;
    const points = [...this.points, a, o, b, p, [a[0], sac - 25], [a[0] - 60, 0], [a[0] + 60, 0]];
    const [left, right] = [Math.min(...points.map(([x]) => x)) - 18, Math.max(...points.map(([x]) => x)) + 18];
    const [low, high] = [Math.min(...points.map(([, y]) => y)) - 14, Math.max(...points.map(([, y]) => y)) + 14];
    const view = this.view;
    const holds = view && left >= view.left && right <= view.right && low >= view.low && high <= view.high &&
        (right - left) * (high - low) > 0.45 * (view.right - view.left) * (view.high - view.low);
    if (holds && !again) return;
    this.view = {left, right, low, high};
    this.element.setAttribute('viewBox', `${left} ${-high} ${right - left} ${high - low}`);
    this.element.setAttribute('preserveAspectRatio', 'xMidYMid meet');
    this.unit = Math.max((right - left) / this.element.clientWidth, (high - low) / this.element.clientHeight);
    this.element.style.setProperty('--unit', this.unit);
    this.scaleBar();
    this.pose(this.frame);
  }

  /** The edges of the picture, which is wider or higher than the view [mm]. */
  edges() {
    const {left, right, low, high} = this.view;
    const [wide, tall] = [this.unit * this.element.clientWidth, this.unit * this.element.clientHeight];
    return {left: (left + right - wide) / 2, right: (left + right + wide) / 2, low: (low + high - tall) / 2, high: (low + high + tall) / 2};
  }

  scaleBar() {
    const {left, low} = this.edges();
    const bar = [20, 50, 100, 200].find((mm) => mm / this.unit > 60) ?? 400;
    const [x, y] = [left + 12 * this.unit, low + 14 * this.unit];
    this.parts.scale.setAttribute('d', `M ${at([x, y + 3 * this.unit])} L ${at([x, y])} L ${at([x + bar, y])} L ${at([x + bar, y + 3 * this.unit])}`);
    this.word('scaleWord', [x + bar + 6 * this.unit, y - 3 * this.unit], `${bar} mm`);
  }

  word(name, [x, y], text) {
    const part = this.parts[name];
    part.setAttribute('x', x.toFixed(1));
    part.setAttribute('y', (-y).toFixed(1));
    part.style.fontSize = `${12 * this.unit}px`;
    part.textContent = text;
  }

  /** One instant of the linkage. */
  pose(frame) {
    this.frame = frame;
    this.unit ??= 1;
    const {a, o, b, p, d, c, tip} = frame;
    const set = (name, path) => this.parts[name].setAttribute('d', path);
    this.tissue(frame);
    set('base', way([a, o]));
    set('ground', [a, o].map(([x, y]) => `M ${at([x, y])} l -7 0 m 7 -6 l -7 0 l 0 12 l 7 0 Z M ${at([x - 7, y + 6])} l -4 4 m 4 2 l -4 4 m 4 -4`).join(' '));
    set('l1', way([a, p]));
    set('l2', way([p, b]));
    set('l3', way([o, b]));
    set('handle', way([d, c]));
    this.needle(p, tip);
    for (const [joint, place] of Object.entries({a, o, b, p})) {
      this.parts[`joint-${joint}`].setAttribute('cx', place[0]);
      this.parts[`joint-${joint}`].setAttribute('cy', -place[1]);
    }
    for (const part of [this.parts.knob, this.parts.grab]) {
      part.setAttribute('cx', c[0]);
      part.setAttribute('cy', -c[1]);
    }
    this.names({a, o, b, p});
    this.grasp(frame);
    this.arrow('needle', tip, frame.needle_N);
    this.arrow('hand', frame.grasp, frame.hand_N);
  }

  /** Which part the hand holds or touches, and where; a hand at a device that does neither is drawn, too. */
  grasp({grasp, held, touched}) {
    for (const [part, name] of Object.entries(PARTS)) {
      this.parts[name].classList.toggle('d-held', part === held);
      this.parts[name].classList.toggle('d-touched', part === touched);
    }
    const atEnd = held === 'handle' && length(minus(grasp, this.frame.c)) < 0.5;
    this.parts.grasp.style.display = atEnd ? 'none' : '';
    this.parts.grasp.setAttribute('cx', grasp[0]);
    this.parts.grasp.setAttribute('cy', -grasp[1]);
    this.parts.grasp.classList.toggle('d-free', !held && !touched);
  }

  names({a, o, b, p}) {
    const beside = (one, other, name) => {
      const [x, y] = minus(other, one);
      const long = Math.max(length([x, y]), 1);
      this.word(`word-${name}`, [(one[0] + other[0]) / 2 - 13 * this.unit * y / long, (one[1] + other[1]) / 2 + 13 * this.unit * x / long - 4 * this.unit], name);
    };
    beside(a, p, 'l1');
    beside(p, b, 'l2');
    beside(b, o, 'l3');
    beside(o, a, 'l4');
    this.word('word-a', [a[0] - 16 * this.unit, a[1] + 10 * this.unit], 'A');
    this.word('word-o', [o[0] - 16 * this.unit, o[1] + 10 * this.unit], 'O');
  }

  needle(p, tip) {
    const [x, y] = minus(tip, p);
    const long = Math.max(length([x, y]), 1e-6);
    const side = [-y / long, x / long];
    const bevel = Math.min(8, long);
    const corner = (share, wide) => [p[0] + share * x + wide * side[0], p[1] + share * y + wide * side[1]];
    const shoulder = 1 - bevel / long;
    this.parts.needle.setAttribute('d', `${way([corner(0, 1), corner(shoulder, 1), corner(1, -0.9), corner(0, -1)])} Z`);
    this.parts.hub.setAttribute('d', way([p, corner(Math.min(14 / long, 1), 0)]));
  }

  tissue(frame) {
    const sac = -this.design.sac_depth;
    const {skin, sac: sacState} = frame.layers;
    const skinLine = surface(0, skin === 'inside' ? crossing(frame, 0) : frame.tip, skin);
    const sacLine = surface(sac, sacState === 'inside' ? crossing(frame, sac) : frame.tip, sacState);
    const filled = (line) => `${line.replaceAll(' M ', ' L ')} L ${at([FAR, -FAR])} L ${at([-FAR, -FAR])} Z`;
    this.parts.muscle.setAttribute('d', filled(skinLine));
    this.parts.fluid.setAttribute('d', filled(sacLine));
    this.parts.skin.setAttribute('d', skinLine);
    this.parts.sac.setAttribute('d', sacLine);
    const fibres = [0.25, 0.5, 0.75].map((share) => way([[-FAR, share * sac], [FAR, share * sac]]));
    this.parts.fibre.setAttribute('d', fibres.join(' '));
    if (!this.view) return;
    const x = this.edges().left + 12 * this.unit;
    this.word('skinWord', [x, 5 * this.unit], 'skin');
    this.word('muscleWord', [x, sac / 2 - 4 * this.unit], 'muscle');
    this.word('sacWord', [x, sac - 15 * this.unit], 'sac');
  }

  arrow(who, from, force) {
    const N = length(force);
    const shows = N > 0.01;
    for (const part of ['Arrow', 'Head', 'Text']) this.parts[`${who}${part}`].style.display = shows ? '' : 'none';
    if (!shows) return;
    const long = Math.min(N * MM_PER_N, LONGEST_ARROW);
    const [x, y] = [force[0] / N, force[1] / N];
    const head = Math.min(9, long);
    const to = (along, across) => [from[0] + along * x - across * y, from[1] + along * y + across * x];
    this.parts[`${who}Arrow`].setAttribute('d', way([from, to(long - head / 2, 0)]));
    this.parts[`${who}Head`].setAttribute('d', `${way([to(long, 0), to(long - head, head / 2.4), to(long - head, -head / 2.4)])} Z`);
    this.word(`${who}Text`, to(long / 2, who === 'hand' ? 9 : -9).map((value, axis) => value - (axis === 1 ? 4 * this.unit : 0)), `${N.toFixed(2)} N`);
  }

  /** What a screen reader says of the handle. */
  describe(frame, text) {
    const {hold} = this.parts;
    hold.setAttribute('aria-valuemin', this.design.reach[0][0].toFixed(3));
    hold.setAttribute('aria-valuemax', this.design.reach.at(-1)[0].toFixed(3));
    hold.setAttribute('aria-valuenow', frame.link3.toFixed(3));
    hold.setAttribute('aria-valuetext', text);
  }
}
