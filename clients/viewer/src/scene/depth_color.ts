/** Control points of the colour map viridis (matplotlib, CC0): the same lightness step for the same depth step. */
const VIRIDIS: readonly (readonly [number, number, number])[] = [
  [0.993, 0.906, 0.144], [0.478, 0.821, 0.318], [0.135, 0.659, 0.518], [0.164, 0.471, 0.558], [0.254, 0.265, 0.530],
  [0.267, 0.005, 0.329],
];

/** The colour of a place in the range of depth: 0 is near (bright), 1 far. */
export function depthColor(share: number): string {
  const at = Math.min(1, Math.max(0, share)) * (VIRIDIS.length - 1);
  const [from, to] = [VIRIDIS[Math.floor(at)]!, VIRIDIS[Math.ceil(at)]!];
  const bands = [0, 1, 2].map((band) => Math.round(255 * (from[band]! + (at % 1) * (to[band]! - from[band]!))));
  return `rgb(${bands.join(', ')})`;
}

/** The same map as GLSL: `vec3 depthColor(float share)`. */
export const DEPTH_COLOR_GLSL = `
vec3 depthColor(float share) {
  vec3 stops[${VIRIDIS.length}] = vec3[](${VIRIDIS.map((stop) => `vec3(${stop.map((band) => band.toFixed(3)).join(', ')})`).join(', ')});
  float at = clamp(share, 0.0, 1.0) * ${(VIRIDIS.length - 1).toFixed(1)};
  int stop = min(int(at), ${VIRIDIS.length - 2});
  return mix(stops[stop], stops[stop + 1], at - float(stop));
}
`;
