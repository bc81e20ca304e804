/** How the server plays a session: the reply to GET and POST /playback. Positions count from the session's beginning. */
export interface PlaybackState {
  position_s: number;
  duration_s: number;
  speed: number;
  loop: boolean;
  playing: boolean;
  session: string;  // names the played session; another session has another name
}

/** The body of POST /playback. What is left out stays as it is. A step pauses. */
export interface PlaybackCommand {
  seek_s?: number;
  step?: number;
  speed?: number;
  loop?: boolean;
  play?: boolean;
}

/** The state in the JSON `text`; undefined if a value is missing, of another type or not finite. */
export function readState(text: string): PlaybackState | undefined {
  let json: Partial<Record<keyof PlaybackState | 'file' | 'begin_ns', unknown>> | null;
  try {
    json = JSON.parse(text);
  } catch {
    return undefined;
  }
  const {position_s, duration_s, speed, loop, playing, file, begin_ns} = json ?? {};
  if (!isNumber(position_s) || !isNumber(duration_s) || !isNumber(speed)) return undefined;
  if (typeof loop !== 'boolean' || typeof playing !== 'boolean') return undefined;
  return {position_s, duration_s, speed, loop, playing, session: `${String(file)} ${String(begin_ns)}`};
}

/** The state that `command` will lead to: shown at once, because the server replies with the state before it. */
export function afterCommand(state: PlaybackState, {seek_s, step, speed, loop, play}: PlaybackCommand): PlaybackState {
  return {
    ...state,
    position_s: seek_s ?? state.position_s,
    speed: speed ?? state.speed,
    loop: loop ?? state.loop,
    playing: step === undefined && (play ?? state.playing),
  };
}

/** The server refuses a seek behind the end, so the position is kept within the session. */
export function seekTo(state: PlaybackState, position_s: number): PlaybackCommand {
  return {seek_s: Math.min(Math.max(position_s, 0), state.duration_s)};
}

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
