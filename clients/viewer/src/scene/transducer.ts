import {
  BoxGeometry, CylinderGeometry, Group, Matrix4, Mesh, MeshPhongMaterial, Quaternion, SphereGeometry, Vector3,
} from 'three';

const FACE_M = {length: 0.062, thickness: 0.014};
/** The probe's axes (x along the face, y away from the body) from the hand's: y out of the back of the hand. */
const HAND_FROM_PROBE = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), Math.PI / 2);

/** Attitude of a probe that stands upright on skin with the unit normal `normal`, its face along the picture's rows. */
export function uprightOn(normal: Vector3): Quaternion {
  const along = new Vector3(1, 0, 0).addScaledVector(normal, -normal.x);
  if (along.lengthSq() < 1e-6) along.set(0, 0, 1).addScaledVector(normal, -normal.z);
  along.normalize();
  return new Quaternion().setFromRotationMatrix(
      new Matrix4().makeBasis(along, normal, new Vector3().crossVectors(along, normal)));
}

/** The attitude of a probe in a hand with the attitude `hand`. */
export const inHand = (hand: Quaternion): Quaternion => hand.clone().multiply(HAND_FROM_PROBE);

/** A linear ultrasound probe, drawn instead of the hand while the station's scene has one. */
export class Transducer {
  readonly group = new Group();
  private held = false;
  private shown = true;
  private known = false;

  constructor() {
    const shell = new MeshPhongMaterial({color: '#dfe5ea', specular: '#555555', shininess: 40});
    const lens = new MeshPhongMaterial({color: '#39424c', specular: '#222222', shininess: 10});
    const mark = new MeshPhongMaterial({color: '#35d07f', emissive: '#0c5c32'});
    const face = new Mesh(new BoxGeometry(FACE_M.length, 0.006, FACE_M.thickness), lens);
    face.position.y = 0.003;
    const head = new Mesh(new BoxGeometry(FACE_M.length + 0.006, 0.026, FACE_M.thickness + 0.006), shell);
    head.position.y = 0.019;
    const neck = new Mesh(new CylinderGeometry(0.017, 0.034, 0.03, 32), shell);
    neck.position.y = 0.047;
    neck.scale.z = 0.42;
    const grip = new Mesh(new CylinderGeometry(0.016, 0.017, 0.06, 32), shell);
    grip.position.y = 0.092;
    grip.scale.z = 0.62;
    const cable = new Mesh(new CylinderGeometry(0.004, 0.005, 0.05, 16), lens);
    cable.position.y = 0.146;
    const side = new Mesh(new SphereGeometry(0.0035, 16, 12), mark);  // on the image's left, as on its panel
    side.position.set(-FACE_M.length / 2 + 0.004, 0.024, FACE_M.thickness / 2 + 0.003);
    this.group.add(face, head, neck, grip, cable, side);
    this.group.visible = false;
  }

  /** `at`: where its face is; undefined: the station has no hand. `attitude`: of the hand; `normal`: of the skin. */
  show(at: Vector3 | undefined, attitude: Quaternion | undefined, normal: Vector3 | undefined): void {
    this.known = at !== undefined;
    if (at !== undefined) this.group.position.copy(at);
    this.group.quaternion.copy(attitude === undefined ? uprightOn(normal ?? new Vector3(0, 0, 1)) : inHand(attitude));
    this.update();
  }

  /** Whether the station's tool is a probe. */
  setHeld(held: boolean): void {
    this.held = held;
    this.update();
  }

  get isHeld(): boolean {
    return this.held;
  }

  setShown(wanted: boolean): void {
    this.shown = wanted;
    this.update();
  }

  private update(): void {
    this.group.visible = this.held && this.shown && this.known;
  }
}
