import {element} from '../../page';
import type {SceneView} from '../../scene/scene_view';
import type {Reading} from '../../viewer_state';
import {RowList} from '../rows';
import {DepthRange} from './depth_range';
import {NetworkRates, subscriberRows} from './network_rows';
import {pictureRows} from './picture_problems';
import {PointReadout} from './point_readout';
import {RecordingCard} from './recording_card';

/** The technician's cards: picture quality, depth under the pointer, depth range and histogram, recording, network. */
export class TechnicianPanel {
  private readonly picture = new RowList(element('picture-problems'));
  private readonly network = new RowList(element('network'));
  private readonly subscribers = new RowList(element('subscribers'));
  private readonly rates = new NetworkRates();
  private readonly recording = new RecordingCard();
  private readonly range: DepthRange;
  private readonly point: PointReadout;

  constructor(view: SceneView, canvas: HTMLCanvasElement) {
    this.range = new DepthRange(view);
    this.point = new PointReadout(view, canvas);
  }

  show({summary, light, cameraFrames_per_s, presence, connected, role}: Reading): void {
    if (summary !== undefined) {
      this.picture.show(pictureRows(summary, light, cameraFrames_per_s));
      this.range.show(summary);
    }
    this.point.show();
    this.recording.show(connected, role);
    this.network.show(this.rates.show(presence.stats));
    this.subscribers.show(subscriberRows(presence.stats));
  }
}
