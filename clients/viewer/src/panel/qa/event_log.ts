import {EventKind, type StationEvent} from '../../messages/generated';
import {changeInWords} from '../../words/phases';
import type {SessionEvent} from '../../playback/session_overview';

const MOST_KEPT = 500;

/** An event of the station, with its place in the played session. */
export interface LoggedEvent {
  stampNs: bigint;
  kind: EventKind;
  text: string;
  position_s: number | undefined;  // from the session's beginning; undefined: the server plays none
}

/** How the server plays: `at_ns` of the session clock is `position_s` of the session. */
export interface PlayedNow {
  at_ns: bigint;
  position_s: number;
  speed: number;
}

/** The events so far, the newest first. A second pass over the same part of a session adds nothing. */
export class EventLog {
  events: LoggedEvent[] = [];
  private newest_ns = 0n;
  private whole: readonly SessionEvent[] | undefined;

  /** `heard`: the latest events of the link, oldest first. `played`: undefined for a live patient. */
  add(heard: readonly StationEvent[], played: PlayedNow | undefined): void {
    for (const {stampNs, kind, text: says, from, to} of heard) {
      const text = kind === EventKind.PHASE ? changeInWords(from, to) : says;
      if (this.whole !== undefined || stampNs <= this.newest_ns) continue;
      this.newest_ns = stampNs;
      const position_s = played && positionOf(stampNs, played);
      if (position_s !== undefined && this.events.some((known) => isSame(known, text, position_s))) continue;
      this.events.unshift({stampNs, kind, text, position_s});
    }
    if (this.events.length > MOST_KEPT) this.events.length = MOST_KEPT;
  }

  /**
   * Replaces the events received so far by those of the whole session. `whole`: undefined while they are not
   * known; events of another session are then forgotten.
   */
  know(whole: readonly SessionEvent[] | undefined): void {
    if (whole === this.whole || whole?.length === 0) return;
    if (whole === undefined) return this.forget();
    this.whole = whole;
    this.events = whole.slice(0, MOST_KEPT).map(({at_s, kind, text}) => ({stampNs: 0n, kind, text, position_s: at_s})).reverse();
  }

  /** A new connection may be to another server, whose clock is another one. */
  forget(): void {
    this.events = [];
    this.newest_ns = 0n;
    this.whole = undefined;
  }
}

function positionOf(stampNs: bigint, {at_ns, position_s, speed}: PlayedNow): number {
  return Math.max(0, position_s - (speed * Number(at_ns - stampNs)) / 1e9);
}

const SAME_S = 0.7;  // the position is asked for twice a second

function isSame(known: LoggedEvent, text: string, position_s: number): boolean {
  return known.text === text && known.position_s !== undefined && Math.abs(known.position_s - position_s) < SAME_S;
}
