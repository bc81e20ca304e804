import {element, made} from '../page/page';
import {toneOf} from '../words/event_tone';
import {lookOf} from '../words/phases';
import {askServer} from '../link/ask_server';
import type {PlayedPart} from './played_part';
import type {PlaybackLink} from './playback_link';
import {seekTo} from './playback_state';
import {keyOf, type Note} from './session_notes';
import {marksOf, readOverview, type SessionOverview, spansOf} from './session_overview';
import {clock} from './timeline_words';

const ASK_EVERY_MS = 1000;

/**
 * The played session above the timeline's slider: phases as a band; faults, missed deadlines, heat, link and notes as
 * marks.
 */
export class OverviewBand {
  overview: SessionOverview | undefined;

  private readonly band = element('overview');
  private drawn = '';
  private session = '';  // the session that `overview` describes

  constructor(private readonly link: PlaybackLink, private readonly notes: Pick<PlayedPart<Note[], object>, 'state'>) {
    this.band.addEventListener('click', (event) => this.seek(event));
    window.setInterval(() => void this.look(), ASK_EVERY_MS);
  }

  private async look(): Promise<void> {
    const {state} = this.link;
    if (state?.session !== this.session) this.overview = undefined;
    this.session = state?.session ?? '';
    if (state !== undefined && this.overview?.complete !== true) this.overview = (await ask()) ?? this.overview;
    this.draw();
  }

  draw(): void {
    const duration_s = this.link.state?.duration_s ?? 0;
    const notes = duration_s > 0 ? this.notes.state ?? [] : [];
    const drawn = `${this.session} ${this.overview?.events.length ?? 0} in ${duration_s}, ${keyOf(notes)}`;
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    const spans = this.overview === undefined || duration_s <= 0 ? [] : spansOf(this.overview, duration_s);
    const marks = this.overview === undefined || duration_s <= 0 ? [] : marksOf(this.overview);
    this.band.hidden = spans.length + marks.length + notes.length === 0;
    const place = (part: HTMLElement, from_s: number, to_s: number) => {
      part.style.left = `${(100 * from_s) / duration_s}%`;
      part.style.width = `${(100 * (to_s - from_s)) / duration_s}%`;
      return part;
    };
    this.band.replaceChildren(
        ...spans.map(({phase, from_s, to_s}) => {
          const {name, tone} = lookOf(phase);
          const part = place(made('i'), from_s, to_s);
          part.dataset['tone'] = tone;
          part.title = `${clock(from_s)} to ${clock(to_s)}: ${name}`;
          return part;
        }),
        ...marks.map(({at_s, kind, text}) => {
          const part = place(made('b', toneOf(kind)), at_s, at_s);
          part.title = `${clock(at_s)}: ${text}`;
          return part;
        }),
        ...notes.map(({at_s, text}) => {
          const part = place(made('b', 'note'), at_s, at_s);
          part.title = `${clock(at_s)}: ${text}`;
          return part;
        }));
  }

  private seek({clientX}: MouseEvent): void {
    const {state} = this.link;
    const {left, width} = this.band.getBoundingClientRect();
    if (state === undefined || width === 0) return;
    const share = Math.min(1, Math.max(0, (clientX - left) / width));
    void this.link.command(seekTo(state, share * state.duration_s));
  }
}

const askEvents = askServer('playback/events');

async function ask(): Promise<SessionOverview | undefined> {
  const answer = await askEvents();
  return answer?.status === 200 ? readOverview(answer.text) : undefined;
}
