import {type DepthSummary, HISTOGRAM_BIN_M} from '../../depth/depth_summary';
import {element, setText} from '../../page/page';
import {depthColor} from '../../scene/depth_color';
import type {SceneView} from '../../scene/scene_view';

const LEGEND_STEPS = 64;
const MOST_SHOWN_M = 2.5;
const SHOWN_OF_FAR = 1.25;  // the histogram reaches this much beyond the range

/**
 * The range of depth that colours span, with a legend and the histogram of the picture. It follows the picture until
 * the user sets one of its ends; "Auto" lets it follow again.
 */
export class DepthRange {
  private readonly near = element<HTMLInputElement>('range-near');
  private readonly far = element<HTMLInputElement>('range-far');
  private readonly auto = element<HTMLButtonElement>('range-auto');
  private readonly canvas = element<HTMLCanvasElement>('depth-histogram');
  private followed = true;

  constructor(private readonly view: SceneView) {
    for (const end of [this.near, this.far]) end.addEventListener('input', () => this.setByHand(end));
    this.auto.addEventListener('click', () => this.follow());
    this.drawLegend(element<HTMLCanvasElement>('depth-legend'));
  }

  show({near_m, far_m, histogram}: DepthSummary): void {
    if (this.followed) {
      this.near.value = near_m.toFixed(2);
      this.far.value = far_m.toFixed(2);
    }
    const [from_m, to_m] = [Number(this.near.value), Number(this.far.value)];
    setText(element('range-near-text'), `${from_m.toFixed(2)} m`);
    setText(element('range-far-text'), `${to_m.toFixed(2)} m`);
    this.drawHistogram(histogram, from_m, to_m);
  }

  private setByHand(moved: HTMLInputElement): void {
    this.followed = false;
    this.auto.setAttribute('aria-pressed', 'false');
    const least_m = 0.05;
    if (Number(this.far.value) - Number(this.near.value) < least_m) {
      if (moved === this.near) this.far.value = String(Number(this.near.value) + least_m);
      else this.near.value = String(Number(this.far.value) - least_m);
    }
    this.view.surface.setRange({near_m: Number(this.near.value), far_m: Number(this.far.value)});
    this.view.invalidate();
  }

  private follow(): void {
    this.followed = true;
    this.auto.setAttribute('aria-pressed', 'true');
    this.view.surface.setRange(undefined);
    this.view.invalidate();
  }

  private drawLegend(canvas: HTMLCanvasElement): void {
    const context = canvas.getContext('2d');
    [canvas.width, canvas.height] = [LEGEND_STEPS, 1];
    for (let step = 0; context !== null && step < LEGEND_STEPS; ++step) {
      context.fillStyle = depthColor(step / (LEGEND_STEPS - 1));
      context.fillRect(step, 0, 1, 1);
    }
  }

  /** Bars in the colours of the legend; those outside the range are pale. */
  private drawHistogram(histogram: readonly number[], from_m: number, to_m: number): void {
    const context = this.canvas.getContext('2d');
    if (context === null || this.canvas.clientWidth === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    [this.canvas.width, this.canvas.height] = [width * ratio, height * ratio];
    context.scale(ratio, ratio);
    const bars = histogram.slice(0, Math.round(Math.min(MOST_SHOWN_M, SHOWN_OF_FAR * to_m) / HISTOGRAM_BIN_M));
    const highest = Math.sqrt(Math.max(0.01, ...bars));
    bars.forEach((share, bin) => {
      const at_m = (bin + 0.5) * HISTOGRAM_BIN_M;
      const inside = at_m >= from_m && at_m <= to_m;
      context.fillStyle = inside ? depthColor((at_m - from_m) / (to_m - from_m)) : 'rgba(148, 170, 192, 0.35)';
      const bar = (Math.sqrt(share) / highest) * (height - 1);  // by the root, so that a bed hides no patient
      context.fillRect((bin * width) / bars.length, height - bar, width / bars.length - 0.5, bar);
    });
  }
}
