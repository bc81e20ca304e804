import type {StationState, Vec3} from '../messages/generated';

/**
 * After this time without a sample the tracker counts as seeing no hand. It is longer than the 0.1 s after which a
 * station releases.
 */
const HAND_GONE_MS = 250;

/** The displayed hand's position from the station; undefined while the tracker sees no hand. */
export function shownHand({stampNs, handSampledNs, displayedHandCamera}: StationState): Vec3 | undefined {
  if (handSampledNs === 0n) return undefined;
  return Number(stampNs - handSampledNs) / 1e6 > HAND_GONE_MS ? undefined : displayedHandCamera;
}
