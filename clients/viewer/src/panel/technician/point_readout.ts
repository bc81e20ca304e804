import {element, setText} from '../../page/page';
import type {SceneView} from '../../scene/scene_view';

/** The measured depth of the pixel under the pointer. */
export class PointReadout {
  private pointer: {x: number; y: number} | undefined;
  private readonly text = element('point-depth');

  constructor(private readonly view: SceneView, canvas: HTMLCanvasElement) {
    canvas.addEventListener('pointermove', ({clientX, clientY}) => (this.pointer = {x: clientX, y: clientY}));
    canvas.addEventListener('pointerleave', () => (this.pointer = undefined));
  }

  show(): void {
    const at = this.pointer && this.view.pixelUnder(this.pointer.x, this.pointer.y);
    setText(this.text, this.pointer === undefined ? 'Point at the picture' :
      at === undefined ? 'no surface here' :
      `pixel ${at.column}, ${at.row}: ${at.depth_m.toFixed(3)} m`);
  }
}
