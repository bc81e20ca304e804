import {Quaternion, Vector3} from 'three';

import type {Rotation, Vec3} from '../messages/generated';

/** A point or direction of the depth camera's frame K (x right, y down, z forward) in the scene (y up, z to the eye). */
export function fromCamera({x, y, z}: Vec3): Vector3 {
  return new Vector3(x, -y, -z);
}

/** The inverse conversion. */
export function toCamera({x, y, z}: Vector3): Vec3 {
  return {x, y: -y, z: -z};
}

/** Half a turn about x: the scene's axes from the camera's. */
const SCENE_FROM_CAMERA = new Quaternion(1, 0, 0, 0);

/** A rotation into the depth camera's frame K, as one into the scene; undefined when it is no rotation. */
export function rotationFromCamera({x, y, z, w}: Rotation): Quaternion | undefined {
  if (!(Math.abs(Math.hypot(x, y, z, w) - 1) < 0.01)) return undefined;
  return new Quaternion(x, y, z, w).normalize().premultiply(SCENE_FROM_CAMERA);
}
