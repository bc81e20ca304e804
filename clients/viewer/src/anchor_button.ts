import type {HeadsetAnchor} from './mixed/headset_anchor';
import {now_ms} from './link/session_clock';
import {element} from './page/page';
import {saveFile} from './page/save_file';
import type {StationState} from './messages/generated';
import {headsetIsThere} from './scene/headset';
import type {SceneView} from './scene/scene_view';

/**
 * The buttons that anchor the headset to the haptic device. The part that does it is a file of its own, which is loaded
 * with the first press. Returns the anchor's residual [m]; undefined: not anchored.
 */
export function offerAnchor(
    view: SceneView, stationNow: () => StationState | undefined, explain: (problem: string) => void): () => number | undefined {
  const [button, save] = [element('anchor'), element('save-touches')];
  let part: HeadsetAnchor | undefined;
  button.addEventListener('click', () => void begin());
  save.addEventListener('click', () => saveFile('touches.csv', 'text/csv', part?.anchoring.table ?? ''));
  void headsetIsThere().then((there) => (button.hidden = !there));
  return () => (view.headset.isOn ? part?.anchoring.anchor?.rms_m : undefined);

  async function begin(): Promise<void> {
    if (part !== undefined && view.headset.onFrame !== undefined) return part.anchoring.again();
    try {
      // The bundler leaves an address that it cannot read, so that the page does not load this file with the others.
      const file = new URL('mixed.js', import.meta.url).href;
      const mixed = await import(file) as typeof import('./mixed/headset_anchor');
      if (!view.headset.isOn) await view.setHeadset(true);
      const present = view.headset.present;
      if (present === undefined) throw new Error('it has no reference space');
      view.onHeadset(true);
      const settings = mixed.settingsOf(new URLSearchParams(location.search));
      const anchor = new mixed.HeadsetAnchor(present.session, present.space, settings, view.headset, stationNow);
      part = anchor;
      view.headset.onFrame = (frame, space) => anchor.frame(frame, space, now_ms());
      save.hidden = false;
    } catch (problem) {
      explain(`The headset is not anchored: ${String(problem)}. Allow this page to use the headset.`);
    }
  }
}
