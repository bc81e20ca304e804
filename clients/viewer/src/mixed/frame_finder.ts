import type {Vec3} from '../messages/generated';
import {fitRigid} from './anchor_fit';
import {minus, moved, norm, type Rigid} from './rigid';

const APART_M = 0.005;    // places that are kept lie at least this far from each other
const CHANGED_M = 0.002;  // a place that misses the found motion by more shows that the frames have moved
const MOST_PLACES = 60;

/**
 * Finds how the scene lies in the haptic base's frame H, from places of the end-effector that the station publishes in
 * both frames. The places have no noise, so few are enough. It starts again when the station moves the scene.
 */
export class FrameFinder {
  private haptic: Vec3[] = [];
  private scene: Vec3[] = [];
  private found: Rigid | undefined;

  add(haptic: Vec3, scene: Vec3): void {
    if (this.found !== undefined && norm(minus(moved(this.found, haptic), scene)) > CHANGED_M) this.forget();
    if (this.haptic.some((place) => norm(minus(place, haptic)) < APART_M)) return;
    this.haptic = [...this.haptic.slice(1 - MOST_PLACES), haptic];
    this.scene = [...this.scene.slice(1 - MOST_PLACES), scene];
    this.found = fitRigid(this.haptic, this.scene) ?? this.found;
  }

  /** undefined: the places of the end-effector so far lie on a line or at one point. */
  get sceneFromHaptic(): Rigid | undefined {
    return this.found;
  }

  private forget(): void {
    [this.haptic, this.scene, this.found] = [[], [], undefined];
  }
}
