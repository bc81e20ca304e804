// The messages that the viewer reads, as @bufbuild/protobuf hands them over: field names in camelCase, 64-bit
// integers as bigint, an absent message as undefined. The types are declared in proto/messages and proto/foxglove.

import type {InnerStructures, ObjectPlacement, UltrasoundImage} from '../inside/inside_messages';

export interface Vec3 {
  x: number;
  y: number;
  z: number;
}

/** A unit quaternion. */
export interface Rotation {
  x: number;
  y: number;
  z: number;
  w: number;
}

/** p_to = rotation p_from + translation. */
export interface RigidMotion {
  translationM?: Vec3;
  rotation?: Rotation;
}

/** telepalp.msg.Phase */
export enum Phase {
  Unspecified,
  InBody,
  BodyToPlane,
  OutBody,
  PlaneToBody,
  ObjectLateral,
  AroundObject,
  ObjectUpper,
  Released,
  Faulted,
}

const IN_CONTACT: ReadonlySet<Phase> =
    new Set([Phase.InBody, Phase.ObjectLateral, Phase.AroundObject, Phase.ObjectUpper]);

/**
 * True where the skin, or an object below it, gives the device's force. Elsewhere the force is the drive's, which moves
 * the free device. `indexing`: the device is beyond the cylinder of workspace indexing.
 */
export const isContact = (phase: Phase | undefined, indexing = false) =>
    phase !== undefined && IN_CONTACT.has(phase) && !indexing;

/** telepalp.msg.CaptureState */
export enum CaptureState {
  Unspecified,
  Live,
  Waiting,
  Lost,
  Ended,
}

/** Error bound max(leastM, perM z²) in metres at a depth of z metres. */
export interface DepthBound {
  leastM: number;
  perM: number;
}

export interface DepthImage {
  capturedNs: bigint;
  sequence: bigint;
  format: string;
  bound?: DepthBound;
  data: Uint8Array;
}

export interface CompressedImage {
  timestamp?: {seconds: bigint; nanos: number};
  data: Uint8Array;
  format: string;
}

export interface CameraCalibration {
  width: number;
  height: number;
  K: number[];
}

export interface CaptureStatus {
  state: CaptureState;
  source: string;
  detail: string;
  framesPerS: number;
  colorRegistered: boolean;
}

/** The server plays a session that is paused. */
export const isPaused = ({state, source}: CaptureStatus) => state === CaptureState.Waiting && source.startsWith('session:');

/** No image is expected: the played session is paused, or a recording has ended. */
export const isAtRest = (capture: CaptureStatus) => capture.state === CaptureState.Ended || isPaused(capture);

export interface StationState {
  stampNs: bigint;
  surfaceCapturedNs: bigint;
  handSampledNs: bigint;  // 0: no hand yet
  phase: Phase;
  hand?: Vec3;    // in the haptic base's frame H, like the next two
  device?: Vec3;
  workspaceShift?: Vec3;  // a position in H minus that in the device's own frame; absent: none
  forceN?: Vec3;
  displayedHandCamera?: Vec3;
  handAttitudeCamera?: Rotation;  // of the hand's axes; absent: the tracker tells none
  proxyCamera?: Vec3;
  deviceCamera?: Vec3;
  forceCameraN?: Vec3;
  normalCamera?: Vec3;
  indentationM: number;
  inBody: boolean;
  surfaceStale: boolean;
  limited: boolean;
  unmodelled: number;          // 1: the patient just moved unlike in the seconds before; then falls to 0 within 1 s
  indexing?: boolean;          // the device is beyond the cylinder of workspace indexing: the body gives no force
  objectUnseen: boolean;       // an object inside the body stays put: the skin above it is not seen
  passivityJ: number;          // energy taken from the hand less energy stored
  sender: number;              // number of the station at the server; 0: unknown
  yieldsInS: number;  // until warm motors lower the force; infinite: they do not; 0 of a station that does not tell
}

/** telepalp.msg.EventKind */
export enum EventKind {
  Unspecified,
  Phase,
  Link,
  Fault,
  Deadline,
  Scene,
  Heat,
}

export interface StationEvent {
  stampNs: bigint;
  kind: EventKind;
  text: string;
  from: Phase;
  to: Phase;
}

export interface StationStats {
  deadlinesMissed: bigint;
  tickUsP99: number;
  hapticFromTracker?: RigidMotion;  // the calibration in use; absent: the tracker needs none
}

/** The delay that the station compensates; see proto/messages/station.proto. */
export interface StationCompensation {
  stampNs: bigint;
  handAgeS: number;
  handCarriedM: number;
  handSigmaM: number;
  surfaceAgeS: number;
  surfaceCarriedM: number;
  surfaceSigmaM: number;
  slewedM: number;
  support: number;
  shownOffsetM: number;
  dampingN: number;
  handExcessJ: number;
  driveJ: number;
  objects: ObjectPlacement[];
}

/** The instants of one frame on its way to the hand, in session time. */
export interface SurfaceReport {
  capturedNs: bigint;
  encodedNs: bigint;
  receivedNs: bigint;
  decodedNs: bigint;
  touchableNs: bigint;
}

export interface TopicCount {
  topic: string;
  published: bigint;
  sent: bigint;
  dropped: bigint;
  bytes: bigint;
}

export interface ServerStats {
  stampNs: bigint;
  topics: TopicCount[];
  subscribers: {name: string; address: string; sent: bigint; dropped: bigint; sender: number; byDatagram: boolean}[];
}

export interface Clock {
  sessionNs: bigint;
}

/** The position of the hand that this viewer holds; the server adds the viewer's number. */
export type ViewerHand = {
  sampledUs: bigint;
  handCamera: Vec3;
  hovers: boolean;  // the pointer points at a place and does not press: the station's hand flies there over the patient
};

/** Asks the station to re-arm after a fault. */
export type Rearm = {
  rearm: true;
};

/** Gives up the hand. Without it the viewer holds the hand even if it sends nothing. */
export type LetGo = {
  letGo: true;
};

/** Passes the hand to a viewer that asks for it. */
export type HandOver = {
  handOverTo: bigint;
};

/** The viewer that holds the hand (0: none) and the viewers that ask for it. */
export interface HandHolder {
  viewer: bigint;
  asking: bigint[];
}

/** The topics that the viewer publishes: topic name -> fields of its messages. */
export interface OwnTopics {
  '/viewer/hand': ViewerHand | LetGo | HandOver | Rearm;
}

/** Topic name -> fields of its messages. */
export interface Topics {
  '/clock': Clock;
  '/camera/depth': DepthImage;
  '/camera/color': CompressedImage;
  '/camera/info': CameraCalibration;
  '/camera/status': CaptureStatus;
  '/station/state': StationState;
  '/station/events': StationEvent;
  '/station/stats': StationStats;
  '/station/compensation': StationCompensation;
  '/station/surface': SurfaceReport;
  '/station/ultrasound': UltrasoundImage;
  '/station/inside': InnerStructures;
  '/server/stats': ServerStats;
  '/viewer/hand_holder': HandHolder;
}
