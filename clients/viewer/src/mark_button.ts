import {element} from './page/page';
import type {Marks} from './said/say_bar';

const LONGEST_AGO_S = 60;  // the server takes no older moment

/** How long ago the shown picture was taken [s]; undefined: none is shown, or the server's clock is not known. */
export function shownAgo_s(pictureInstant_ms: number | undefined, sessionNow_ns: bigint | undefined): number | undefined {
  if (pictureInstant_ms === undefined || sessionNow_ns === undefined) return undefined;
  return Math.min(LONGEST_AGO_S, Math.max(0, Number(sessionNow_ns) / 1e9 - pictureInstant_ms / 1e3));
}

/** Marks the moment that the page shows: a note of the recorded session. Only users who may mark see the button. */
export class MarkButton {
  private readonly button = element<HTMLButtonElement>('mark');

  constructor(
      private readonly marks: Marks, private readonly ago_s: () => number | undefined, private readonly explain: (problem: string) => void) {
    marks.onChange(() => this.show());
    this.button.addEventListener('click', () => void this.mark());
  }

  async mark(): Promise<void> {
    if (this.button.hidden) return;
    if (!(await this.marks.command({ago_s: this.ago_s() ?? 0}))) this.explain(this.marks.problem);
  }

  /** This visitor may mark moments and say words to the others. */
  get mayMark(): boolean {
    return !this.button.hidden;
  }

  private show(): void {
    const {state} = this.marks;
    this.button.hidden = state?.closed ?? true;
    this.button.textContent = state === undefined || state.count === 0 ? 'Mark' : `Mark · ${state.count}`;
  }
}
