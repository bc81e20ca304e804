/** A picture's way to this page. Milliseconds on this computer's clock; session times are brought to it. */
export interface FrameTimes {
  captured_ms: number;
  published_ms: number;
  complete_ms: number;  // received, and the station's word of the same instant too
}

/** What the account of a picture's age is made from. */
export interface Evidence {
  shown: FrameTimes & {drawn_ms: number};
  next: FrameTimes | undefined;  // the first newer instant that came and is not drawn yet
  heard: {published_ms: number; received_ms: number};  // the newest message of any topic
}

export type Place = 'site' | 'network' | 'computer';

/** The age of the picture shown, split by where the time went. The parts add up to the age, but for clock error. */
export type TimeAccount = Record<Place, number>;

/** The server says something each second; silence for longer than this is the network's. */
const HEARTBEAT_MS = 1200;

/** Where the age of the picture shown at `now_ms` came from. */
export function accountFor({shown, next, heard}: Evidence, now_ms: number): TimeAccount {
  const arrived_ms = Math.max(shown.drawn_ms, next === undefined ? now_ms : Math.min(now_ms, next.complete_ms));
  const waited_ms = arrived_ms - shown.drawn_ms;
  const silent = now_ms - heard.received_ms > HEARTBEAT_MS;
  // Until then the patient's site is known to have sent no newer picture; what is later was sent, or may have been.
  const published_ms = next?.published_ms ?? (silent ? heard.published_ms : Infinity);
  const siteWaited_ms = Math.min(waited_ms, Math.max(0, published_ms - shown.published_ms));
  return {
    site: shown.published_ms - shown.captured_ms + siteWaited_ms,
    network: Math.max(0, shown.complete_ms - shown.published_ms) + waited_ms - siteWaited_ms,
    computer: Math.max(0, shown.drawn_ms - shown.complete_ms) + Math.max(0, now_ms - arrived_ms),
  };
}

export const total_ms = (account: TimeAccount) => account.site + account.network + account.computer;

/** Where most of the time went. */
export function slowest(account: TimeAccount): Place {
  const places = Object.keys(account) as Place[];
  return places.reduce((most, place) => (account[place] > account[most] ? place : most));
}

const KEPT_MS = 1000;

/** The account of the oldest picture of the last second: what is told does not flicker from one drawing to the next. */
export class WorstOfSecond {
  private kept: {account: TimeAccount; at_ms: number} | undefined;

  note(account: TimeAccount, now_ms: number): TimeAccount {
    const {kept} = this;
    if (kept === undefined || now_ms - kept.at_ms > KEPT_MS || total_ms(account) >= total_ms(kept.account))
      this.kept = {account, at_ms: now_ms};
    return this.kept!.account;
  }
}
