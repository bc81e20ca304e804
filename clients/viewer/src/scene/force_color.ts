import {Color} from 'three';

/** The device's peak force [N], at which the scale ends. */
export const FULL_SCALE_N = 10;

const STOPS: readonly (readonly [number, Color])[] = [
  [0, new Color('#4fd6a5')],
  [4, new Color('#f2c94c')],  // the device's continuous limit
  [7, new Color('#f2784b')],
  [FULL_SCALE_N, new Color('#f0384f')],
];

/** Green for a light touch, amber at the device's continuous limit, red at its peak. */
export function forceColor(force_N: number): Color {
  for (let stop = 1; stop < STOPS.length; ++stop) {
    const [from_N, from] = STOPS[stop - 1]!;
    const [to_N, to] = STOPS[stop]!;
    if (force_N <= to_N) return from.clone().lerp(to, Math.max(0, (force_N - from_N) / (to_N - from_N)));
  }
  return STOPS[STOPS.length - 1]![1].clone();
}
