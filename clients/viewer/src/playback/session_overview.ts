import {EventKind, Phase} from '../link/messages';
import {changeInWords} from '../panel/phases';

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

const KINDS = ['UNSPECIFIED', 'PHASE', 'LINK', 'FAULT', 'DEADLINE', 'SCENE', 'HEAT'];
const PHASES = ['UNSPECIFIED', 'IN_BODY', 'BODY_TO_PLANE', 'OUT_BODY', 'PLANE_TO_BODY', 'CYLINDER_LATERAL', 'AROUND_CYLINDER',
                'CYLINDER_UPPER', 'RELEASED', 'FAULTED'];

/** The number of an enum value, which Protobuf's JSON gives by name; 0 for a name that only a newer server has. */
const numberOf = (names: readonly string[], prefix: string, name: unknown) =>
    Math.max(0, names.findIndex((known) => name === prefix + known));

/** The phase that Protobuf's JSON calls `name`. */
export const phaseNamed = (name: unknown): Phase => numberOf(PHASES, 'PHASE_', name);

/** Reads the reply to GET /playback/events; undefined if it cannot be read. */
export function readOverview(text: string): SessionOverview | undefined {
  try {
    const {events, complete} = JSON.parse(text) as {events?: Record<string, unknown>[]; complete?: boolean};
    if (!Array.isArray(events)) return undefined;
    return {
      complete: complete === true,
      events: events.map(({at_s, kind: name, text: says, from, to}) => {
        const kind = numberOf(KINDS, 'EVENT_KIND_', name);
        const text = kind === EventKind.Phase ? changeInWords(phaseNamed(from), phaseNamed(to)) : String(says);
        return {at_s: Number(at_s), kind, text, to: phaseNamed(to)};
      }),
    };
  } catch {
    return undefined;
  }
}

/** The phases from the first phase change to the session's end. No span covers the unknown phase before. */
export function spansOf({events}: SessionOverview, duration_s: number): OverviewSpan[] {
  const changes = events.filter(({kind}) => kind === EventKind.Phase);
  return changes.map(({at_s, to}, at) => ({phase: to, from_s: at_s, to_s: changes[at + 1]?.at_s ?? duration_s}))
      .filter(({from_s, to_s}) => to_s > from_s);
}

/** The events to mark: faults, missed deadlines, warm motors, and all events of the link to the server. */
export function marksOf({events}: SessionOverview): SessionEvent[] {
  return events.filter(({kind}) => kind === EventKind.Fault || kind === EventKind.Deadline || kind === EventKind.Heat || kind === EventKind.Link);
}
