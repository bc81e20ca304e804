import {CaptureState, type CaptureStatus} from './generated';

/** The server plays a session that is paused. */
export const isPaused = ({state, source}: CaptureStatus) => state === CaptureState.WAITING && source.startsWith('session:');

/** No image is expected: the played session is paused, or a recording has ended. */
export const isAtRest = (capture: CaptureStatus) => capture.state === CaptureState.ENDED || isPaused(capture);
