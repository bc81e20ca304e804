/** How colour is coded: each image by itself (JPEG), or as video (VP8), which needs a fraction of the bytes. */
export type ColorCoding = 'pictures' | 'video';

const MISSED_IMAGES = 60;  // so many depth images without a colour image, two seconds, and the page takes both codings

/**
 * Which of colour's two codings this page takes. Pictures are the default, and the only one in a browser that decodes no
 * video. A recorded session may have one coding alone: if the coding asked for does not come, the page takes both.
 */
export class ColorChoice {
  asked: ColorCoding = 'pictures';  // by the user
  /** Whether this browser decodes video; undefined until it has said so. */
  offered: boolean | undefined;

  private withoutColor = 0;  // depth images since the last colour image

  /** True if the page takes both codings from this depth image on. */
  depthCame(): boolean {
    return ++this.withoutColor === MISSED_IMAGES;
  }

  colorCame(): void {
    if (!this.misses) this.withoutColor = 0;
  }

  /** A new connection, or another coding asked for: the page takes one coding again, and counts from zero. */
  restart(): void {
    this.withoutColor = 0;
  }

  get topics(): ('/camera/color' | '/camera/color/video')[] {
    if (this.offered !== true) return ['/camera/color'];
    if (this.misses) return ['/camera/color', '/camera/color/video'];
    return [this.asked === 'video' ? '/camera/color/video' : '/camera/color'];
  }

  /** For the user, in one sentence; empty if there is nothing to say. */
  get said(): string {
    if (this.asked === 'pictures') return '';
    if (this.offered === undefined) return 'Colour comes as pictures until this browser has said whether it decodes video.';
    if (!this.offered) return 'Colour comes as pictures: this browser decodes no video here. It needs https, or a server on this computer.';
    return this.misses ? 'No video came for two seconds: pictures are taken, too.' : 'Colour comes as video (VP8).';
  }

  private get misses(): boolean {
    return this.withoutColor >= MISSED_IMAGES;
  }
}
