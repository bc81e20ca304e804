import type {DecodedDepth} from '../depth/depth_decoder';
import type {Phase, StationCompensation, StationState} from '../link/messages';
import type {FrameTimes} from './time_account';

/** Force, indentation and phase at a time of the station, for the plots. */
export interface Touch {
  at_s: number;
  force_N: number;
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
  color: ImageBitmap | undefined;  // undefined: the previous image stays
  cameraMatrix: readonly number[] | undefined;
}

/** The data that is presented together: a picture, and the station's values of the same instant. */
export interface Instant {
  picture: Picture | undefined;  // undefined: no new picture; only the station's values are new
  station: StationState | undefined;
  compensation?: StationCompensation | undefined;  // of the instant of `station`; only in views that show it
  trail: readonly Touch[];  // touches since the previous instant, up to this one
  times: FrameTimes | undefined;  // of the picture; undefined while the session clock is not known
}
