import {element, keep, setText} from './page/page';
import type {ColorCoding} from './present/color_choice';

const KEPT_AS = 'telepalp-color';

/**
 * The box *Colour as video*. This browser keeps what the user chooses. `?color=video` or `?color=pictures` in the page's
 * address goes before the kept choice and is not kept.
 */
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

  /** `said`: which coding the page takes, in one sentence. */
  show(said: string): void {
    setText(this.saying, said);
  }
}
