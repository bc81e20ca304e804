import {LEAST_TOUCHES, MOST_MOVED_M, type OffsetFit} from '../../calibration/offset_fit';
import type {Vec3} from '../../messages/generated';
import type {Row} from '../../page/rows';

const mm = (metres: number) => `${(1000 * metres).toFixed(2)} mm`;
const point = ({x, y, z}: Vec3) => [x, y, z].map((value) => (1000 * value).toFixed(1)).join(', ');  // mm, as the card says

/** One row for each place: how many touches, and their residual. */
export function placeRows(fit: OffsetFit | undefined): Row[] {
  return (fit?.places ?? []).map(({place, touches, rms_m, moved_m}) => ({
    name: `Place ${place}`,
    value: `${mm(rms_m)}, ${touches} pairs`,
    says: `Residual (RMS) of this place’s ${touches} pairs. The hand moved by up to ${mm(moved_m)}.`,
    level: rms_m > MOST_MOVED_M || moved_m > MOST_MOVED_M ? 'warn' : 'good',
  }));
}

/** The transform of S1 eq. (2) to (4), and how well it fits. */
export function fitRows(fit: OffsetFit | undefined): Row[] {
  if (fit === undefined) return [];
  return [
    {name: 'Hand p0', value: point(fit.tracker0), says: 'Mean of the hand in the tracker’s frame L: S1 eq. (2)'},
    {name: 'Device p0', value: point(fit.haptic0), says: 'Mean of the end-effector in the haptic base’s frame H: S1 eq. (2)'},
    {name: 'Rotation R', value: 'x, −y, −z', says: 'S1 eq. (4). R is its own inverse, so eq. (3) uses R, too.'},
    {name: 'Translation', value: point(fit.translation), says: 'Device p0 − R · hand p0: the rows above'},
    {name: 'Residual', value: `${mm(fit.rms_m)} RMS`, level: fit.largest_m > MOST_MOVED_M ? 'alarm' : 'good',
     says: 'Distance between R · hand + translation and the end-effector, over all pairs'},
    {name: 'Largest residual', value: mm(fit.largest_m), level: fit.largest_m > MOST_MOVED_M ? 'alarm' : 'good',
     says: `telepalp-station calibrate refuses more than ${mm(MOST_MOVED_M)}`},
  ];
}

/** What the fit means, in a sentence. */
export function verdict(fit: OffsetFit | undefined): string {
  if (fit === undefined) return `At least ${LEAST_TOUCHES} pairs are needed.`;
  const moved = fit.places.find(({moved_m}) => moved_m > MOST_MOVED_M);
  if (moved !== undefined) return `The hand moved at place ${moved.place}: press Begin again.`;
  if (fit.largest_m > MOST_MOVED_M)
    return 'The places disagree: the tracker is turned otherwise than S1 eq. (4) assumes. Save the pairs, and run the second command of step 4.';
  if (fit.places.length < 3)
    return 'Good so far. Measure three places 5 cm apart: one place does not show whether the tracker is turned.';
  return 'Good: the places agree.';
}
