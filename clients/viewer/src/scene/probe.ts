import {
  BufferGeometry,
  type Color,
  GreaterDepth,
  Group,
  Line,
  LineDashedMaterial,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  SphereGeometry,
  type Vector3,
} from 'three';

import {Arrow} from './arrow';
import {ARROW_M_PER_N, BALL_RADIUS_M} from './drawn_sizes';
import {TorqueRing} from './torque_ring';

const NORMAL_M = 0.045;

export interface ProbePlace {
  device: Vector3 | undefined;
  proxy: Vector3 | undefined;
  normal: Vector3 | undefined;
  force_N: Vector3 | undefined;  // of the contact; undefined while the device is driven
  torque_N_m: Vector3 | undefined;  // about the device; undefined: it gives none
}

/** The device's ball, the proxy on the surface, the line between them, the surface's normal, the force and the torque. */
export class Probe {
  readonly group = new Group();
  private readonly ball = new Group();
  private readonly proxy = new Mesh(
      new SphereGeometry(0.0045, 24, 16), new MeshBasicMaterial({color: '#ffffff', depthTest: false}));
  private readonly between = new Line(
      new BufferGeometry(),
      new LineDashedMaterial({color: '#ffffff', dashSize: 0.004, gapSize: 0.003, depthTest: false, transparent: true,
                              opacity: 0.8}));
  private readonly normal = new Arrow('#63c7ff', 0.0011);
  private readonly force = new Arrow('#4fd6a5', 0.0034);
  private readonly torque = new TorqueRing();

  constructor() {
    const shape = new SphereGeometry(BALL_RADIUS_M, 48, 32);
    const glass = new MeshPhongMaterial(
        {color: '#8fb4d9', specular: '#9fb6cc', shininess: 60, transparent: true, opacity: 0.5});
    // The part of the ball below the skin shows through faintly, so that the user sees how deep the device is.
    const hidden = new MeshBasicMaterial(
        {color: '#8fc4ff', transparent: true, opacity: 0.2, depthFunc: GreaterDepth, depthWrite: false});
    const seen = new Mesh(shape, glass);
    const through = new Mesh(shape, hidden);
    seen.renderOrder = 2;
    through.renderOrder = 1;
    this.ball.add(seen, through);
    this.proxy.renderOrder = 12;
    this.between.renderOrder = 9;
    this.group.add(this.ball, this.proxy, this.between, this.normal.group, this.force.group, this.torque.group);
    this.group.visible = false;
  }

  show({device, proxy, normal, force_N, torque_N_m}: ProbePlace, forceColor: Color): void {
    this.group.visible = true;
    this.ball.visible = device !== undefined;
    this.proxy.visible = proxy !== undefined;
    if (device !== undefined) this.ball.position.copy(device);
    if (proxy !== undefined) this.proxy.position.copy(proxy);
    this.between.visible = device !== undefined && proxy !== undefined;
    if (device !== undefined && proxy !== undefined) {
      this.between.geometry.setFromPoints([proxy, device]);
      this.between.computeLineDistances();
    }
    this.normal.show(proxy, normal?.clone().multiplyScalar(NORMAL_M));
    this.force.show(proxy, force_N?.clone().multiplyScalar(ARROW_M_PER_N), forceColor);
    this.torque.show(device, torque_N_m);
  }

  hide(): void {
    this.group.visible = false;
  }

  setBallVisible(wanted: boolean): void {
    this.ball.traverse((part) => part.layers.set(wanted ? 0 : 31));
  }

  setForcesVisible(wanted: boolean): void {
    for (const part of [this.force.group, this.torque.group, this.normal.group, this.proxy, this.between])
      part.traverse((child) => child.layers.set(wanted ? 0 : 31));
  }
}
