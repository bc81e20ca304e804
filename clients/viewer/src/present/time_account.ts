/**
 * The times of a picture on its way to this page, in milliseconds on this computer's clock; session times are converted
 * to it.
 */
export interface FrameTimes {
  captured_ms: number;
  published_ms: number;
  complete_ms: number;  // when both the frame and the station's state of the same instant were here
}

/** The input of the account of a picture's age. */
export interface Evidence {
  shown: FrameTimes & {drawn_ms: number};
  next: FrameTimes | undefined;  // the first newer instant that has arrived and is not drawn yet
  heard: {published_ms: number; received_ms: number};  // the newest message of any topic
}

export type Place = 'site' | 'network' | 'computer';

/** The age of the displayed picture, split by cause. The parts add up to the age, apart from the clock error. */
export type TimeAccount = Record<Place, number>;

/** The server sends a message each second, so a longer silence is the network's. */
const HEARTBEAT_MS = 1200;

/** Splits the age of the picture displayed at `now_ms` by cause. */
export function accountFor({shown, next, heard}: Evidence, now_ms: number): TimeAccount {
  const arrived_ms = Math.max(shown.drawn_ms, next === undefined ? now_ms : Math.min(now_ms, next.complete_ms));
  const waited_ms = arrived_ms - shown.drawn_ms;
  const silent = now_ms - heard.received_ms > HEARTBEAT_MS;
  // Until this time the patient's site sent no newer picture. Later it has sent one, or may have sent one.
  const published_ms = next?.published_ms ?? (silent ? heard.published_ms : Infinity);
  const siteWaited_ms = Math.min(waited_ms, Math.max(0, published_ms - shown.published_ms));
  return {
    site: shown.published_ms - shown.captured_ms + siteWaited_ms,
    network: Math.max(0, shown.complete_ms - shown.published_ms) + waited_ms - siteWaited_ms,
    computer: Math.max(0, shown.drawn_ms - shown.complete_ms) + Math.max(0, now_ms - arrived_ms),
  };
}

export const total_ms = (account: TimeAccount) => account.site + account.network + account.computer;

/** The part of the account with the most time. */
export function slowest(account: TimeAccount): Place {
  const places = Object.keys(account) as Place[];
  return places.reduce((most, place) => (account[place] > account[most] ? place : most));
}

const KEPT_MS = 1000;

/** The account of the oldest picture of the last second: so that the displayed text does not flicker. */
export class WorstOfSecond {
  private kept: {account: TimeAccount; at_ms: number} | undefined;

  note(account: TimeAccount, now_ms: number): TimeAccount {
    const {kept} = this;
    if (kept === undefined || now_ms - kept.at_ms > KEPT_MS || total_ms(account) >= total_ms(kept.account))
      this.kept = {account, at_ms: now_ms};
    return this.kept!.account;
  }
}
