import type {Rotation, StationState, Vec3} from '../messages/generated';

const PLACES = [
  'hand', 'device', 'forceN', 'displayedHandCamera', 'proxyCamera', 'deviceCamera', 'forceCameraN', 'torqueCameraNM',
  'normalCamera',
] as const;

const between = (a: number, b: number, share: number) => a + share * (b - a);

const placeBetween = (a: Vec3, b: Vec3, share: number): Vec3 =>
    ({x: between(a.x, b.x, share), y: between(a.y, b.y, share), z: between(a.z, b.z, share)});

/** Along the shorter way; as accurate as a spherical interpolation for the few degrees of one gap. */
function turnBetween(a: Rotation, b: Rotation, share: number): Rotation {
  const sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1 : 1;
  const sum = {...placeBetween(a, {x: sign * b.x, y: sign * b.y, z: sign * b.z}, share), w: between(a.w, sign * b.w, share)};
  const length = Math.hypot(sum.x, sum.y, sum.z, sum.w);
  return {x: sum.x / length, y: sum.y / length, z: sum.z / length, w: sum.w / length};
}

/**
 * An estimate of the station's state at `at_ns`, between two neighbouring states. Places, forces, indentation and attitude
 * change linearly: with the acceleration a, the error over a gap T is at most a T² / 8. All other values are those before
 * the gap. Undefined if the phase or the contact changed meanwhile: it is not known when.
 */
export function stateBetween(before: StationState, after: StationState, at_ns: bigint): StationState | undefined {
  if (before.phase !== after.phase || before.inBody !== after.inBody) return undefined;
  const share = Number(at_ns - before.stampNs) / Number(after.stampNs - before.stampNs);
  const state = {...before, stampNs: at_ns, indentationM: between(before.indentationM, after.indentationM, share)};
  for (const name of PLACES) {
    const [from, to] = [before[name], after[name]];
    if (from !== undefined && to !== undefined) state[name] = placeBetween(from, to, share);
  }
  const [from, to] = [before.handAttitudeCamera, after.handAttitudeCamera];
  if (from !== undefined && to !== undefined) state.handAttitudeCamera = turnBetween(from, to, share);
  return state;
}
