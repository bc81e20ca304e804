import {type PlaybackCommand, type PlaybackState, seekTo} from './playback_state';

/** What has the keyboard's focus, as far as it decides to whom a key belongs. */
export type Focus = 'scene' | 'button' | 'choice' | 'other';

const LEAP_S = 5;

/** The command that `key` gives; undefined: the key is not for the playback. */
export function commandForKey(key: string, focus: Focus, state: PlaybackState): PlaybackCommand | undefined {
  if (focus === 'choice') return undefined;                   // its keys choose
  if (key === ' ') return focus === 'button' ? undefined : {play: !state.playing};  // space presses a button
  if (key === ',') return {step_back: 1};
  if (key === '.') return {step: 1};
  if (focus === 'scene') return undefined;                    // its arrows turn the view
  if (key === 'ArrowLeft') return seekTo(state, state.position_s - LEAP_S);
  if (key === 'ArrowRight') return seekTo(state, state.position_s + LEAP_S);
  if (key === 'Home') return seekTo(state, 0);
  if (key === 'End') return seekTo(state, state.duration_s);
  return undefined;
}
