import {element} from '../page/page';
import type {InnerStructures} from '../messages/generated';
import type {ProbeView} from '../present/probe_view';
import type {SceneView} from '../scene/scene_view';
import {UltrasoundPanel} from './ultrasound_panel';

const PROBE_GONE_MS = 2000;  // without an image for this long, the station has no probe any more

/** What lies under the skin: the ultrasound panel, the probe and its image plane in the scene, the scene's layers. */
export class InsideView {
  private readonly panel = new UltrasoundPanel();
  private readonly card = element('ultrasound');
  private readonly panelButton = element<HTMLButtonElement>('show-ultrasound');
  private readonly skinButton = element<HTMLButtonElement>('show-inside');
  private panelWanted = true;
  private probeHeard_ms = -Infinity;
  private images = 0;

  /** `askNext`: asks for the pose of the next image. `drawInWorker`: gives a canvas to the worker that draws the images. */
  constructor(
      private readonly view: SceneView, private readonly askNext: () => void,
      drawInWorker: (canvas: OffscreenCanvas) => void) {
    view.probePlane.setPicture(this.panel.canvas);
    drawInWorker(this.panel.canvas.transferControlToOffscreen());
  }

  /** Number of images drawn since the page was opened. */
  get imagesShown(): number {
    return this.images;
  }

  showProbe(probe: ProbeView, now_ms: number): void {
    this.probeHeard_ms = now_ms;
    this.images = probe.drawn;
    this.panel.show(probe);
    this.view.probePlane.show(probe);
    if (this.view.probePlane.isShown) this.view.invalidate();
    this.askNext();
  }

  showStructures(inside: InnerStructures): void {
    this.view.inner.show(inside);
    this.skinButton.hidden = inside.structures.length === 0;
    this.view.invalidate();
  }

  /** Draws the skin translucent and the layers below it, or the skin alone. */
  setTransparent(wanted: boolean): void {
    this.view.surface.setOpacity(wanted ? 0.45 : 1);
    this.view.inner.setShown(wanted);
    this.view.probePlane.setShown(wanted);
  }

  setPanelShown(wanted: boolean): void {
    this.panelWanted = wanted;
    this.look(performance.now());
  }

  /** Shows the panel and the probe while the station has one. Called ten times a second. */
  look(now_ms: number): void {
    const there = now_ms - this.probeHeard_ms < PROBE_GONE_MS;
    this.panelButton.hidden = !there;
    this.card.hidden = !there || !this.panelWanted;
    this.view.transducer.setHeld(there);
    if (!there) this.view.probePlane.show(undefined);
  }
}
