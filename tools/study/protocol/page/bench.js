// The linkage outside the patient, to scale: 1 unit of the drawing is 1 mm, y upwards is negated. What the condition
// hides does not come from the program, so it cannot be drawn.
import {svg} from './chart.js';

const FAR = 4000;  // the patient ends beyond the picture
const ARROW_MM = 46;
const BELOW_MM = 26;
const MARGIN_MM = 34;

const at = ([x, y]) => `${x.toFixed(2)} ${(-y).toFixed(2)}`;
const way = (points) => `M ${points.map(at).join(' L ')}`;
const plus = ([a, b], [c, d], scale) => [a + scale * c, b + scale * d];

/** The skin, pushed down to the tip while the needle has not gone through it. */
function skin(end, throughSkin) {
  if (throughSkin || end[1] >= 0) return [[-FAR, 0], [FAR, 0]];
  const points = [];
  for (let x = -60; x <= 60; x += 2) points.push([end[0] + x, end[1] * (1 - Math.abs(x) / 60) ** 2.6]);
  return [[-FAR, 0], ...points, [FAR, 0]];
}

export class Bench {
  constructor(element) {
    this.element = element;
    this.parts = {};
    const add = (name, tag, attributes) => element.append((this.parts[name] = svg(tag, attributes)));
    add('body', 'path', {class: 'body'});
    add('skin', 'path', {class: 'd-skin', id: 'skin'});
    add('base', 'path', {class: 'd-base'});
    add('l1', 'path', {class: 'd-link d-l1'});
    add('needle', 'path', {class: 'd-hub', id: 'needle'});
    add('l2', 'path', {class: 'd-link d-l2'});
    add('handle', 'path', {class: 'd-handle'});
    add('l3', 'path', {class: 'd-link d-l3'});
    for (const joint of ['a', 'o', 'b', 'p']) add(joint, 'circle', {class: 'd-joint', r: 3.4});
    add('knob', 'circle', {class: 'd-knob', r: 5.5, id: 'knob'});
    add('push', 'path', {class: 'push'});
    add('pushHead', 'path', {class: 'push-head'});
    add('pushText', 'text', {class: 'push-text', 'text-anchor': 'middle'});
    this.clear();
  }

  /** Nothing is under way. */
  clear() {
    this.fitted = false;
    this.show(false);
    this.arrow(undefined);
    this.element.setAttribute('viewBox', '-150 -150 300 300');
  }

  show(seen) {
    for (const [name, part] of Object.entries(this.parts))
      if (!name.startsWith('push')) part.toggleAttribute('hidden', !seen);
  }

  /** `ready`: the hand has not moved yet, and the arrow tells where to. */
  draw({seen, along}, ready) {
    this.show(seen !== undefined);
    if (seen) this.pose(seen);
    if (seen && !this.fitted) this.fit(seen);
    this.arrow(ready ? {from: seen?.c ?? [0, 0], along} : undefined);
  }

  pose({a, o, b, p, d, c, end, links, through_skin: throughSkin}) {
    const {parts} = this;
    const points = skin(end, throughSkin);
    parts.skin.setAttribute('d', way(points));
    parts.body.setAttribute('d', `${way(points)} L ${at([FAR, -FAR])} L ${at([-FAR, -FAR])} Z`);
    parts.needle.setAttribute('d', way([p, end]));
    if (links) parts.l1.setAttribute('d', links.map(way).join(' '));  // another mechanism than a four-bar linkage
    else
      for (const [name, ...ends] of [['base', a, o], ['l1', a, p], ['l2', p, b], ['l3', o, b], ['handle', d, c]])
        parts[name].setAttribute('d', way(ends));
    for (const name of ['base', 'l2', 'l3', 'handle', 'a', 'o', 'b']) parts[name].toggleAttribute('hidden', links !== undefined);
    for (const [name, [x, y]] of Object.entries(links ? {p, knob: c} : {a, o, b, p, knob: c})) {
      parts[name].setAttribute('cx', x.toFixed(2));
      parts[name].setAttribute('cy', (-y).toFixed(2));
    }
  }

  /** The picture of one penetration does not move: it holds the linkage with room for the way of the handle. */
  fit({a, o, b, p, d, c, links}) {
    const all = [...(links ? links.flat() : [a, o, b, d]), p, c, [0, -BELOW_MM]];
    const [xs, ys] = [all.map(([x]) => x), all.map(([, y]) => y)];
    const [left, top] = [Math.min(...xs) - MARGIN_MM, Math.max(...ys) + MARGIN_MM];
    this.element.setAttribute('viewBox', `${left} ${-top} ${Math.max(...xs) + MARGIN_MM - left} ${top - Math.min(...ys)}`);
    this.fitted = true;
  }

  arrow(push) {
    for (const name of ['push', 'pushHead', 'pushText']) this.parts[name].toggleAttribute('hidden', !push);
    if (!push) return;
    const {from, along} = push;
    const beside = [-along[1], along[0]];
    const tip = plus(from, along, ARROW_MM);
    const back = plus(tip, along, -10);
    this.parts.push.setAttribute('d', way([from, back]));
    this.parts.pushHead.setAttribute('d', `${way([tip, plus(back, beside, 5), plus(back, beside, -5)])} Z`);
    const [x, y] = plus(tip, along, 14);
    this.parts.pushText.setAttribute('x', x);
    this.parts.pushText.setAttribute('y', -y + 4);
    this.parts.pushText.textContent = 'push';
  }
}
