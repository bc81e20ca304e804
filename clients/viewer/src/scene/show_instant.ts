import type {StationCompensation, StationState} from '../messages/generated';
import {forcesOf, type Instant, type Picture} from '../present/instant';
import {shownHand} from '../present/shown_hand';
import {forceColor, FULL_SCALE_N} from './force_color';
import {fromCamera, rotationFromCamera} from './frames';
import type {SceneView} from './scene_view';

/** Puts picture, hand and force of one instant into the scene, to be drawn together. */
export function showInstant(view: SceneView, {picture, station, hand, compensation}: Instant): void {
  if (picture !== undefined) showPicture(view, picture);
  if (hand === 'none') hideStation(view);
  else if (hand === 'new' && station !== undefined) showStation(view, station, compensation);
  view.invalidate();
}

function showPicture(view: SceneView, {frame, summary, color, cameraMatrix}: Picture): void {
  view.surface.showDepth(frame, summary, cameraMatrix);
  view.pointed.follow((place) => view.surface.depthBehind(place));
  if (color !== undefined) view.surface.showPicture(color);
  view.setHome(summary);
}

function hideStation({hand, transducer, probe, halo, surface}: SceneView): void {
  hand.show(undefined, undefined, 0);
  transducer.show(undefined, undefined, undefined);
  probe.hide();
  halo.show(undefined);
  surface.setTouch(undefined, 0, forceColor(0));
}

function showStation(
    {hand, transducer, inner, probe, halo, surface}: SceneView, station: StationState, compensation: StationCompensation | undefined): void {
  const {force_N, drive_N} = forcesOf(station);
  const color = forceColor(force_N);
  const proxy = station.proxyCamera && fromCamera(station.proxyCamera);
  const at = shownHand(station);
  const attitude = station.handAttitudeCamera && rotationFromCamera(station.handAttitudeCamera);
  const normal = station.normalCamera && fromCamera(station.normalCamera);
  hand.show(transducer.isHeld ? undefined : at && fromCamera(at), attitude, station.indentationM);
  transducer.show(at && (station.inBody && proxy !== undefined ? proxy : fromCamera(at)), attitude, normal);
  if (compensation !== undefined) inner.move(compensation.objects);
  probe.show(
      {
        device: station.deviceCamera && fromCamera(station.deviceCamera),
        proxy,
        normal,
        torque_N_m: station.torqueCameraNM && fromCamera(station.torqueCameraNM),
        force_N: drive_N === 0 && station.forceCameraN ? fromCamera(station.forceCameraN) : undefined,
      },
      color);
  halo.show(compensation && {
    hand: at && fromCamera(at),
    hand_sigma_m: compensation.handSigmaM,
    proxy: station.inBody ? proxy : undefined,
    normal,
    surface_sigma_m: compensation.surfaceSigmaM,
  });
  surface.setTouch(proxy, station.inBody ? 0.35 + 0.65 * Math.min(1, force_N / FULL_SCALE_N) : 0, color);
}
