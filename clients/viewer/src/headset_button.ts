import {element} from './page/page';
import {headsetIsThere} from './scene/headset';
import type {SceneView} from './scene/scene_view';

/** The button for a headset; it is there when a headset is. */
export async function offerHeadset(view: SceneView, explain: (problem: string) => void): Promise<void> {
  const button = element<HTMLButtonElement>('headset');
  view.onHeadset = (on) => button.setAttribute('aria-pressed', String(on));
  button.addEventListener('click', () => void flip());
  button.hidden = !(await headsetIsThere());

  async function flip(): Promise<void> {
    try {
      await view.setHeadset(!view.headset.isOn);
      view.onHeadset(view.headset.isOn);
    } catch (problem) {
      explain(`The headset shows nothing: ${String(problem)}. Allow this page to use the headset.`);
    }
  }
}
