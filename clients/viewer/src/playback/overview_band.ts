import {element, later, made} from '../page/page';
import {toneOf} from '../words/event_tone';
import {lookOf} from '../words/phases';
import {type Playback, seekTo} from './playback_state';
import {keyOf, type Notes} from './session_notes';
import {marksOf, type SessionOverview, spansOf} from './session_overview';
import {clock} from './timeline_words';

/**
 * The played session above the timeline's slider: phases as a band; faults, missed deadlines, heat, link and notes as
 * marks. Below them, where somebody speaks: its code is loaded with the first session that has speech.
 */
export class OverviewBand {
  overview: SessionOverview | undefined;

  private readonly band = element('overview');
  private drawn = '';
  private spoken = 0;  // times in the lanes

  constructor(private readonly playback: Playback, private readonly notes: Notes) {
    this.band.addEventListener('click', (event) => this.seek(event));
    playback.onChange(() => this.draw());
    notes.onChange(() => this.draw());
  }

  /** undefined: no session is played. */
  know(overview: SessionOverview | undefined): void {
    this.overview = overview;
    this.drawn = '';  // other events may be as many
    this.draw();
  }

  private draw(): void {
    const duration_s = this.playback.state?.duration_s ?? 0;
    const notes = duration_s > 0 ? this.notes.state ?? [] : [];
    const speech = this.overview?.speech ?? [];
    const drawn = `${this.playback.state?.session} ${this.overview?.events.length ?? 0} ${speech.length} in ${duration_s}, ${keyOf(notes)}`;
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    if (this.spoken + speech.length > 0)
      void later<typeof import('./voice_lanes')>('voice_lanes.js').then(({drawLanes}) => drawLanes(this.band, speech, duration_s));
    this.spoken = speech.length;
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
    const {state} = this.playback;
    const {left, width} = this.band.getBoundingClientRect();
    if (state === undefined || width === 0) return;
    const share = Math.min(1, Math.max(0, (clientX - left) / width));
    void this.playback.command(seekTo(state, share * state.duration_s));
  }
}
