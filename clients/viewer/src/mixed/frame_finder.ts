import type {Vec3} from '../messages/generated';
import {fitRigid} from './anchor_fit';
import {minus, moved, norm, type Rigid} from './rigid';

const APART_M = 0.005;    // the end-effector has moved this far between two places that are kept
const CHANGED_M = 0.002;  // a place that misses by more belongs to another motion between the frames
const MOST_PLACES = 60;

/**
 * Finds how the scene lies in the haptic base's frame H, from places of the end-effector that the station publishes in
 * both frames. The places have no noise, so few are enough. It begins anew when the station places the scene otherwise.
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

  /** undefined: the end-effector has not moved far enough beside a line. */
  get sceneFromHaptic(): Rigid | undefined {
    return this.found;
  }

  private forget(): void {
    [this.haptic, this.scene, this.found] = [[], [], undefined];
  }
}
