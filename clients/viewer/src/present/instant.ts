import type {DecodedDepth} from '../depth/depth_decoder';
import type {StationState} from '../link/messages';
import type {FrameTimes} from './time_account';

/** Force and indentation at a time of the station, for the plots. */
export interface Touch {
  at_s: number;
  force_N: number;
  indentation_m: number;
}

export interface Picture extends DecodedDepth {
  captured_ns: bigint;
  color: ImageBitmap | undefined;  // undefined: the one shown before stays
  cameraMatrix: readonly number[] | undefined;
}

/** All that is presented together: a picture, and what the station said of the same instant. */
export interface Instant {
  picture: Picture | undefined;  // undefined: no new one; the station's word goes on alone
  station: StationState | undefined;
  trail: readonly Touch[];  // up to this instant, since the one before
  times: FrameTimes | undefined;  // of the picture; undefined while the session clock is not known
}
