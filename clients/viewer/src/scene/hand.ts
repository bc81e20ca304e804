import {Color, Mesh, MeshPhongMaterial, Quaternion, type Vector3} from 'three';

import {handGeometry} from './hand_shape';

const CALM = new Color('#e8c9b4');
const DEEPEST = new Color('#d4142a');
/** The indentation at which the hand is fully red: the depth for which S1 III.A states forces. */
const ALL_RED_M = 0.06;
const PALM_DOWN = new Quaternion();
/** The detail of the shape. Without a graphics card, 5 mm instead of 3 mm save 9 ms of processor time a picture. */
const CELL_MM = {card: 3, software: 5};

/**
 * S1 II.E: an avatar of the doctor's hand, at the displayed hand position, whose colour shifts gradually to red the
 * deeper the end-effector is inside the surface. It has the tracked attitude, or lies palm down with the fingers up the
 * picture while the tracker tells none.
 */
export class Hand {
  private readonly material = new MeshPhongMaterial(
      {color: CALM, specular: '#1a1512', shininess: 18, vertexColors: true, transparent: true});
  readonly mesh = new Mesh(undefined, this.material);  // without a shape until a hand is shown

  private known = false;
  private shown = true;  // as the user has set it
  private shaped = false;

  /** `software`: the browser has no graphics card. */
  constructor(private readonly software: boolean) {
    this.mesh.visible = false;
  }

  /** `at` undefined: the station has no hand, and none is drawn. */
  show(at: Vector3 | undefined, attitude: Quaternion | undefined, indentation_m: number): void {
    if (at !== undefined) this.shape();
    if (at !== undefined) this.mesh.position.copy(at);
    this.mesh.quaternion.copy(attitude ?? PALM_DOWN);
    this.known = at !== undefined;
    this.mesh.visible = this.known && this.shown;
    const red = Math.min(1, Math.max(0, indentation_m / ALL_RED_M));
    this.material.color.copy(CALM).lerp(DEEPEST, red);
    this.material.emissive.copy(DEEPEST).multiplyScalar(0.25 * red);
  }

  /** Makes the shape once: this takes 0.1 s, which the patient's first picture does not wait for. */
  private shape(): void {
    if (!this.shaped) this.mesh.geometry = handGeometry(this.software ? CELL_MM.software : CELL_MM.card);
    this.shaped = true;
  }

  setShown(wanted: boolean): void {
    this.shown = wanted;
    this.mesh.visible = this.known && wanted;
  }
}
