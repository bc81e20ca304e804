// Plots as SVG, in pixels of the element.
const SVG = 'http://www.w3.org/2000/svg';

/** A new SVG element with these attributes and children. */
export function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** About `count` round numbers from `least` to `most`. */
export function ticks(least, most, count) {
  const rough = (most - least) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough);
  const found = [];
  for (let at = Math.ceil(least / step); at * step <= most + 1e-9 * step; ++at) found.push(Number((at * step).toPrecision(12)));
  return found;
}

const LEFT = 34, RIGHT = 8, TOP = 8, BOTTOM = 30;

/**
 * Axes in `element`. `x` and `y`: {least, most, title}. Returns the scales {x, y}, from values to pixels.
 */
export function axes(element, x, y) {
  const {width, height} = element.getBoundingClientRect();
  element.setAttribute('viewBox', `0 0 ${width} ${height}`);
  element.replaceChildren();
  const bottom = height - BOTTOM;
  const scale = {
    x: (value) => LEFT + (value - x.least) / (x.most - x.least) * (width - LEFT - RIGHT),
    y: (value) => bottom - (value - y.least) / (y.most - y.least) * (bottom - TOP),
  };
  for (const at of ticks(x.least, x.most, width / 70))
    element.append(svg('text', {x: scale.x(at), y: bottom + 13, 'text-anchor': 'middle'}, String(at)));
  for (const at of ticks(y.least, y.most, height / 45)) {
    element.append(svg('line', {class: 'grid', x1: LEFT, x2: width - RIGHT, y1: scale.y(at), y2: scale.y(at)}));
    element.append(svg('text', {x: LEFT - 5, y: scale.y(at) + 4, 'text-anchor': 'end'}, String(at)));
  }
  element.append(svg('line', {class: 'axis', x1: LEFT, x2: width - RIGHT, y1: bottom, y2: bottom}));
  element.append(svg('text', {x: width - RIGHT, y: height - 4, 'text-anchor': 'end'}, x.title));
  if (y.title) element.append(svg('text', {x: LEFT + 4, y: TOP + 8}, y.title));
  return scale;
}

/** A dashed vertical line with a word. */
export function mark(element, scale, at, word) {
  const {height} = element.getBoundingClientRect();
  const x = scale.x(at);
  element.append(svg('line', {class: 'mark', x1: x, x2: x, y1: TOP, y2: height - BOTTOM}));
  element.append(svg('text', {x: x + 3, y: TOP + 8}, word));
}

export const polyline = (points, scale, name) =>
    svg('polyline', {class: name, points: points.map(([x, y]) => `${scale.x(x).toFixed(1)},${scale.y(y).toFixed(1)}`).join(' ')});
