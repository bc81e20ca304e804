import type {CaptureStatus, Phase} from '../messages/generated';
import type {TimeAccount} from '../present/time_account';

/** What decides whether, and how, a user can touch. */
export interface TouchHealth {
  handShown: boolean | undefined;  // undefined: no station sends messages
  holdsHand: boolean;              // "Touch" is on in this page
  role: string;                    // of this visitor at the server; empty while it is not known
  untaken: boolean;                // the server reports that no station uses this page's hand
  unmodelled: boolean;             // the patient just moved unlike in the seconds before: the station predicts less
  objectUnseen: boolean;           // an object inside the body stays put: the skin above it is not seen
}

/** What is wrong with the device's motion. */
export type Unsteady = {swing_mm: number; hertz: number} | 'full drive';

/** The values on which the banner depends. Ages are in milliseconds; undefined: no message yet. */
export interface Health extends TouchHealth {
  connected: boolean;
  retryIn_ms: number | undefined;
  everConnected: boolean;
  opening?: number | undefined;   // share of this page's own session that the server has read to open it; undefined: it is open
  unopened?: string | undefined;  // why the server does not open this page's own session; undefined: it does
  capture: CaptureStatus | undefined;
  picture_ms: number | undefined;
  account: TimeAccount | undefined;  // for the oldest picture of the last second; undefined while data is missing
  late_ms: number | undefined;       // by how much the newest numbers are older than the picture, which shows none then
  station_ms: number | undefined;
  surfaceStale: boolean;
  surface_ms: number | undefined;
  objectOverPlace: boolean;  // something lies over the touched place: the station shows the skin that it remembers
  handOutsideWindow: boolean;  // the hand has left the part of the image that is exact, so it feels no force
  paused: boolean;           // the played session is paused
  stale: boolean;            // the picture is too old, or no newer one has come for longer than this path explains
  silence_ms: number | undefined;   // since the last image, if that is longer than this path explains
  heardAny_ms: number | undefined;  // since the newest message of any topic
  graphicsLost: boolean;     // the browser has lost its graphics context, and draws nothing
  unsteady: Unsteady | undefined;  // undefined: the device is steady
  phase: Phase | undefined;  // undefined: there is a station, but its phase at this instant is not known
  lineLeft_B_per_s?: number | undefined;  // what other traffic leaves of the station's line; undefined: none was noticed
  yields_s: number | undefined;  // until warm motors lower the force in contact; undefined: they do not
}
