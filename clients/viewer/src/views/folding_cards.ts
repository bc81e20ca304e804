import {element, made} from '../page/page';
import type {KeptLayout} from './kept_layout';
import type {View} from './view';

interface Card {
  name: string;
  box: HTMLElement;
  button: HTMLButtonElement;
}

/** Cards whose heading folds them to one line, with their first value beside the heading. Each view has its own folds. */
export class FoldingCards {
  private readonly cards: Card[] = [];
  private readonly all = element<HTMLButtonElement>('fold-all');
  private view: View = 'doctor';

  constructor(private readonly layout: KeptLayout) {
    this.all.addEventListener('click', () => this.foldAll());
    this.look();
  }

  /** Finds cards that have come meanwhile. */
  look(): void {
    for (const title of document.querySelectorAll<HTMLElement>('.card > h2'))
      if (title.firstElementChild === null) this.cards.push(this.open(title));
    this.show(this.view);
  }

  show(view: View): void {
    this.view = view;
    for (const card of this.cards) this.fold(card, this.layout.has(view, card.name));
    this.showAll();
  }

  /** Folds all cards of this view, or unfolds them if all are folded. */
  foldAll(): void {
    const wanted = !this.allFolded();
    for (const card of this.shown()) this.keep(card, wanted);
    this.showAll();
  }

  private shown(): Card[] {
    return this.cards.filter(({box}) => box.dataset['views'] === undefined || box.dataset['views'].split(' ').includes(this.view));
  }

  private allFolded(): boolean {
    return this.shown().every(({name}) => this.layout.has(this.view, name));
  }

  private showAll(): void {
    this.all.setAttribute('aria-pressed', String(this.allFolded()));
  }

  private open(title: HTMLElement): Card {
    const name = title.textContent ?? '';
    const button = made('button', 'fold', name);
    const card = {name, box: title.parentElement!, button};
    title.replaceChildren(button);
    button.addEventListener('click', () => {
      this.keep(card, !this.layout.has(this.view, name));
      this.showAll();
    });
    return card;
  }

  private keep(card: Card, folded: boolean): void {
    this.layout.set(this.view, card.name, folded);
    this.fold(card, folded);
  }

  private fold({box, button}: Card, folded: boolean): void {
    box.classList.toggle('folded', folded);
    button.setAttribute('aria-expanded', String(!folded));
  }
}
