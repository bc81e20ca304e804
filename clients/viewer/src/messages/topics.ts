import type {
  CameraCalibration, CaptureStatus, Clock, CompressedImage, DepthImage, HandHolder, InnerStructures, ServerStats,
  StationCompensation, StationEvent, StationState, StationStats, SurfaceReport, UltrasoundImage, ViewerHand,
} from './generated';

/** The fields `Name` of a message, each of them given. */
type Given<T, Name extends keyof T> = Required<Pick<T, Name>>;

/** A position of the hand that this viewer holds; the server adds the viewer's number. */
type HandSample = Given<ViewerHand, 'sampledUs' | 'handCamera' | 'hovers'>;
/** Asks the station to re-arm after a fault. */
type Rearm = Given<ViewerHand, 'rearm'>;
/** Gives up the hand. Without it the viewer holds the hand even if it sends nothing. */
type LetGo = Given<ViewerHand, 'letGo'>;
/** Passes the hand to a viewer that asks for it. */
type HandOver = Given<ViewerHand, 'handOverTo'>;

/** The topics that the viewer publishes: topic name -> fields of its messages. */
export interface OwnTopics {
  '/viewer/hand': HandSample | LetGo | HandOver | Rearm;
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
