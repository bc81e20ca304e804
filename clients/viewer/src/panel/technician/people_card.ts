import type {Resource} from '../../link/resource';
import type {PeopleState as PeopleMessage} from '../../messages/generated';
import {element, setText} from '../../page/page';

/** The body of POST /people. */
export type PeopleCommand = {send_out: string} | {let_in: string} | {take_touch: true};

export interface Person {
  who: string;  // "doctor anna"
  key: string;  // serial number of the key or token
  says: string;  // the row's tooltip: the person's streams, or when the person may come back
}

/** Who sees the patient, one row for each key, and who was sent out. */
export interface PeopleState {
  present: readonly Person[];
  sentOut: readonly Person[];
  holdsTouch: string;  // empty: nobody
  anchor: string;  // a signed position of the audit log, to be kept elsewhere
  alarm: string;  // empty: none
}
export type People = Resource<PeopleMessage, PeopleMessage, PeopleCommand>;

export function readPeople({people, holdsTouch, sentOut, anchor, alarm}: PeopleMessage): PeopleState {
  const present = new Map<string, {who: string; streams: string[]}>();
  for (const {name, role, key, program, from, since} of people) {
    const one = present.get(key) ?? {who: `${role} ${name}`, streams: []};
    one.streams.push(`${program} from ${from} since ${since}`);
    present.set(key, one);
  }
  return {
    present: [...present].map(([key, {who, streams}]) =>
      ({who: streams.length > 1 ? `${who} (${streams.length})` : who, key, says: streams.join('\n')})),
    sentOut: sentOut.map(({name, role, key}) => ({who: `${role} ${name}`, key, says: `Key ${key}. May come back after 15 minutes.`})),
    holdsTouch, anchor, alarm,
  };
}

/** What the card says below its rows. */
export const peopleSay = ({holdsTouch, alarm}: PeopleState): string =>
    alarm !== '' ? `Alarm: ${alarm}` : holdsTouch === '' ? 'Nobody holds the touch.' : `Doctor ${holdsTouch} holds the touch.`;

/** Shows who sees the patient. One press sends a person out, or takes the touch away. */
export class PeopleCard {
  private readonly list = element('people-list');
  private readonly takeTouch = element<HTMLButtonElement>('people-take-touch');
  private shown = '';

  constructor(private readonly people: People) {
    people.onChange(() => this.write());
    this.write();
    this.takeTouch.addEventListener('click', () => void people.command({take_touch: true}));
  }

  private write(): void {
    const {state: message, problem} = this.people;
    element('people-card').hidden = message === undefined;
    if (message === undefined) return;
    const state = readPeople(message);
    const shown = JSON.stringify([state.present, state.sentOut]);
    if (shown !== this.shown) {
      this.list.replaceChildren(
          ...state.present.map((person) => this.row(person, 'Send out', {send_out: person.key})),
          ...state.sentOut.map((person) => this.row(person, 'Let in', {let_in: person.key})));
    }
    this.shown = shown;
    this.takeTouch.disabled = state.holdsTouch === '';
    setText(element('people-said'), problem === '' ? peopleSay(state) : problem);
    setText(element('people-anchor'), state.anchor);
  }

  private row({who, says}: Person, does: string, command: PeopleCommand): HTMLElement {
    const row = document.createElement('p');
    row.className = 'acts';
    row.title = says;
    const name = document.createElement('span');
    name.textContent = who;
    const button = document.createElement('button');
    button.textContent = does;
    button.setAttribute('aria-label', `${does}: ${who}`);
    button.addEventListener('click', () => void this.people.command(command));
    row.append(name, button);
    return row;
  }
}
