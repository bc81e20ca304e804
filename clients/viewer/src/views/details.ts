import {element} from '../page/page';
import type {KeptLayout} from './kept_layout';
import type {View} from './view';

const ROOM = '(min-width: 1021px) and (min-height: 601px)';  // in a smaller window they are closed until asked for
const PART = 'Details';

/** The column of a view's cards: open or closed, in each view as the user left it. */
export class Details {
  private readonly button = element<HTMLButtonElement>('show-side');
  private readonly room = window.matchMedia(ROOM);
  private view: View = 'doctor';

  constructor(private readonly layout: KeptLayout) {
    this.button.addEventListener('click', () => this.flip());
    this.room.addEventListener('change', () => this.fit());
    this.fit();
  }

  show(view: View): void {
    this.view = view;
    if (this.room.matches) this.fit();
  }

  flip(): void {
    const open = document.body.dataset['side'] !== 'open';
    this.set(open);
    if (this.room.matches) this.layout.set(this.view, PART, !open);
  }

  private fit(): void {
    this.set(this.room.matches && !this.layout.has(this.view, PART));
  }

  private set(open: boolean): void {
    document.body.dataset['side'] = open ? 'open' : 'closed';
    this.button.setAttribute('aria-pressed', String(open));
  }
}
