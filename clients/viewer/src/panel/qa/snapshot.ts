const LEAST_TEXT_PX = 13;
const LINE = 1.5;  // height of a line, in heights of the text

/** The picture with lines of text below it, as PNG; undefined if the browser cannot. The picture keeps its size. */
export function withText(picture: HTMLCanvasElement, lines: readonly string[]): Promise<Blob | undefined> {
  const canvas = document.createElement('canvas');
  const pen = canvas.getContext('2d');
  if (pen === null) return Promise.resolve(undefined);
  const font = (px: number) => `${px}px system-ui, sans-serif`;
  let text_px = Math.max(LEAST_TEXT_PX, Math.round(picture.width / 70));
  pen.font = font(text_px);
  const widest = Math.max(...lines.map((line) => pen.measureText(line).width)) + 2 * text_px;
  text_px *= Math.min(1, picture.width / widest);
  canvas.width = picture.width;
  canvas.height = picture.height + Math.ceil((lines.length * LINE + 0.7) * text_px);
  pen.fillStyle = '#070b10';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(picture, 0, 0);
  pen.font = font(text_px);
  pen.fillStyle = '#eaf1f8';
  lines.forEach((line, at) => pen.fillText(line, text_px, picture.height + (at * LINE + 1.35) * text_px));
  return new Promise((resolve) => canvas.toBlob((png) => resolve(png ?? undefined), 'image/png'));
}
