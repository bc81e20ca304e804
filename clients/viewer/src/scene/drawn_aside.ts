import {SRGBColorSpace, type WebGLRenderer, WebGLRenderTarget} from 'three';

/**
 * A picture that is drawn beside the canvas and copied into it once it is finished. Without a graphics card, the browser
 * reads the canvas back whenever the page has drawn into it, and the page waits until that is done. It then waits for
 * a short copy, and not for the whole drawing.
 */
export class DrawnAside {
  private readonly target = new WebGLRenderTarget(2, 2);

  constructor(private readonly renderer: WebGLRenderer) {
    this.target.texture.colorSpace = SRGBColorSpace;
    this.target.texture.internalFormat = 'RGBA8';
    Object.assign(this.target, {isXRRenderTarget: true});  // three then encodes colours as for the canvas
  }

  /** What is drawn next is drawn aside, in a picture of this size [pixels]. */
  begin(width: number, height: number): void {
    this.target.setSize(width, height);
    this.renderer.setRenderTarget(this.target);
  }

  /** What is drawn next is drawn into the canvas again. */
  end(): void {
    this.renderer.setRenderTarget(null);
  }

  /** Copies the picture into the canvas, which has its size. */
  copyToCanvas(): void {
    const {renderer, target: {width, height}} = this;
    const gl = renderer.getContext() as WebGL2RenderingContext;
    const {__webglFramebuffer: aside} = renderer.properties.get(this.target) as {__webglFramebuffer?: WebGLFramebuffer};
    if (aside === undefined) return;  // the graphics context was lost meanwhile
    renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, aside);
    renderer.state.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    renderer.state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  }
}
