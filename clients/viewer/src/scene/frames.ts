import {Vector3} from 'three';

import type {Vec3} from '../link/messages';

/** A point or direction of the depth camera's frame K (x right, y down, z forward) in the scene (y up, z to the eye). */
export function fromCamera({x, y, z}: Vec3): Vector3 {
  return new Vector3(x, -y, -z);
}

/** The inverse conversion. */
export function toCamera({x, y, z}: Vector3): Vec3 {
  return {x, y: -y, z: -z};
}
