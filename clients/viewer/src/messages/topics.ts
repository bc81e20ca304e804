import type {
  CameraCalibration, CaptureStatus, Clock, ComparisonState, CompressedImage, CompressedVideo, DepthImage, ExposureState, HandHolder,
  InnerStructures, MarksState,
  NetworkState, PeopleState, PlaybackState, ReadingState, RecordingState, ServerStats, SessionEvents, SessionList,
  SessionNotes, SourceState,
  RoomVoiceState, StationCompensation, StationEvent, StationState, StationStats, SurfaceReport, UltrasoundImage, ViewerHand, VoiceFrame,
} from './generated';

/** The fields `Name` of a message, each of them given. */
type Given<T, Name extends keyof T> = Required<Pick<T, Name>>;

/** A position of the hand that this viewer holds; the server adds the viewer's number. */
type HandSample = Given<ViewerHand, 'sampledUs' | 'handCamera' | 'hovers'>;
/** Asks the station to re-arm after a fault. */
type Rearm = Given<ViewerHand, 'rearm'>;
/** Accepts the object over the hand's place as skin. */
type AcceptObject = Given<ViewerHand, 'acceptObject'>;
/** Gives up the hand. Without it the viewer holds the hand even if it sends nothing. */
type LetGo = Given<ViewerHand, 'letGo'>;
/** Passes the hand to a viewer that asks for it. */
type HandOver = Given<ViewerHand, 'handOverTo'>;
/** What this viewer says; the server adds the viewer's number. */
type SpokenWords = Given<VoiceFrame, 'capturedNs' | 'number' | 'begun' | 'opus' | 'earlier'>;

/** The topics that the viewer publishes: topic name -> fields of its messages. */
export interface OwnTopics {
  '/viewer/hand': HandSample | LetGo | HandOver | Rearm | AcceptObject;
  '/patient/voice': SpokenWords;
  '/doctor/voice': SpokenWords;
}
export type VoiceTopic = '/patient/voice' | '/doctor/voice';

/** The states of the server's resources: path of the resource, which is the topic's name -> fields of its messages. */
export interface StateTopics {
  '/playback': PlaybackState;
  '/playback/events': SessionEvents;
  '/playback/network': NetworkState;
  '/playback/notes': SessionNotes;
  '/playback/comparison': ComparisonState;
  '/reading': ReadingState;
  '/recording': RecordingState;
  '/sessions': SessionList;
  '/source': SourceState;
  '/exposure': ExposureState;
  '/people': PeopleState;
  '/marks': MarksState;
  '/room_voice': RoomVoiceState;
}
export type StateTopic = keyof StateTopics;
export const STATE_TOPICS = [
  '/playback', '/playback/events', '/playback/network', '/playback/notes', '/playback/comparison', '/reading', '/recording',
  '/sessions', '/source', '/exposure', '/people', '/marks', '/room_voice',
] as const satisfies readonly StateTopic[];

/** A state, and the session time at which the server published it. */
export interface Published<Message> {
  message: Message;
  published_ns: bigint;
}
/** The states that have changed; undefined: the server does not have this resource, or it is not for this visitor. */
export type ChangedStates = {[Topic in StateTopic]?: Published<StateTopics[Topic]> | undefined};

/** Topic name -> fields of its messages. */
export interface Topics extends StateTopics {
  '/clock': Clock;
  '/camera/depth': DepthImage;
  '/camera/color': CompressedImage;
  '/camera/color/video': CompressedVideo;
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
  '/patient/voice': VoiceFrame;
  '/doctor/voice': VoiceFrame;
}
