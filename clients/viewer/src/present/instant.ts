import type {DecodedDepth} from '../depth/depth_decoder';
import type {Phase, StationCompensation, StationState} from '../messages/generated';
import {isContact} from './contact';
import type {FrameTimes} from './time_account';

/** What the device's force is: one of the two is 0. Whatever shows a force asks here which of them it is. */
export interface Forces {
  force_N: number;  // of the contact, on the hand
  drive_N: number;  // moves the free device: nothing of it comes from the patient
}

export function forcesOf({forceN, phase, indexing}: StationState): Forces {
  const device_N = forceN === undefined ? 0 : Math.hypot(forceN.x, forceN.y, forceN.z);
  return isContact(phase, indexing) ? {force_N: device_N, drive_N: 0} : {force_N: 0, drive_N: device_N};
}

/** Forces, indentation and phase at a time of the station, for the plots. */
export interface Touch extends Forces {
  at_s: number;
  indentation_m: number;
  phase?: Phase | undefined;
}

/** Brightness of a colour picture: mean luminance of 0 to 255, and the share of pixels that are white. */
export interface Light {
  mean: number;
  clipped: number;
}

export interface Picture extends DecodedDepth {
  captured_ns: bigint;
  published_ns: bigint;
  color: ImageBitmap | undefined;  // undefined: the previous image stays
  cameraMatrix: readonly number[] | undefined;
}

/** The data that is presented together: a picture, and the station's values of the same instant. */
export interface Instant {
  picture: Picture | undefined;  // undefined: no new picture; only the station's values are new
  station: StationState | undefined;  // of the picture's instant, or of now without a picture; undefined: not known
  hand: 'new' | 'kept' | 'none';      // hand and force in the scene: of `station`, of the picture that stays, or hidden
  late_ms: number | undefined;        // by how much the newest known values are older than the picture that has none
  compensation?: StationCompensation | undefined;  // of the instant of `station`; only in views that show it
  trail: readonly Touch[];  // touches since the previous instant, up to this one
  times: FrameTimes | undefined;  // of the picture; undefined while the session clock is not known
}
