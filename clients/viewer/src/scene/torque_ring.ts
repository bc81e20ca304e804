import {ConeGeometry, Group, Mesh, MeshBasicMaterial, TorusGeometry, Vector3} from 'three';

import {BALL_RADIUS_M} from './drawn_sizes';

const AXIS = new Vector3(0, 0, 1);
const M_PER_N_M = 0.06;
const LEAST_N_M = 0.005;  // a smaller torque is not felt
const TURN_RAD = 1.5 * Math.PI;
const TUBE = 0.05;  // of the radius

/** Radius of the ring of a torque, outside the device's ball [m]; 0: the torque is not drawn. */
export const ringRadius_m = (torque_N_m: number): number =>
  torque_N_m < LEAST_N_M ? 0 : 1.15 * BALL_RADIUS_M + M_PER_N_M * torque_N_m;

/** Three quarters of a ring with a head, `wider` on all sides. */
function ringOf(color: string, wider: number, renderOrder: number): Mesh[] {
  const material = new MeshBasicMaterial({color, depthTest: false, transparent: true, opacity: 0.95});
  const ring = new Mesh(new TorusGeometry(1, TUBE + wider, 10, 64, TURN_RAD), material);
  const head = new Mesh(new ConeGeometry(3.2 * TUBE + 1.6 * wider, 7 * TUBE + 3.2 * wider, 20), material);
  head.position.set(Math.cos(TURN_RAD), Math.sin(TURN_RAD), 0);
  head.rotation.z = TURN_RAD;  // the cone points along y, which is the tangent at the angle 0
  ring.renderOrder = head.renderOrder = renderOrder;
  return [ring, head];
}

/**
 * A ring around the device's ball and a torque's axis, with a head in the sense of rotation; the larger the torque, the
 * larger the ring. Its dark rim sets it off from skin of any colour.
 */
export class TorqueRing {
  readonly group = new Group();

  constructor() {
    this.group.add(...ringOf('#1d1027', 0.025, 11), ...ringOf('#d98cff', 0, 12));
    this.group.visible = false;
  }

  /** Around the point `at`; hidden without a torque that could be felt. */
  show(at: Vector3 | undefined, torque_N_m: Vector3 | undefined): void {
    const radius_m = ringRadius_m(torque_N_m?.length() ?? 0);
    this.group.visible = at !== undefined && radius_m > 0;
    if (!this.group.visible || at === undefined || torque_N_m === undefined) return;
    this.group.position.copy(at);
    this.group.quaternion.setFromUnitVectors(AXIS, torque_N_m.clone().normalize());
    this.group.scale.setScalar(radius_m);
  }
}
