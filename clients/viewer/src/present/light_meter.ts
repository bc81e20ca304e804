import type {Light} from './instant';

const EVERY_MS = 1000;
const [WIDTH, HEIGHT] = [64, 48];  // the picture is reduced to this: the mean needs no more
const WHITE = 250;

/** Measures the brightness of a colour picture, once a second. */
export class LightMeter {
  light: Light | undefined;
  private measured_ms = -Infinity;
  private readonly context = new OffscreenCanvas(WIDTH, HEIGHT).getContext('2d', {willReadFrequently: true});

  measure(picture: ImageBitmap, now_ms: number): void {
    if (this.context === null || now_ms - this.measured_ms < EVERY_MS) return;
    this.measured_ms = now_ms;
    this.context.drawImage(picture, 0, 0, WIDTH, HEIGHT);
    this.light = lightOf(this.context.getImageData(0, 0, WIDTH, HEIGHT).data);
  }
}

/** The brightness of pixels in RGBA, by Rec. 709. */
export function lightOf(rgba: Uint8ClampedArray): Light {
  let [sum, white] = [0, 0];
  for (let at = 0; at + 3 < rgba.length; at += 4) {
    const luminance = 0.2126 * rgba[at]! + 0.7152 * rgba[at + 1]! + 0.0722 * rgba[at + 2]!;
    sum += luminance;
    if (luminance >= WHITE) ++white;
  }
  const pixels = Math.max(1, rgba.length / 4);
  return {mean: sum / pixels, clipped: white / pixels};
}
