import uPlot from 'uplot';

import {element, setText} from '../../page/page';
import type {Touch} from '../../present/instant';
import {lookOf} from '../../words/phases';
import {sinceNow, timeMarks} from './time_axis';
import {TouchHistory} from './touch_history';
import {PlotWindow} from './window';

const BAND_PX = 5;  // height of the phases under a curve
const ZOOM = 0.6;
const STEP = 0.25;
const FONT = '10px system-ui, sans-serif';
const REST_TEXT = 'Drag in a plot to zoom';

interface Curve {
  box: string;
  lines: readonly {value: 'force_N' | 'drive_N' | 'indentation_mm'; color: string; dash?: number[]}[];  // color: a CSS variable
  unit: string;
  least: number;                        // least top of the scale
  step: number;                         // the scale grows in such steps
}
const CURVES: readonly Curve[] = [
  {box: 'force-plot', unit: 'N', least: 5, step: 5,
   lines: [{value: 'drive_N', color: '--muted', dash: [3, 3]}, {value: 'force_N', color: '--curve-force'}]},
  {box: 'indentation-plot', unit: 'mm', least: 40, step: 20, lines: [{value: 'indentation_mm', color: '--curve-indentation'}]},
];

interface BoxedPlot {
  plot: uPlot;
  box: HTMLElement;
  curve: Curve;
}

/** Gives the plot the size of its box; false if the box is hidden, as in a small window. */
function fit({plot, box}: BoxedPlot): boolean {
  const [width, height] = [box.clientWidth, box.clientHeight];
  if (width === 0 || height === 0) return false;
  if (plot.width !== width || plot.height !== height) plot.setSize({width, height});
  return true;
}

/** True for the plots of a small window, which have no room for an axis of time. */
const isLow = ({height}: uPlot) => height < 50;

const css = (variable: string) => getComputedStyle(document.body).getPropertyValue(variable).trim();

/**
 * Force and indentation over the station's time, with the phases as a coloured band below. Both plots show the same
 * time. A drag or the plus key zooms, which holds the time; Escape follows the newest values again.
 */
export class TouchPlots {
  private readonly history = new TouchHistory();
  private readonly window = new PlotWindow();
  private readonly plots: BoxedPlot[];
  private readonly under = element('plot-at');
  private readonly live = element<HTMLButtonElement>('plot-live');
  private pointed_s: number | undefined;

  constructor() {
    this.plots = CURVES.map((curve) => this.open(curve));
    this.live.addEventListener('click', () => this.follow());
  }

  add(touch: Touch): void {
    this.history.add(touch);
  }

  draw(): void {
    const {begin_s, end_s} = this.history;
    this.live.hidden = this.window.isLive;
    this.showPointed();
    const shown = this.plots.filter(fit);
    if (begin_s === undefined || end_s === undefined) return;
    const {from_s, to_s} = this.window.range(begin_s, end_s);
    const columns = this.history.columns(from_s, to_s);
    for (const {plot, curve} of shown) {
      plot.setData([columns.at_s, ...curve.lines.map(({value}) => columns[value])], false);
      plot.setScale('x', {min: from_s, max: to_s});
    }
  }

  private follow(): void {
    this.window.live();
    this.draw();
  }

  private open(curve: Curve): BoxedPlot {
    const box = element(curve.box);
    const plot = new uPlot(this.options(curve, box), [[], ...curve.lines.map(() => [])], box);
    box.addEventListener('keydown', (event) => this.takeKey(event));
    box.addEventListener('dblclick', () => this.follow());
    return {plot, box, curve};
  }

  private options(curve: Curve, box: HTMLElement): uPlot.Options {
    const muted = () => css('--muted');
    const grid = {stroke: () => css('--grid'), width: 1};
    return {
      width: Math.max(box.clientWidth, 10),
      height: Math.max(box.clientHeight, 10),
      padding: [6, 12, 0, 0],
      legend: {show: false},
      scales: {
        x: {time: false, auto: false},
        y: {range: (_plot, _least, most) => [0, Math.ceil(Math.max(most ?? 0, curve.least) / curve.step) * curve.step]},
      },
      axes: [
        {stroke: muted, grid: {show: false}, ticks: {show: false}, gap: BAND_PX + 3, font: FONT,
         size: (plot) => BAND_PX + (isLow(plot) ? 1 : 15),
         splits: (plot, _axis, least, most) => (isLow(plot) ? [] : timeMarks(least, most, this.history.end_s ?? most)),
         values: (_plot, marks) => marks.map((at_s) => sinceNow(at_s, this.history.end_s ?? at_s))},
        {stroke: muted, grid, ticks: {show: false}, size: 26, gap: 3, font: FONT,
         splits: (plot, _axis, least, most) => (isLow(plot) ? [least, most] : [least, (least + most) / 2, most])},
      ],
      series: [{}, ...curve.lines.map(({color, dash}) => ({stroke: () => css(color), width: 1.75, points: {show: false}, ...(dash && {dash})}))],
      cursor: {
        y: false,
        points: {show: false},
        drag: {x: true, y: false, setScale: false},
        sync: {key: 'touch'},
      },
      hooks: {
        draw: [(plot) => this.drawPhases(plot)],
        setCursor: [(plot) => {
          const {left} = plot.cursor;
          this.pointed_s = left === undefined || left === null || left < 0 ? undefined : plot.posToVal(left, 'x');
          this.showPointed();
        }],
        setSelect: [(plot) => this.zoomTo(plot)],
      },
    };
  }

  private zoomTo(plot: uPlot): void {
    const {left, width} = plot.select;
    if (width < 6) return;
    this.window.hold({from_s: plot.posToVal(left, 'x'), to_s: plot.posToVal(left + width, 'x')});
    plot.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
    this.draw();
  }

  private drawPhases(plot: uPlot): void {
    const {min, max} = plot.scales['x'] ?? {};
    if (min === undefined || max === undefined || min === null || max === null) return;
    const {left, top, width, height} = plot.bbox;
    const ratio = uPlot.pxRatio;
    for (const {phase, from_s, to_s} of this.history.phases(min, max)) {
      const [x0, x1] = [from_s, to_s].map((at_s) => left + (width * (at_s - min)) / (max - min)) as [number, number];
      plot.ctx.fillStyle = css(`--tone-${lookOf(phase).tone}`);
      plot.ctx.fillRect(x0, top + height + ratio, Math.max(1, x1 - x0), BAND_PX * ratio);
    }
  }

  private showPointed(): void {
    const touch = this.pointed_s === undefined ? undefined : this.history.at(this.pointed_s);
    const {end_s} = this.history;
    setText(this.under, touch === undefined || end_s === undefined ? REST_TEXT :
      `${(touch.at_s - end_s).toFixed(1)} s: ${touch.drive_N > 0 ? `drive ${touch.drive_N.toFixed(1)}` : touch.force_N.toFixed(1)} N, ${(1000 * touch.indentation_m).toFixed(0)} mm, ` +
          (touch.phase === undefined ? '' : lookOf(touch.phase).name));
  }

  private takeKey(event: KeyboardEvent): void {
    const {begin_s, end_s} = this.history;
    if (begin_s === undefined || end_s === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const acts: Record<string, () => void> = {
      '+': () => this.window.zoom(ZOOM),
      '=': () => this.window.zoom(ZOOM),
      '-': () => this.window.zoom(1 / ZOOM),
      ArrowLeft: () => this.window.move(-STEP, begin_s, end_s),
      ArrowRight: () => this.window.move(STEP, begin_s, end_s),
      Escape: () => this.window.live(),
    };
    const act = acts[event.key];
    if (act === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    act();
    this.draw();
  }
}
