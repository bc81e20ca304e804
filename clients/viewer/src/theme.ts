import {browserStore, element, keep} from './page/page';
import type {SceneView} from './scene/scene_view';

type Theme = 'dark' | 'light';

const KEPT_AS = 'telepalp-theme';
const BACKGROUND: Record<Theme, string> = {dark: '#070b10', light: '#dfe6ec'};

const keptTheme = (): Theme => (browserStore()?.getItem(KEPT_AS) === 'light' ? 'light' : 'dark');

/** Dark for dim rooms, light for bright ones; the choice is kept in this browser. */
export class ThemeSwitch {
  private theme = keptTheme();
  private readonly button = element<HTMLButtonElement>('theme');

  constructor(private readonly view: SceneView) {
    this.button.addEventListener('click', () => this.flip());
    this.apply();
  }

  flip(): void {
    this.theme = this.theme === 'dark' ? 'light' : 'dark';
    keep(browserStore(), KEPT_AS, this.theme);
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset['theme'] = this.theme;
    this.button.setAttribute('aria-pressed', String(this.theme === 'light'));
    this.view.setBackground(BACKGROUND[this.theme]);
  }
}
