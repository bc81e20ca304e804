import {element, made, setText} from '../page/page';
import type {ProbeView} from '../present/probe_view';
import {caliperAfter, marks_mm} from './depth_scale';

const KEYS = ['ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Escape'];

/**
 * The image under the ultrasound probe, with a scale of depth and a caliper: the pointer or the arrow keys move a line
 * whose depth is read out. The link worker draws the image; the page adds scale, caliper and words.
 */
export class UltrasoundPanel {
  readonly canvas = element<HTMLCanvasElement>('ultrasound-image');

  private readonly frame = element('ultrasound-frame');
  private readonly scale = element('ultrasound-scale');
  private readonly line = element('ultrasound-line');
  private readonly said = element('ultrasound-said');
  private depth_m = 0;
  private caliper_mm: number | undefined;
  private onSkin = false;

  constructor() {
    this.frame.addEventListener('pointermove', ({clientY}) => {
      const {top, height} = this.canvas.getBoundingClientRect();
      if (height > 0) this.setCaliper(Math.max(0, Math.min(1, (clientY - top) / height)) * 1000 * this.depth_m);
    });
    this.frame.addEventListener('pointerleave', () => this.setCaliper(undefined));
    this.frame.addEventListener('keydown', (event) => {
      if (!KEYS.includes(event.key)) return;
      event.preventDefault();
      this.setCaliper(caliperAfter(event.key, this.caliper_mm, this.depth_m));
    });
  }

  show({onSkin, depthM, widthM}: ProbeView): void {
    if (depthM !== this.depth_m) this.layScale(depthM, widthM);
    this.onSkin = onSkin;
    this.say();
  }

  private layScale(depth_m: number, width_m: number): void {
    this.depth_m = depth_m;
    this.frame.style.aspectRatio = String(width_m / depth_m);
    this.scale.replaceChildren(...marks_mm(depth_m).map((mm) => {
      const mark = made('span', '', `${mm}`);
      mark.style.top = `${mm / (10 * depth_m)}%`;
      return mark;
    }));
  }

  private setCaliper(at_mm: number | undefined): void {
    this.caliper_mm = at_mm;
    this.line.hidden = at_mm === undefined;
    if (at_mm !== undefined) this.line.style.top = `${at_mm / (10 * this.depth_m)}%`;
    this.say();
  }

  private say(): void {
    const at = this.caliper_mm === undefined ? '' : `${this.caliper_mm.toFixed(0)} mm deep`;
    setText(this.said, this.onSkin ? at || 'Depth in mm' : 'Put the probe on the skin');
  }
}
