import {EventKind, Phase} from '../messages/generated';
import {changeInWords} from '../words/phases';

/** An event of the whole session, at seconds from its beginning. */
export interface SessionEvent {
  at_s: number;
  kind: EventKind;
  text: string;
  to: Phase;  // the new phase, if `kind` is Phase
}

export interface SessionOverview {
  events: readonly SessionEvent[];
  complete: boolean;  // false: the server is still reading the file
}

/** A time in which the phase did not change. */
export interface OverviewSpan {
  phase: Phase;
  from_s: number;
  to_s: number;
}

/** The number of an enum value, which Protobuf's JSON gives by name; 0 for a name that only a newer server has. */
function numberOf(values: Record<string, number | string>, prefix: string, name: unknown): number {
  const number = typeof name === 'string' && name.startsWith(prefix) ? values[name.slice(prefix.length)] : undefined;
  return typeof number === 'number' ? number : 0;
}

/** The phase that Protobuf's JSON calls `name`. */
export const phaseNamed = (name: unknown): Phase => numberOf(Phase, 'PHASE_', name);

/** Reads the reply to GET /playback/events; undefined if it cannot be read. */
export function readOverview(text: string): SessionOverview | undefined {
  try {
    const {events, complete} = JSON.parse(text) as {events?: Record<string, unknown>[]; complete?: boolean};
    if (!Array.isArray(events)) return undefined;
    return {
      complete: complete === true,
      events: events.map(({at_s, kind: name, text: says, from, to}) => {
        const kind = numberOf(EventKind, 'EVENT_KIND_', name);
        const text = kind === EventKind.PHASE ? changeInWords(phaseNamed(from), phaseNamed(to)) : String(says);
        return {at_s: Number(at_s), kind, text, to: phaseNamed(to)};
      }),
    };
  } catch {
    return undefined;
  }
}

/** The phases from the first phase change to the session's end. No span covers the unknown phase before. */
export function spansOf({events}: SessionOverview, duration_s: number): OverviewSpan[] {
  const changes = events.filter(({kind}) => kind === EventKind.PHASE);
  return changes.map(({at_s, to}, at) => ({phase: to, from_s: at_s, to_s: changes[at + 1]?.at_s ?? duration_s}))
      .filter(({from_s, to_s}) => to_s > from_s);
}

/** The events to mark: faults, missed deadlines, warm motors, and all events of the link to the server. */
export function marksOf({events}: SessionOverview): SessionEvent[] {
  return events.filter(({kind}) => kind === EventKind.FAULT || kind === EventKind.DEADLINE || kind === EventKind.HEAT || kind === EventKind.LINK);
}
