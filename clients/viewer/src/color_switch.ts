import {element, keep, setText} from './page/page';
import type {ColorCoding} from './present/color_choice';

const KEPT_AS = 'telepalp-color';

/** The box *Colour as video*. `?color=video` in the page's address checks it, too. The choice is kept in this browser. */
export class ColorSwitch {
  private readonly box = element<HTMLInputElement>('color-video');
  private readonly saying = element('color-said');

  constructor(store: Pick<Storage, 'getItem' | 'setItem'> | undefined, ask: (coding: ColorCoding) => void) {
    const coding = () => (this.box.checked ? 'video' : 'pictures');
    const named = new URLSearchParams(location.search).get('color');
    this.box.checked = (named ?? store?.getItem(KEPT_AS)) === 'video';
    if (this.box.checked) ask('video');
    this.box.addEventListener('change', () => {
      keep(store, KEPT_AS, coding());
      ask(coding());
    });
  }

  show(said: string): void {
    setText(this.saying, said);
  }
}
