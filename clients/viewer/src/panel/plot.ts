interface Sample {
  at_s: number;
  value: number;
}

export interface PlotStyle {
  color: string;
  unit: string;
  /** Least top of the scale; the scale grows in steps when a value exceeds it. */
  least: number;
  step: number;
}

const WINDOW_S = 15;

/** The last seconds of one value, drawn on a canvas. The time axis is the station's time, so a pause shows as a gap. */
export class Plot {
  private readonly samples: Sample[] = [];
  private readonly context: CanvasRenderingContext2D;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly style: PlotStyle) {
    const context = canvas.getContext('2d');
    if (context === null) throw new Error('this browser draws no canvas');
    this.context = context;
  }

  add(at_s: number, value: number): void {
    const last = this.samples[this.samples.length - 1];
    if (last !== undefined && at_s < last.at_s) this.samples.length = 0;  // the station was restarted
    this.samples.push({at_s, value});
    while (this.samples[0] !== undefined && this.samples[0].at_s < at_s - WINDOW_S) this.samples.shift();
  }

  draw(): void {
    const ratio = Math.min(window.devicePixelRatio, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (width === 0) return;
    if (this.canvas.width !== Math.round(width * ratio)) this.canvas.width = Math.round(width * ratio);
    if (this.canvas.height !== Math.round(height * ratio)) this.canvas.height = Math.round(height * ratio);
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, width, height);
    const highest = this.samples.reduce((most, sample) => Math.max(most, sample.value), this.style.least);
    const top = Math.ceil(highest / this.style.step) * this.style.step;
    this.drawScale(width, height, top);
    this.drawCurve(width, height, top);
  }

  private drawScale(width: number, height: number, top: number): void {
    const {context} = this;
    context.font = '10px system-ui, sans-serif';
    context.textBaseline = 'bottom';
    for (const share of [0, 0.5, 1]) {
      const y = height - 1 - share * (height - 14);
      context.fillStyle = 'rgba(148, 170, 192, 0.16)';
      context.fillRect(0, y, width, 1);
      context.fillStyle = '#8ea1b4';
      context.fillText(`${top * share} ${share === 1 ? this.style.unit : ''}`, 2, y - 1);
    }
  }

  private drawCurve(width: number, height: number, top: number): void {
    const end_s = this.samples[this.samples.length - 1]?.at_s;
    if (end_s === undefined) return;
    const {context} = this;
    const curve = new Path2D();
    let before_s = -Infinity;
    for (const {at_s, value} of this.samples) {
      const x = width * (1 - (end_s - at_s) / WINDOW_S);
      const y = height - 1 - (Math.max(0, value) / top) * (height - 14);
      if (at_s - before_s > 0.3) curve.moveTo(x, y);
      else curve.lineTo(x, y);
      before_s = at_s;
    }
    context.strokeStyle = this.style.color;
    context.lineWidth = 1.75;
    context.lineJoin = 'round';
    context.stroke(curve);
    context.lineWidth = 6;
    context.globalAlpha = 0.13;
    context.stroke(curve);
    context.globalAlpha = 1;
  }
}
