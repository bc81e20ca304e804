import {BackSide, CylinderGeometry, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3} from 'three';

const UP = new Vector3(0, 1, 0);
const LEAST_M = 0.001;      // thinner than this, nothing is to be seen
const BAR_RADIUS_M = 0.0022;
const SIGMAS = 2;

export interface Uncertainty {
  hand: Vector3 | undefined;
  hand_sigma_m: number;
  proxy: Vector3 | undefined;
  normal: Vector3 | undefined;
  surface_sigma_m: number;
}

/**
 * How sure the picture is: a faint ball about the hand, and a bar through the contact along the skin's normal. Both
 * reach two standard deviations.
 */
export class Halo {
  readonly group = new Group();
  private readonly ball = new Mesh(
      new SphereGeometry(1, 40, 28),
      new MeshBasicMaterial({color: '#bfe6ff', transparent: true, opacity: 0.16, side: BackSide, depthWrite: false}));
  private readonly bar = new Mesh(
      new CylinderGeometry(1, 1, 1, 20),
      new MeshBasicMaterial({color: '#ffffff', transparent: true, opacity: 0.55, depthTest: false}));

  constructor() {
    this.bar.renderOrder = 11;
    this.group.add(this.ball, this.bar);
    this.show(undefined);
  }

  /** undefined: not known, and nothing is drawn. */
  show(known: Uncertainty | undefined): void {
    const ball_m = SIGMAS * (known?.hand_sigma_m ?? 0);
    const bar_m = 2 * SIGMAS * (known?.surface_sigma_m ?? 0);
    this.ball.visible = known?.hand !== undefined && ball_m > LEAST_M;
    if (known?.hand !== undefined) this.ball.position.copy(known.hand);
    this.ball.scale.setScalar(Math.max(ball_m, LEAST_M));
    this.bar.visible = known?.proxy !== undefined && known.normal !== undefined && bar_m > LEAST_M;
    if (known?.proxy === undefined || known.normal === undefined) return;
    this.bar.position.copy(known.proxy);
    this.bar.quaternion.setFromUnitVectors(UP, known.normal.clone().normalize());
    this.bar.scale.set(BAR_RADIUS_M, Math.max(bar_m, LEAST_M), BAR_RADIUS_M);
  }

  setShown(wanted: boolean): void {
    this.group.visible = wanted;
  }
}
