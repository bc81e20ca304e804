import {CanvasTexture, DoubleSide, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, SRGBColorSpace, Vector3} from 'three';

import type {ProbeView} from '../present/probe_view';
import {fromCamera} from './frames';

/** The plane under the ultrasound probe with its image, seen through a translucent skin. */
export class ProbePlane {
  private readonly material = new MeshBasicMaterial({color: '#ffffff', side: DoubleSide});
  readonly mesh = new Mesh(new PlaneGeometry(1, 1), this.material);
  private texture: CanvasTexture | undefined;
  private shown = false;
  private known = false;

  constructor() {
    this.mesh.visible = false;
    this.mesh.matrixAutoUpdate = false;
  }

  /** The canvas that holds the newest image. */
  setPicture(canvas: HTMLCanvasElement): void {
    this.texture = new CanvasTexture(canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.material.map = this.texture;
  }

  /** undefined: there is no probe. */
  show(probe: ProbeView | undefined): void {
    const {onSkin = false, face, intoBody, across, widthM = 0, depthM = 0} = probe ?? {};
    this.known = onSkin && face !== undefined && intoBody !== undefined && across !== undefined;
    this.update();
    if (!this.known) return;
    const right = fromCamera(across!);
    const up = fromCamera(intoBody!).negate();
    const middle = fromCamera(face!).addScaledVector(up, -0.5 * depthM);
    this.mesh.matrix.makeBasis(right, up, new Vector3().crossVectors(right, up)).setPosition(middle)
        .multiply(new Matrix4().makeScale(widthM, depthM, 1));
    this.mesh.matrixWorldNeedsUpdate = true;
    if (this.texture !== undefined && this.shown) this.texture.needsUpdate = true;
  }

  setShown(wanted: boolean): void {
    this.shown = wanted;
    if (this.texture !== undefined && wanted) this.texture.needsUpdate = true;
    this.update();
  }

  get isShown(): boolean {
    return this.shown;
  }

  private update(): void {
    this.mesh.visible = this.shown && this.known;
  }
}
