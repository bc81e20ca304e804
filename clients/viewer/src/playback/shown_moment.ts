import type {Reading} from '../state/viewer_state';
import type {PlaybackState} from './playback_state';

/** The moment of the session that the page shows, in seconds since the session's beginning. */
export interface ShownMoment {
  values_s: number;  // the exposure of the shown picture, to which hand, force and phase belong
  seek_s: number;    // a seek to this position shows the same picture again
}

/** A seek shows the newest image that was published before its position. */
const BEHIND_S = 0.001;
/** Without images, the page shows the newest of the station's states, which come each 10 ms. */
const NEWEST_MS = 50;

/**
 * The moment of the shown picture, or of the shown numbers in a session without images. It is the player's position while
 * the player's newest image is not known, or is not yet the shown one of a paused session.
 */
export function shownMoment(
    {position_s, playing, shown}: PlaybackState,
    reading: Pick<Reading, 'pictureInstant_ms' | 'picturePublished_ms' | 'numbersInstant_ms'>): ShownMoment {
  const instant_ms = reading.pictureInstant_ms ?? reading.numbersInstant_ms;
  const position = {values_s: position_s, seek_s: position_s};
  if (shown === undefined || instant_ms === undefined) return position;
  const away_ms = Math.abs(instant_ms - shown.at_ms);
  if (!playing && away_ms > (reading.pictureInstant_ms === undefined ? NEWEST_MS : 0)) return position;
  const place = (at_ms: number) => shown.at_s + (shown.speed * (at_ms - shown.at_ms)) / 1000;
  return {values_s: place(instant_ms), seek_s: place(reading.picturePublished_ms ?? instant_ms) + BEHIND_S};
}
