/** A canvas of the page that a worker draws, so that a page that is busy with its 3D view does not delay it. */
export class WorkerCanvas {
  private readonly context: OffscreenCanvasRenderingContext2D | null;

  constructor(private readonly canvas: OffscreenCanvas) {
    // Kept in memory, not on the graphics card: a card that is busy with the 3D view does not delay it either. With an
    // alpha channel: below an opaque canvas, Chromium without a graphics card leaves a white hole in the 3D view.
    this.context = canvas.getContext('2d', {willReadFrequently: true});
  }

  /** Shows the image and closes it; undefined shows black. */
  draw(image: ImageBitmap | undefined): void {
    const {canvas, context} = this;
    if (image === undefined) {
      context?.fillRect(0, 0, canvas.width, canvas.height);
      return;
    }
    if (canvas.width !== image.width || canvas.height !== image.height)
      [canvas.width, canvas.height] = [image.width, image.height];
    context?.drawImage(image, 0, 0);
    image.close();
  }
}
