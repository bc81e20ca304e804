import type {UltrasoundImage} from '../messages/generated';
import type {ProbeView} from '../present/probe_view';

/**
 * Draws the images of the ultrasound probe as they come, and gives the page the newest one's pose when it asks. An image
 * is left out if the next one comes while the last one is decoded.
 */
export class ProbeImages {
  private waiting: UltrasoundImage | undefined;
  private busy = false;
  private asked = false;
  private newest: ProbeView | undefined;  // undefined: the page has it
  private drawn = 0;

  /**
   * `decode`: a JPEG to a bitmap; undefined if it is damaged. `draw`: shows a bitmap, or black for undefined. `answer`:
   * gives the page the pose that it asked for.
   */
  constructor(
      private readonly decode: (jpeg: Uint8Array) => Promise<ImageBitmap | undefined>,
      private readonly draw: (image: ImageBitmap | undefined) => void,
      private readonly answer: (view: ProbeView) => void) {}

  came(image: UltrasoundImage): void {
    this.waiting = image;
    if (!this.busy) void this.drawAll();
  }

  ask(): void {
    this.asked = true;
    this.serve();
  }

  private async drawAll(): Promise<void> {
    this.busy = true;
    for (let image = this.next(); image !== undefined; image = this.next()) {
      const bitmap = image.onSkin ? await this.decode(image.jpeg) : undefined;
      this.draw(bitmap);
      if (bitmap !== undefined) ++this.drawn;
      const {stampNs, widthM, depthM, faceCamera: face, intoBodyCamera: intoBody, acrossCamera: across} = image;
      this.newest = {stampNs, widthM, depthM, onSkin: bitmap !== undefined, drawn: this.drawn, face, intoBody, across};
      this.serve();
    }
    this.busy = false;
  }

  private next(): UltrasoundImage | undefined {
    const image = this.waiting;
    this.waiting = undefined;
    return image;
  }

  private serve(): void {
    if (!this.asked || this.newest === undefined) return;
    const view = this.newest;
    this.asked = false;
    this.newest = undefined;
    this.answer(view);
  }
}
