import type {InsideView} from './inside/inside_view';
import type {MarkButton} from './mark_button';
import type {SayBar} from './said/say_bar';
import type {ViewerHandInput} from './touch/viewer_hand';
import type {SceneView} from './scene/scene_view';
import type {ThemeSwitch} from './theme';
import type {Details} from './views/details';
import type {FoldingCards} from './views/folding_cards';
import type {ViewSwitch} from './views/view_switch';
import type {VoiceButton} from './voice_button';

const TURN_RAD = 0.09;
const ZOOM = 1.12;

interface Toggle {
  button: string;
  key: string;
  apply: (shown: boolean) => void;
}

function button(id: string): HTMLButtonElement {
  const found = document.getElementById(id);
  if (!(found instanceof HTMLButtonElement)) throw new Error(`index.html has no button #${id}`);
  return found;
}

/** True if the focused element uses `key` itself. A slider or a check box uses no letters and digits. */
function takesKey(focus: EventTarget | null, key: string): boolean {
  if (focus instanceof HTMLInputElement) return focus.type === 'text' || key.length > 1;
  return focus instanceof HTMLSelectElement;
}

/** Wires buttons and keys to the view. */
export function wireControls(
    view: SceneView, viewerHand: ViewerHandInput, views: ViewSwitch, theme: ThemeSwitch, inside: InsideView,
    {details, cards, markButton, sayBar, voice}:
        {details: Details; cards: FoldingCards; markButton: MarkButton; sayBar: SayBar; voice: VoiceButton}): void {
  const help = document.getElementById('help') as HTMLDialogElement;
  const toggles: Toggle[] = [
    {button: 'show-hand', key: 'h', apply: (shown) => view.setHandShown(shown)},
    {button: 'show-ball', key: 'b', apply: (shown) => view.probe.setBallVisible(shown)},
    {button: 'show-forces', key: 'f', apply: (shown) => view.probe.setForcesVisible(shown)},
    {button: 'show-halo', key: 'u', apply: (shown) => view.halo.setShown(shown)},
    {button: 'show-color', key: 'c', apply: (shown) => view.surface.setColored(shown)},
    {button: 'show-inside', key: 'i', apply: (shown) => inside.setTransparent(shown)},
    {button: 'show-ultrasound', key: 'e', apply: (shown) => inside.setPanelShown(shown)},
    {button: 'show-stereo', key: 's', apply: (shown) => {
      document.body.toggleAttribute('data-stereo', shown);
      view.setStereo(shown);
    }},
    {button: 'hold-hand', key: 't', apply: (held) => viewerHand.setHeld(held)},
  ];
  const flip = ({button: id, apply}: Toggle) => {
    if (button(id).hidden) return;  // the station has nothing of the kind
    const shown = button(id).getAttribute('aria-pressed') !== 'true';
    button(id).setAttribute('aria-pressed', String(shown));
    apply(shown);
    view.invalidate();
  };
  for (const toggle of toggles) button(toggle.button).addEventListener('click', () => flip(toggle));
  button('reset').addEventListener('click', () => view.resetView());
  button('help-open').addEventListener('click', () => help.showModal());

  const keys: Record<string, () => void> = {
    ArrowLeft: () => view.orbit(-TURN_RAD, 0),
    ArrowRight: () => view.orbit(TURN_RAD, 0),
    ArrowUp: () => view.orbit(0, -TURN_RAD),
    ArrowDown: () => view.orbit(0, TURN_RAD),
    '+': () => view.orbit(0, 0, 1 / ZOOM),
    '=': () => view.orbit(0, 0, 1 / ZOOM),
    '-': () => view.orbit(0, 0, ZOOM),
    r: () => view.resetView(),
    l: () => theme.flip(),
    d: () => details.flip(),
    z: () => cards.foldAll(),
    m: () => void markButton.mark(),
    w: () => sayBar.open(true),
    '?': () => help.showModal(),
  };
  for (const toggle of toggles) keys[toggle.key] = () => flip(toggle);
  window.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || help.open) return;
    if (takesKey(event.target, event.key)) return;
    if (event.key.toLowerCase() === 'v') return voice.talk(true);
    if (views.takeKey(event.key)) return event.preventDefault();
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act === undefined) return;
    event.preventDefault();
    act();
  });
  window.addEventListener('keyup', ({key}) => key.toLowerCase() === 'v' && voice.talk(false));
  window.addEventListener('blur', () => voice.talk(false));
}
