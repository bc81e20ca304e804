import {element} from '../../page/page';
import type {Touch} from '../../calibration/offset_fit';
import type {SceneView} from '../../scene/scene_view';
import type {Reading} from '../../state/viewer_state';
import {RowList} from '../../page/rows';
import {CalibrationCard} from './calibration_card';
import {DepthRange} from './depth_range';
import {type CameraExposure, ExposureCard} from './exposure_card';
import {NetworkRates, subscriberRows} from './network_rows';
import {pictureRows} from './picture_problems';
import {PointReadout} from './point_readout';
import {RecordingCard} from './recording_card';
import type {Recording} from './recording_state';
import {type Source, SourceCard} from './source_card';

/**
 * The technician's cards but those of later_cards.ts: the source and its exposure, picture quality, depth under the pointer,
 * depth range and histogram, calibration, recording, network.
 */
export class TechnicianPanel {
  private readonly picture = new RowList(element('picture-problems'));
  private readonly network = new RowList(element('network'));
  private readonly subscribers = new RowList(element('subscribers'));
  private readonly rates = new NetworkRates();
  private readonly recording: RecordingCard;
  private readonly range: DepthRange;
  private readonly point: PointReadout;

  private readonly calibration: CalibrationCard;

  constructor(
      view: SceneView, canvas: HTMLCanvasElement, parts: {recording: Recording; source: Source; exposure: CameraExposure},
      takePlace: (place: number | undefined) => void) {
    this.recording = new RecordingCard(parts.recording);
    new SourceCard(parts.source);
    new ExposureCard(parts.exposure);
    this.calibration = new CalibrationCard(takePlace);
    this.range = new DepthRange(view);
    this.point = new PointReadout(view, canvas);
  }

  /** The touches of a place of the calibration have come. */
  addTouches(touches: readonly Touch[]): void {
    this.calibration.add(touches);
  }

  show({summary, light, capture, cameraFrames_per_s, presence, role, taking}: Reading): void {
    if (summary !== undefined) {
      const plays = capture?.source.startsWith('session:') ?? false;
      this.picture.show(pictureRows(summary, light, plays ? undefined : cameraFrames_per_s));
      this.range.show(summary);
    }
    this.point.show();
    this.calibration.show(taking);
    this.recording.show(role);
    this.network.show(this.rates.show(presence.stats));
    this.subscribers.show(subscriberRows(presence.stats));
  }
}
