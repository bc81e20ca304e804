import type {PlaybackState} from './playback_state';

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** The texts and values of the timeline bar. */
export interface TimelineLook {
  play: string;            // what a press on the first button does
  symbol: string;
  time: string;
  spokenTime: string;
  position_s: number;
  longest_s: number;       // not behind the session's end
  speed: string;           // the value of the chosen speed
  speeds: readonly string[];  // with the server's, if that is not one of ours
  loop: boolean;
}

export function timelineLook({position_s, duration_s, speed, loop, playing}: PlaybackState): TimelineLook {
  const shown_s = Math.min(Math.max(position_s, 0), duration_s);
  const speeds = SPEEDS.includes(speed) ? SPEEDS : [...SPEEDS, speed].sort((a, b) => a - b);
  return {
    play: playing ? 'Pause' : 'Play',
    symbol: playing ? '❚❚' : '▶',
    time: `${clock(shown_s)} / ${clock(duration_s)}`,
    spokenTime: `${spoken(shown_s)} of ${spoken(duration_s)}`,
    position_s: shown_s,
    longest_s: Math.floor(duration_s * 100) / 100,
    speed: String(speed),
    speeds: speeds.map(String),
    loop,
  };
}

/** 75.25 becomes 1:15.2: tenths are cut, so that the position never reads later than the end. */
export function clock(seconds: number): string {
  const tenths = Math.floor(seconds * 10 + 1e-6);
  const rest = (tenths % 600) / 10;
  return `${Math.floor(tenths / 600)}:${rest.toFixed(1).padStart(4, '0')}`;
}

function spoken(seconds: number): string {
  const [minutes, rest] = clock(seconds).split(':');
  return minutes === '0' ? `${Number(rest)} s` : `${minutes} min ${Number(rest)} s`;
}
