import {Group, Vector3} from 'three';

import {Arrow} from './arrow';

const MOST = 5;
const LENGTH_M = 0.09;
const COLOR = '#ff5fa2';  // none of the force scale's colours

/** Arrows that point at places on the patient, from the camera's side. Nothing hides them. */
export class Pointed {
  readonly group = new Group();
  private readonly arrows = Array.from({length: MOST}, () => new Arrow(COLOR, 0.0025));

  constructor() {
    this.group.add(...this.arrows.map(({group}) => group));
  }

  /** Places in the scene's frame; of more than MOST the last ones are shown. */
  show(places: readonly Vector3[]): void {
    const newest = places.slice(-MOST);
    this.arrows.forEach((arrow, i) => {
      const at = newest[i];
      const toEye = at?.clone().normalize().multiplyScalar(-LENGTH_M);
      arrow.show(at && toEye && at.clone().add(toEye), toEye?.negate());
    });
  }
}
