import {EventKind} from '../messages/generated';

/** How much an event matters: faults and missed deadlines before changes of phase. */
export function toneOf(kind: EventKind): 'alarm' | 'warn' | 'plain' {
  if (kind === EventKind.FAULT) return 'alarm';
  return kind === EventKind.DEADLINE || kind === EventKind.HEAT || kind === EventKind.LINK ||
      kind === EventKind.DEVICE ? 'warn' : 'plain';
}
