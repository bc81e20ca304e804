import {EventKind, type Phase, type SessionEvents, type SessionEvents_Speech} from '../messages/generated';
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
  speech: readonly SessionEvents_Speech[];  // where somebody speaks, of both sides
}

/** A time in which the phase did not change. */
export interface OverviewSpan {
  phase: Phase;
  from_s: number;
  to_s: number;
}

export function readOverview({events, complete, speech}: SessionEvents): SessionOverview {
  return {
    complete,
    speech,
    events: events.map(({atS, kind, text, from, to}) =>
        ({at_s: atS, kind, text: kind === EventKind.PHASE ? changeInWords(from, to) : text, to})),
  };
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
