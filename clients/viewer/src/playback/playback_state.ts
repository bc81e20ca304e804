import type {Resource} from '../link/resource';
import {milliseconds} from '../link/session_clock';
import type {PlaybackState as PlaybackMessage} from '../messages/generated';

/** The instant of the depth image that the player published last, or of the last message in a session without images. */
export interface PublishedInstant {
  at_ms: number;  // session time in the published message
  at_s: number;   // the same instant since the session's beginning
  speed: number;  // playback speed at which it was published; 2: twice as fast
}

/** How the server plays a session. Positions count from the session's beginning. */
export interface PlaybackState {
  position_s: number;
  duration_s: number;
  speed: number;
  loop: boolean;
  playing: boolean;
  shown: PublishedInstant | undefined;  // undefined: none, or not known since the last command
  begin_ms: number;  // session time of the recording's beginning
  session: string;  // names the played session; another session has another name
}

/** The body of POST /playback. What is left out stays as it is. A step pauses. */
export interface PlaybackCommand {
  seek_s?: number;
  step?: number;
  step_back?: number;
  speed?: number;
  loop?: boolean;
  play?: boolean;
}

/** undefined: the player has not carried out the last command yet. */
export function readState(message: PlaybackMessage): PlaybackState | undefined {
  if (message.pending) return undefined;
  const {positionS, durationS, speed, loop, playing, file, beginNs, shownNs, shownS, shownSpeed} = message;
  return {
    position_s: positionS, duration_s: durationS, speed, loop, playing, begin_ms: Number(beginNs) / 1e6,
    session: `${file} ${beginNs}`,
    shown: shownNs === 0n ? undefined : {at_ms: milliseconds(shownNs), at_s: shownS, speed: shownSpeed},
  };
}

/** The state that `command` will lead to: shown at once, because the server replies with the state before it. */
export function afterCommand(
    state: PlaybackState, {seek_s, step, step_back, speed, loop, play}: PlaybackCommand): PlaybackState {
  const steps = step !== undefined || step_back !== undefined;
  return {
    ...state,
    shown: steps || seek_s !== undefined ? undefined : state.shown,
    position_s: seek_s ?? state.position_s,
    speed: speed ?? state.speed,
    loop: loop ?? state.loop,
    playing: !steps && (play ?? state.playing),
  };
}

/** The server refuses a seek behind the end, so the position is kept within the session. */
export function seekTo(state: PlaybackState, position_s: number): PlaybackCommand {
  return {seek_s: Math.min(Math.max(position_s, 0), state.duration_s)};
}

/** The played session; its state is undefined if there is none, or this visitor may not move it. */
export type Playback = Resource<PlaybackMessage, PlaybackState, PlaybackCommand>;

export const PLAYBACK = {read: readState, after: afterCommand, mostWaiting: 4};
