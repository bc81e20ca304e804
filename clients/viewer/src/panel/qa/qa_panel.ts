import {milliseconds} from '../../link/session_clock';
import {element, made, setText} from '../../page/page';
import {saveFile} from '../../page/save_file';
import {addressOfMoment} from '../../playback/moment';
import type {OverviewBand} from '../../playback/overview_band';
import {type Playback, seekTo} from '../../playback/playback_state';
import type {Notes} from '../../playback/session_notes';
import {type ShownMoment, shownMoment} from '../../playback/shown_moment';
import {clock} from '../../playback/timeline_words';
import {forcesOf, type Instant} from '../../present/instant';
import type {SceneView} from '../../scene/scene_view';
import type {Reading} from '../../state/viewer_state';
import {toneOf} from '../../words/event_tone';
import {type Comparison, ComparisonCard} from './comparison/comparison_card';
import {EventLog, type LoggedEvent} from './event_log';
import {type ImpairedNetwork, NetworkCard} from './network_card';
import {NotesCard} from './notes_card';
import {withText} from './snapshot';
import {type SnapshotFacts, snapshotLines} from './snapshot_words';

const MOST_LINES = 400;

/**
 * QA's cards: the moment, to be shared or kept as a picture, notes, another session beside this one, the impaired
 * network, and the session's events.
 */
export class QaPanel {
  private readonly log = new EventLog();
  private readonly list = element('events');
  private readonly said = element('moment-said');
  private readonly network: NetworkCard;
  private readonly notesCard: NotesCard;
  private readonly comparison: ComparisonCard;
  private shown: LoggedEvent | undefined;  // the newest event in the list
  private reading: Reading | undefined;
  private moment: ShownMoment | undefined;  // undefined: no session can be moved

  constructor(
      private readonly playback: Playback, private readonly whole: OverviewBand,
      parts: {notes: Notes; network: ImpairedNetwork; comparison: Comparison},
      private readonly view: SceneView, private readonly inScene: () => Instant | undefined) {
    this.network = new NetworkCard(parts.network);
    this.notesCard = new NotesCard(playback, parts.notes);
    this.comparison = new ComparisonCard(playback, parts.comparison);
    element('share').addEventListener('click', () => void this.share());
    element('snapshot').addEventListener('click', () => void this.snapshot());
  }

  show(reading: Reading): void {
    const {connected, events, sessionNow_ns, presence} = reading;
    this.reading = reading;
    const {state} = this.playback;
    this.moment = state && shownMoment(state, reading);
    this.network.show(state !== undefined);
    this.notesCard.show(this.moment?.seek_s ?? 0);
    this.comparison.show(this.moment?.values_s ?? 0);
    setText(element('moment'), state === undefined ? presence.playsSession ? 'recorded' : 'live' : `${clock(this.moment?.seek_s ?? 0)} of ${clock(state.duration_s)}`);
    element<HTMLButtonElement>('share').disabled = state === undefined;
    const whole = state && this.whole.overview?.events;
    if (!connected && whole === undefined) this.log.forget();
    const played = state && sessionNow_ns !== undefined
        ? {at_ns: sessionNow_ns, position_s: state.position_s, speed: state.speed} : undefined;
    this.log.add(events, played);
    this.log.know(whole);
    this.showEvents();
  }

  private showEvents(): void {
    const {events: [newest]} = this.log;
    if (newest === this.shown) return;
    this.shown = newest;
    this.list.replaceChildren(...this.log.events.slice(0, MOST_LINES).map((event) => this.line(event)));
    element('no-events').hidden = this.log.events.length > 0;
  }

  private line(event: LoggedEvent): HTMLElement {
    const line = made('li', toneOf(event.kind));
    const {position_s} = event;
    if (position_s === undefined) {
      line.append(made('span', '', event.text));
      return line;
    }
    const button = made('button', 'event', event.text);
    button.prepend(made('b', '', clock(position_s)));
    button.title = 'Go to this moment';
    button.addEventListener('click', () => {
      const {state} = this.playback;
      if (state !== undefined) void this.playback.command(seekTo(state, position_s));
    });
    line.append(button);
    return line;
  }

  private async share(): Promise<void> {
    if (this.moment === undefined) return;
    const {seek_s} = this.moment;
    const address = addressOfMoment(location.href, seek_s, this.notesCard.numberAt(seek_s));
    history.replaceState(null, '', address);
    try {
      await navigator.clipboard.writeText(address);
      setText(this.said, 'The address of this moment is copied.');
    } catch {
      setText(this.said, 'The address of this moment is in the address bar.');
    }
  }

  /** Of the instant that is in the scene now, and that pictureNow() draws. */
  private snapshotFacts(): SnapshotFacts {
    const {station, picture} = this.inScene() ?? {};
    const {reading} = this;
    const {state} = this.playback;
    const captured_ms = picture === undefined ? reading?.pictureInstant_ms : milliseconds(picture.captured_ns);
    const published_ms = picture === undefined ? reading?.picturePublished_ms : milliseconds(picture.published_ns);
    const moment_s = state && shownMoment(
        state, {pictureInstant_ms: captured_ms, picturePublished_ms: published_ms, numbersInstant_ms: reading?.numbersInstant_ms}).values_s;
    return {
      forces: station && forcesOf(station),
      indentation_m: station?.indentationM,
      phase: station?.phase,
      exposed_ms: state === undefined || moment_s === undefined ? captured_ms : state.begin_ms + 1000 * moment_s,
      source: reading?.capture?.source ?? 'unknown source',
      moment_s,
      stale: reading?.stale === true || reading?.connected === false,
    };
  }

  private async snapshot(): Promise<void> {
    const facts = this.snapshotFacts();
    const picture = await withText(this.view.pictureNow(), snapshotLines(facts));
    if (picture === undefined) return setText(this.said, 'The browser could not make the picture: try again, or use another browser.');
    const name = `telepalp_${facts.moment_s === undefined ? new Date().toISOString().replace(/[:.]/g, '-') : `${facts.moment_s.toFixed(2)}s`}.png`;
    saveFile(name, 'image/png', picture);
    setText(this.said, `Saved as ${name}.`);
  }
}
