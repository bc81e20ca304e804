import type {ProbeView, UltrasoundImage} from './inside_messages';

/**
 * The newest image of the ultrasound probe, for a page that asks for one at a time: an image that is not asked for
 * before the next one comes is not decoded.
 */
export class ProbeImages {
  private waiting: UltrasoundImage | undefined;
  private asked = false;

  /** `decode`: a JPEG to a bitmap; undefined if it is damaged. `answer`: gives the page the image that it asked for. */
  constructor(
      private readonly decode: (jpeg: Uint8Array) => Promise<ImageBitmap | undefined>,
      private readonly answer: (view: ProbeView) => void) {}

  came(image: UltrasoundImage): void {
    this.waiting = image;
    void this.serve();
  }

  ask(): void {
    this.asked = true;
    void this.serve();
  }

  private async serve(): Promise<void> {
    const image = this.waiting;
    if (!this.asked || image === undefined) return;
    this.asked = false;
    this.waiting = undefined;
    const {stampNs, widthM, depthM, faceCamera: face, intoBodyCamera: intoBody, acrossCamera: across} = image;
    const bitmap = image.onSkin ? await this.decode(image.jpeg) : undefined;
    this.answer({stampNs, widthM, depthM, image: bitmap, face, intoBody, across});
  }
}
