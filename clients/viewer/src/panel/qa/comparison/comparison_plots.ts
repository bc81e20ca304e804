import uPlot from 'uplot';

import {element, made, setText} from '../../../page/page';
import type {ComparedRuns} from '../../../playback/comparison_state';
import {clock} from '../../../playback/timeline_words';
import {lookOf} from '../../../words/phases';
import {momentSays} from './comparison_words';

const BAND_PX = 5;   // height of a run's phases under the forces
const AXIS_PX = 30;
const DASH = [5, 3];
const FONT = '10px system-ui, sans-serif';

interface Curve {
  box: string;
  colors: readonly string[];  // CSS variables: of A and B, or of the difference
  step: number;               // the scale's top is a multiple of it
  phases: boolean;            // the bands of both runs lie under the curves
  times: boolean;             // the axis of time that all plots share lies under this one
  columns: (runs: ComparedRuns) => (readonly (number | null)[])[];
}
const CURVES: readonly Curve[] = [
  {box: 'comparison-force', colors: ['--curve-force', '--curve-other'], step: 1, phases: true, times: false,
   columns: ({a, b}) => [a.force_N, b.force_N]},
  {box: 'comparison-indentation', colors: ['--curve-indentation', '--curve-other'], step: 10, phases: false, times: false,
   columns: ({a, b}) => [a.indentation_mm, b.indentation_mm]},
  {box: 'comparison-apart', colors: ['--curve-apart'], step: 0.1, phases: false, times: true,
   columns: ({apart_N}) => [apart_N]},
];

const css = (variable: string) => getComputedStyle(document.body).getPropertyValue(variable).trim();

/** Force, indentation and force difference of two runs on one time axis, with the played moment as a line in each. */
export class ComparisonPlots {
  private readonly plots = CURVES.map((curve) => this.open(curve));
  private runs: ComparedRuns | undefined;
  private position_s = 0;
  private pointed_s: number | undefined;

  /** `seek` is called with the time of a click. */
  constructor(private readonly seek: (at_s: number) => void) {}

  show(runs: ComparedRuns, position_s: number): void {
    this.position_s = position_s;
    const isNew = runs !== this.runs;
    this.runs = runs;
    for (const {plot, box, curve, now} of this.plots) {
      const [width, height] = [box.clientWidth, box.clientHeight];
      if (width > 0 && (plot.width !== width || plot.height !== height)) plot.setSize({width, height});
      if (isNew) plot.setData([runs.at_s, ...curve.columns(runs)] as uPlot.AlignedData);
      now.style.left = `${plot.valToPos(position_s, 'x')}px`;
    }
    this.say();
  }

  private open(curve: Curve) {
    const box = element(curve.box);
    const now = made('i', 'comparison-now');
    const plot = new uPlot(this.options(curve), [[], ...curve.colors.map(() => [])] as uPlot.AlignedData, box);
    plot.over.append(now);
    plot.over.addEventListener('click', ({offsetX}) => this.seek(plot.posToVal(offsetX, 'x')));
    return {plot, box, curve, now};
  }

  private options({colors, step, phases, times}: Curve): uPlot.Options {
    const muted = () => css('--muted');
    const grid = {stroke: () => css('--grid'), width: 1};
    return {
      width: 100, height: 50, padding: [6, 16, phases ? 2 * BAND_PX + 3 : 2, 0], legend: {show: false},
      scales: {
        x: {time: false},
        y: {range: (_plot, _least, most) => [0, Math.ceil(Math.max(most ?? 0, step) / step) * step]},
      },
      axes: [
        {show: times, stroke: muted, grid, ticks: {show: false}, size: 14, gap: 2, font: FONT, space: 70,
         values: (_plot, marks) => marks.map(clock)},
        {stroke: muted, grid, ticks: {show: false}, size: AXIS_PX, gap: 3, font: FONT,
         splits: (_plot, _axis, least, most) => [least, most]},
      ],
      series: [{}, ...colors.map((color, at) =>
        ({stroke: () => css(color), width: 1.5, points: {show: false}, ...(at === 1 ? {dash: DASH} : {})}))],
      cursor: {y: false, points: {show: false}, drag: {x: false, y: false}, sync: {key: 'comparison'}},
      hooks: {
        draw: phases ? [(plot) => this.drawPhases(plot)] : [],
        setCursor: [({cursor: {left}, posToVal}) => {
          this.pointed_s = left === undefined || left === null || left < 0 ? undefined : posToVal(left, 'x');
          this.say();
        }],
      },
    };
  }

  /** The phases of A, and below them those of B. */
  private drawPhases(plot: uPlot): void {
    const {runs} = this;
    if (runs === undefined) return;
    const {left, top, width, height} = plot.bbox;
    const ratio = uPlot.pxRatio;
    const bin_px = width / runs.at_s.length;
    [runs.a, runs.b].forEach(({phase}, row) => {
      for (let from = 0, to = 0; from < phase.length; from = to) {
        while (to < phase.length && phase[to] === phase[from]) ++to;
        const now = phase[from];
        if (!now) continue;
        plot.ctx.fillStyle = css(`--tone-${lookOf(now).tone}`);
        plot.ctx.fillRect(left + from * bin_px, top + height + (1 + row * (BAND_PX + 1)) * ratio, (to - from) * bin_px, BAND_PX * ratio);
      }
    });
  }

  private say(): void {
    if (this.runs !== undefined)
      setText(element('comparison-moment'), momentSays(this.runs, this.pointed_s ?? this.position_s));
  }
}
