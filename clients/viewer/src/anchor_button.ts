import type {HeadsetAnchor} from './mixed/headset_anchor';
import {now_ms} from './link/session_clock';
import {element, later} from './page/page';
import {saveFile} from './page/save_file';
import type {StationState} from './messages/generated';
import {headsetIsThere} from './scene/headset';
import type {SceneView} from './scene/scene_view';

/**
 * The button *Anchor*, which anchors the headset to the haptic device, and the button *Touches*, which saves the touches.
 * Their code (mixed/) is a file of its own, loaded at the first press of *Anchor*. Returns a function that gives how many
 * touches are taken, and the anchor's residual [m]; undefined: not anchored.
 */
export function offerAnchor(
    view: SceneView, stationNow: () => StationState | undefined, explain: (problem: string) => void,
): () => {touches: number; rms_m: number | undefined} {
  const [button, save] = [element('anchor'), element('save-touches')];
  let anchor: HeadsetAnchor | undefined;
  button.addEventListener('click', () => void begin());
  save.addEventListener('click', () => saveFile('touches.csv', 'text/csv', anchor?.anchoring.table ?? ''));
  void headsetIsThere().then((there) => (button.hidden = !there));
  return () => {
    const now = view.headset.isOn ? anchor?.anchoring : undefined;
    return {touches: now?.taken ?? 0, rms_m: now?.anchor?.rms_m};
  };

  async function begin(): Promise<void> {
    if (anchor !== undefined && view.headset.onFrame !== undefined) return anchor.anchoring.again();
    try {
      const mixed = await later<typeof import('./mixed/headset_anchor')>('mixed.js');
      if (!view.headset.isOn) await view.setHeadset(true);
      const present = view.headset.present;
      if (present === undefined) throw new Error('it has no reference space');
      view.onHeadset(true);
      const settings = mixed.settingsOf(new URLSearchParams(location.search));
      const begun = new mixed.HeadsetAnchor(present.session, present.space, settings, view.headset, stationNow);
      anchor = begun;
      view.headset.onFrame = (frame) => begun.frame(frame, now_ms());
      save.hidden = false;
    } catch (problem) {
      explain(`The headset is not anchored: ${String(problem)}. Allow this page to use the headset.`);
    }
  }
}
