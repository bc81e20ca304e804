import {EventKind, Phase} from '../link/messages';

/** An event of the whole session, at seconds from its beginning. */
export interface SessionEvent {
  at_s: number;
  kind: EventKind;
  text: string;
  to: Phase;  // of a change of phase
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

/** The number of an enum's value, which Protobuf's JSON names; 0 for a name of a newer server. */
const numberOf = (names: readonly string[], prefix: string, name: unknown) =>
    Math.max(0, names.findIndex((known) => name === prefix + known));

/** Reads the reply to GET /playback/events; undefined when it is none. */
export function readOverview(text: string): SessionOverview | undefined {
  try {
    const {events, complete} = JSON.parse(text) as {events?: Record<string, unknown>[]; complete?: boolean};
    if (!Array.isArray(events)) return undefined;
    return {
      complete: complete === true,
      events: events.map(({at_s, kind, text: says, to}) => ({
        at_s: Number(at_s), kind: numberOf(KINDS, 'EVENT_KIND_', kind), text: String(says), to: numberOf(PHASES, 'PHASE_', to),
      })),
    };
  } catch {
    return undefined;
  }
}

/** The phases from the first change of phase to the session's end. The phase before that change is unknown, so no span covers it. */
export function spansOf({events}: SessionOverview, duration_s: number): OverviewSpan[] {
  const changes = events.filter(({kind}) => kind === EventKind.Phase);
  return changes.map(({at_s, to}, at) => ({phase: to, from_s: at_s, to_s: changes[at + 1]?.at_s ?? duration_s}))
      .filter(({from_s, to_s}) => to_s > from_s);
}

/** The events that matter in an overview: faults, missed deadlines, heat, lost links. */
export function marksOf({events}: SessionOverview): SessionEvent[] {
  return events.filter(({kind}) => kind === EventKind.Fault || kind === EventKind.Deadline || kind === EventKind.Heat || kind === EventKind.Link);
}
