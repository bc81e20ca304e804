/** True when the browser draws without a graphics card, where each sample of a pixel costs much time. */
export function drawsInSoftware(): boolean {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) return false;  // nothing can be drawn; the renderer reports this
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(gl.getParameter(names === null ? gl.RENDERER : names.UNMASKED_RENDERER_WEBGL));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
}

/** A context without the features that cost a software renderer time: antialiasing, a transparent canvas, a stencil. */
export function plainContext(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const context = canvas.getContext('webgl2', {alpha: false, antialias: false, stencil: false});
  if (context === null) throw new Error('this browser has no WebGL 2');
  return context;
}
