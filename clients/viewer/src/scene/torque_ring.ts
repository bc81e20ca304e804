import {ConeGeometry, Group, Mesh, MeshBasicMaterial, TorusGeometry, Vector3} from 'three';

const AXIS = new Vector3(0, 0, 1);
const M_PER_N_M = 0.1;
const LEAST_M = 0.003;  // a smaller ring could not be told from a dot
const TURN_RAD = 1.5 * Math.PI;

/** Three quarters of a ring around a torque's axis, with a head in the sense of rotation. Its radius is the torque. */
export class TorqueRing {
  readonly group = new Group();

  constructor() {
    const material = new MeshBasicMaterial({color: '#e6a5ff', depthTest: false, transparent: true, opacity: 0.95});
    const ring = new Mesh(new TorusGeometry(1, 0.07, 10, 48, TURN_RAD), material);
    const head = new Mesh(new ConeGeometry(0.22, 0.44, 20), material);
    head.position.set(Math.cos(TURN_RAD), Math.sin(TURN_RAD), 0);
    head.rotation.z = TURN_RAD;  // the cone points along y, which is the tangent at the angle 0
    ring.renderOrder = head.renderOrder = 11;
    this.group.add(ring, head);
    this.group.visible = false;
  }

  /** Around the point `at`; hidden without a torque that could be seen. */
  show(at: Vector3 | undefined, torque_N_m: Vector3 | undefined): void {
    const radius_m = M_PER_N_M * (torque_N_m?.length() ?? 0);
    this.group.visible = at !== undefined && radius_m > LEAST_M;
    if (!this.group.visible || at === undefined || torque_N_m === undefined) return;
    this.group.position.copy(at);
    this.group.quaternion.setFromUnitVectors(AXIS, torque_N_m.clone().normalize());
    this.group.scale.setScalar(radius_m);
  }
}
