import {element, made, oneLine, setText} from '../../page/page';
import {type Playback, seekTo} from '../../playback/playback_state';
import {keyOf, type Note, noteInAddress, type Notes} from '../../playback/session_notes';
import {clock} from '../../playback/timeline_words';

const SAME_S = 0.006;  // an address rounds moments to 0.01 s

/** QA's notes on the played session: written at the shown moment, listed, and pressed to go there. */
export class NotesCard {
  private readonly card = element('notes-card');
  private readonly form = element<HTMLFormElement>('note-form');
  private readonly text = element<HTMLInputElement>('note-text');
  private readonly list = element('notes');
  private chosen = noteInAddress(location.search);
  private noted_s: number | undefined;  // the moment at which the writing began
  private shown = '';
  private moment_s = 0;  // of the shown picture

  constructor(private readonly playback: Playback, private readonly notes: Notes) {
    notes.onChange(() => this.write());
    this.text.addEventListener('input', () => {
      if (this.text.value === '') this.noted_s = undefined;
      else this.noted_s ??= this.moment_s;
    });
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.add();
    });
  }

  /** `moment_s`: a seek to it shows the picture that the page shows now. */
  show(moment_s: number): void {
    const {state} = this.playback;
    this.moment_s = moment_s;
    this.card.hidden = state === undefined || this.notes.state === undefined;
    setText(element('note-at'), clock(this.noted_s ?? moment_s));
  }

  /** The chosen note, if the session stands at its moment. */
  numberAt(position_s: number): number | undefined {
    const note = this.notes.state?.find(({number}) => number === this.chosen);
    return note !== undefined && Math.abs(note.at_s - position_s) < SAME_S ? note.number : undefined;
  }

  private async add(): Promise<void> {
    const text = oneLine(this.text.value);
    const at_s = this.noted_s ?? this.moment_s;
    if (text === '') return;
    this.text.value = '';  // before the answer comes, so that a second press of Add finds an empty field
    this.noted_s = undefined;
    if (!(await this.notes.command({at_s, text})) && this.text.value === '') {
      this.text.value = text;
      this.noted_s = at_s;
    }
  }

  private write(): void {
    setText(element('notes-said'), this.notes.problem);
    const notes = this.notes.state ?? [];
    const shown = `${this.chosen} ${keyOf(notes)}`;
    if (shown === this.shown) return;
    this.shown = shown;
    this.list.replaceChildren(...notes.map((note) => this.line(note)));
  }

  private line({number, at_s, text, who, written}: Note): HTMLElement {
    const line = made('li', 'note');
    if (number === this.chosen) line.setAttribute('aria-current', 'true');
    const go = made('button', 'event', text);
    go.prepend(made('b', '', clock(at_s)));
    go.title = `${who}, ${written}`;
    go.addEventListener('click', () => {
      this.chosen = number;
      if (this.playback.state !== undefined) void this.playback.command({...seekTo(this.playback.state, at_s), play: false});
      this.write();
    });
    const remove = made('button', 'remove', '×');
    remove.setAttribute('aria-label', `Remove the note ${text}`);
    remove.title = 'Remove the note';
    remove.addEventListener('click', ({detail}) => {
      if (detail > 1) return;  // the second press of a double click would remove the note that moves up
      void this.notes.command({remove: number});
    });
    line.append(go, remove);
    return line;
  }
}
