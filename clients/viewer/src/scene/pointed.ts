import {Group, Vector3} from 'three';

import {Arrow} from './arrow';

const MOST = 5;
const LENGTH_M = 0.09;
const SAME_SKIN_M = 0.04;  // a larger step of the depth is something that came between
const COLOR = '#ff5fa2';  // none of the force scale's colours

/** Arrows that point at places on the patient, from the camera's side. Nothing hides them. */
export class Pointed {
  readonly group = new Group();
  private readonly arrows = Array.from({length: MOST}, () => new Arrow(COLOR, 0.0025));
  private places: Vector3[] = [];

  constructor() {
    this.group.add(...this.arrows.map(({group}) => group));
  }

  /** Places in the scene's frame; of more than MOST the last ones are shown. */
  show(places: Vector3[]): void {
    this.places = places.slice(-MOST);
    this.follow(() => 0);
  }

  /** Moves the arrows with the body, along the camera's rays. `depthBehind`: the depth measured at a place; 0: none. */
  follow(depthBehind: (place: Vector3) => number): void {
    this.arrows.forEach((arrow, i) => {
      const at = this.places[i];
      const ratio = at === undefined ? 0 : depthBehind(at) / -at.z;
      if (at && Math.abs((ratio - 1) * at.z) < SAME_SKIN_M) at.multiplyScalar(ratio);
      const toEye = at?.clone().normalize().multiplyScalar(-LENGTH_M);
      arrow.show(at && toEye && at.clone().add(toEye), toEye?.negate());
    });
  }
}
