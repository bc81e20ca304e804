// One instant is presented at a time: picture, hand, force and numbers belong together. The station sends its state 100
// times a second, so the state nearest to a picture's exposure is at most half a period (5 ms) away, unless some are lost.

import type {StationState} from '../messages/generated';
import {stateBetween} from './between_states';

/** Half a period of /station/state. */
const TOGETHER_NS = 5_000_000n;
/**
 * States further apart are not interpolated. In this time, an acceleration of the hand of 5 m/s² makes an error of
 * 1.6 mm.
 */
const BRIDGED_NS = 50_000_000n;
/** A picture waits for the station's values until they are this much older than the picture, or for this long. */
export const LONGEST_WAIT_MS = 500;
const LONGEST_WAIT_NS = BigInt(LONGEST_WAIT_MS) * 1_000_000n;
/**
 * If the newest picture is older than the station's newest values by more than this, the values are presented without a
 * new picture.
 */
const WITHOUT_PICTURE_NS = 250_000_000n;

/**
 * Pictures captured until this time can be presented: the station's values of their instant have arrived, or the viewer
 * does not wait for them.
 */
export function presentableUntil(newestStamp_ns: bigint | undefined, newestCapture_ns: bigint): bigint {
  if (newestStamp_ns === undefined || newestCapture_ns - newestStamp_ns > LONGEST_WAIT_NS) return newestCapture_ns;
  return newestStamp_ns + TOGETHER_NS;
}

/**
 * The station's values of a picture's instant, from `states` in the order of time: those of the nearest state if it is at
 * most half a period away, otherwise an estimate between its neighbours. Undefined: they are not known.
 */
export function valuesAt(states: readonly StationState[], captured_ns: bigint): StationState | undefined {
  const state = nearest(states, ({stampNs}) => stampNs, captured_ns);
  if (state === undefined || distance(state.stampNs, captured_ns) <= TOGETHER_NS) return state;
  const after = states.findIndex(({stampNs}) => stampNs > captured_ns);
  const [from, to] = [states[after - 1], states[after]];
  if (from === undefined || to === undefined || to.stampNs - from.stampNs > BRIDGED_NS) return undefined;
  return stateBetween(from, to, captured_ns);
}

/** Pictures whose values are not known are skipped for this long. Then the page presents one without values. */
const LONGEST_SKIP_NS = 100_000_000n;

/** True when a picture whose values are not known is skipped, because a later one may have values. */
export function isSkipped(captured_ns: bigint, newestStamp_ns: bigint, presentedCapture_ns: bigint | undefined): boolean {
  return newestStamp_ns > captured_ns && presentedCapture_ns !== undefined &&
      captured_ns - presentedCapture_ns < LONGEST_SKIP_NS;
}

/** For this long after the station's first values, the viewer waits for the first picture: it takes time to draw both. */
const FIRST_PICTURE_NS = 1_000_000_000n;

/**
 * True when the station's values are presented without a new picture, because no picture comes. `first_ns`: the time of
 * the first values.
 */
export function continuesWithoutPicture(
    stamp_ns: bigint, presentedCapture_ns: bigint | undefined, first_ns: bigint): boolean {
  if (presentedCapture_ns === undefined) return stamp_ns - first_ns > FIRST_PICTURE_NS;
  return stamp_ns - presentedCapture_ns > WITHOUT_PICTURE_NS;
}

/** The hand is hidden when no picture has come for this long: the hand is elsewhere by now. */
const KEEPS_HAND_NS = 1_000_000_000n;

/**
 * The hand in the scene when the values of `stamp_ns` are presented without a new picture. It belongs to the picture that
 * stays; if there is none, it follows the values. `newestCapture_ns`: of the pictures that have come; undefined: none was
 * presented. While pictures come, and this computer is slow to draw them, the hand stays.
 */
export function handWithoutPicture(stamp_ns: bigint, newestCapture_ns: bigint | undefined): 'new' | 'kept' | 'none' {
  if (newestCapture_ns === undefined) return 'new';
  return stamp_ns - newestCapture_ns > KEEPS_HAND_NS ? 'none' : 'kept';
}

const distance = (a: bigint, b: bigint) => (a < b ? b - a : a - b);

/** The item whose time is nearest to `at_ns`; undefined when there is none. */
export function nearest<Item>(items: readonly Item[], timeOf: (item: Item) => bigint, at_ns: bigint): Item | undefined {
  const away = (item: Item) => distance(timeOf(item), at_ns);
  return items.reduce<Item | undefined>(
      (best, item) => (best === undefined || away(item) <= away(best) ? item : best), undefined);
}
