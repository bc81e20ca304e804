import {type ColorRepresentation, ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3} from 'three';

const UP = new Vector3(0, 1, 0);

/** An arrow that nothing hides. It has no shading, so that its colour can be compared with the scale. */
export class Arrow {
  readonly group = new Group();
  private readonly material: MeshBasicMaterial;
  private readonly shaft: Mesh;
  private readonly head: Mesh;

  constructor(color: ColorRepresentation, private readonly thickness_m: number) {
    this.material = new MeshBasicMaterial({color, depthTest: false, transparent: true, opacity: 0.95});
    this.shaft = new Mesh(new CylinderGeometry(thickness_m, thickness_m, 1, 20).translate(0, 0.5, 0), this.material);
    this.head = new Mesh(new ConeGeometry(3 * thickness_m, 6 * thickness_m, 28), this.material);
    this.shaft.renderOrder = this.head.renderOrder = 10;
    this.group.add(this.shaft, this.head);
    this.group.visible = false;
  }

  /** From `at` along `vector_m`; hidden when shorter than its own thickness. */
  show(at: Vector3 | undefined, vector_m: Vector3 | undefined, color?: ColorRepresentation): void {
    const length_m = vector_m?.length() ?? 0;
    this.group.visible = at !== undefined && length_m > this.thickness_m;
    if (!this.group.visible || at === undefined || vector_m === undefined) return;
    this.group.position.copy(at);
    this.group.quaternion.setFromUnitVectors(UP, vector_m.clone().divideScalar(length_m));
    const head_m = Math.min(6 * this.thickness_m, 0.6 * length_m);
    this.shaft.scale.set(1, length_m - head_m, 1);
    this.head.scale.setScalar(head_m / (6 * this.thickness_m));
    this.head.position.y = length_m - head_m / 2;
    if (color !== undefined) this.material.color.set(color);
  }
}
