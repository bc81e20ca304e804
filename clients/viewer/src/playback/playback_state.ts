import {milliseconds} from '../link/session_clock';

/** The instant of the depth image that the player published last, or of the last message in a session without images. */
export interface PublishedInstant {
  at_ms: number;  // session time in the published message
  at_s: number;   // the same instant since the session's beginning
  speed: number;  // playback speed at which it was published; 2: twice as fast
}

/** How the server plays a session: the reply to GET and POST /playback. Positions count from the session's beginning. */
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

/** The state in the JSON `text`; undefined if a value is missing, of another type or not finite. */
export function readState(text: string): PlaybackState | undefined {
  let json: Partial<Record<keyof PlaybackState | 'file' | 'begin_ns' | keyof ShownJson, unknown>> | null;
  try {
    json = JSON.parse(text);
  } catch {
    return undefined;
  }
  const {position_s, duration_s, speed, loop, playing, file, begin_ns} = json ?? {};
  if (!isNumber(position_s) || !isNumber(duration_s) || !isNumber(speed)) return undefined;
  if (typeof loop !== 'boolean' || typeof playing !== 'boolean') return undefined;
  const shown = readShown(json as ShownJson);
  return {position_s, duration_s, speed, loop, playing, shown, begin_ms: Number(begin_ns) / 1e6, session: `${String(file)} ${String(begin_ns)}`};
}

interface ShownJson {
  shown_ns?: unknown;  // 64-bit integers come as text in Protobuf's JSON
  shown_s?: unknown;
  shown_speed?: unknown;
}

function readShown({shown_ns, shown_s, shown_speed}: ShownJson): PublishedInstant | undefined {
  if (!/^[1-9]\d*$/.test(String(shown_ns)) || !isNumber(shown_s) || !isNumber(shown_speed)) return undefined;
  return {at_ms: milliseconds(BigInt(String(shown_ns))), at_s: shown_s, speed: shown_speed};
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

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
