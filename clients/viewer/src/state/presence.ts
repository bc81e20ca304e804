import type {HandHolder, ServerStats} from '../messages/generated';

/** What decides who is named as touching, and which browser is this one. */
export interface Presence {
  stats: ServerStats | undefined;
  touching: number;      // number of the sender of the newest /station/state; 0: none
  holder: HandHolder;
  me: bigint;            // this page's number at the server
  playsSession: boolean;
}

/** False: no station is known, or the messages of the newest one come from a recorded session. */
export function stationIsLive({stats, touching}: Pick<Presence, 'stats' | 'touching'>): boolean {
  return touching !== 0 && (stats?.subscribers.some(({sender}) => sender === touching) ?? false);
}

/** What other traffic leaves of the line of the station that touches, in bytes per second; undefined: none was noticed. */
export function lineLeft({stats, touching}: Pick<Presence, 'stats' | 'touching'>): number | undefined {
  return touching === 0 ? undefined : stats?.subscribers.find(({sender}) => sender === touching)?.shareBPerS;
}
