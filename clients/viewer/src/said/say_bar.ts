import type {Resource} from '../link/resource';
import type {LiveNote, MarksState, Vec3} from '../messages/generated';
import {element} from '../page/page';
import {inWords, standing} from './standing';

/** The body of POST /marks. */
export interface MarkCommand {
  ago_s?: number;
  text?: string;
  at_m?: Vec3;
}
export type Marks = Resource<MarksState, MarksState, MarkCommand>;

/**
 * Short words to the others on the picture, with an arrow on the patient: the button *Say*, the line to write in, and the
 * lines that stand on the picture for a while. Pointing takes one press on the picture.
 */
export class SayBar {
  private readonly button = element<HTMLButtonElement>('say');
  private readonly form = element<HTMLFormElement>('say-form');
  private readonly text = element<HTMLInputElement>('say-text');
  private readonly pointing = element<HTMLButtonElement>('say-point');
  private readonly lines = element('said');
  private at_m: Vec3 | undefined;
  private shown = '';

  constructor(
      private readonly marks: Marks, private readonly canvas: HTMLCanvasElement,
      private readonly placeUnder: (clientX: number, clientY: number) => Vec3 | undefined,
      private readonly showPlaces: (places: readonly Vec3[]) => void, private readonly explain: (problem: string) => void) {
    this.button.addEventListener('click', () => this.open(this.form.hidden));
    this.pointing.addEventListener('click', () => this.point(!this.waitsForPlace));
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.say();
    });
    this.form.addEventListener('keydown', ({key}) => key === 'Escape' && this.open(false));
    // In the capture phase, so that this press neither turns the view nor moves the hand.
    canvas.addEventListener('pointerdown', (event) => this.waitsForPlace && this.take(event), {capture: true});
  }

  open(wanted: boolean): void {
    if (this.button.hidden) return;
    this.form.hidden = !wanted;
    this.button.setAttribute('aria-expanded', String(wanted));
    if (wanted) this.text.focus();
    else this.forget();
  }

  /** Shows what the others said lately. Only users who may mark see the button. */
  show(now_ns: bigint | undefined, mayMark: boolean): void {
    this.button.hidden = !mayMark;
    if (!mayMark) this.form.hidden = true;
    const said = standing(this.marks.state, now_ns);
    const now = JSON.stringify([said.map((note) => [String(note.atNs), note.text]), this.at_m]);
    if (now === this.shown) return;
    this.shown = now;
    this.lines.replaceChildren(...said.map(lineOf));
    this.showPlaces([...said.map(({atM}) => atM), this.at_m].filter((place) => place !== undefined));
  }

  private get waitsForPlace(): boolean {
    return this.pointing.getAttribute('aria-pressed') === 'true';
  }

  private point(wanted: boolean): void {
    this.pointing.setAttribute('aria-pressed', String(wanted));
    this.canvas.classList.toggle('pointing', wanted);
  }

  private take(event: PointerEvent): void {
    event.stopImmediatePropagation();
    event.preventDefault();
    this.at_m = this.placeUnder(event.clientX, event.clientY);
    if (this.at_m === undefined) return this.explain('the camera measured nothing there. Press on the patient');
    this.point(false);
    this.text.focus();
  }

  private async say(): Promise<void> {
    const text = this.text.value.trim();
    if (text === '' && this.at_m === undefined) return this.text.focus();
    const said = await this.marks.command({text, ...(this.at_m && {at_m: this.at_m})});
    if (!said) return this.explain(this.marks.problem);
    this.forget();
    this.text.focus();
  }

  private forget(): void {
    this.text.value = '';
    this.at_m = undefined;
    this.point(false);
  }
}

function lineOf(note: LiveNote): HTMLElement {
  const line = document.createElement('p');
  line.textContent = inWords(note);
  return line;
}
