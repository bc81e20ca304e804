/** What the user asks for: each image by itself, or video, which needs a fraction of the bytes. */
export type ColorCoding = 'pictures' | 'video';

const MISSED_IMAGES = 60;  // depth images without a colour image: two seconds

/**
 * Which of colour's two codings this page takes. Pictures are the default. Without a decoder of video the page stays with
 * them. A recorded session may have video alone: after some depth images without colour the page takes video too.
 */
export class ColorChoice {
  asked: ColorCoding = 'pictures';
  /** Whether this browser decodes video; undefined until it has said so. */
  offered: boolean | undefined;

  private withoutColor = 0;  // depth images since the last colour image

  /** True if this image makes the page take video too. */
  depthCame(): boolean {
    return ++this.withoutColor === MISSED_IMAGES;
  }

  colorCame(): void {
    if (this.withoutColor < MISSED_IMAGES) this.withoutColor = 0;
  }

  restart(): void {
    this.withoutColor = 0;
  }

  get topics(): ('/camera/color' | '/camera/color/video')[] {
    if (this.offered !== true) return ['/camera/color'];
    if (this.asked === 'video') return ['/camera/color/video'];
    return this.withoutColor < MISSED_IMAGES ? ['/camera/color'] : ['/camera/color', '/camera/color/video'];
  }

  /** For the user, in one sentence; empty if there is nothing to say. */
  get said(): string {
    if (this.asked === 'pictures') return '';
    if (this.offered === undefined) return 'This browser is asked whether it decodes video.';
    return this.offered ? 'Colour comes as video (VP8).' :
        'Colour comes as pictures: this browser decodes no video here. It needs https, or a server on this computer.';
  }
}
