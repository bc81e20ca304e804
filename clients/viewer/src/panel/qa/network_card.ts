import {askServer} from '../../link/ask_server';
import {element, made, setText} from '../../page/page';
import {
  joined, networkRows, type NetworkCommand, type NetworkSlider, type NetworkState, placeOf, PROFILES, readNetwork, SLIDERS, textOf,
} from '../../playback/network_state';
import {PlayedPart} from '../../playback/played_part';
import {RowList} from '../../page/rows';

const LOOK_EVERY = 10;  // calls of `show`, which come about ten times a second

/** QA's card that impairs a played session as a network would: a profile, sliders, and what they do. */
export class NetworkCard {
  private readonly part =
      new PlayedPart<NetworkState, NetworkCommand>(askServer('playback/network'), readNetwork, joined);
  private readonly card = element('impaired');
  private readonly profile = element<HTMLSelectElement>('impaired-profile');
  private readonly rows = new RowList(element('impaired-rows'));
  private readonly sliders = SLIDERS.map((slider) => this.made(slider));
  private shows = 0;

  constructor() {
    this.profile.replaceChildren(...PROFILES.map((name) => new Option(name, name)));
    this.profile.addEventListener('change', () => void this.send({profile: this.profile.value}));
  }

  show(plays: boolean): void {
    this.card.hidden = !plays || this.part.state === undefined;
    if (!plays) return this.part.forget();
    if (this.shows++ % LOOK_EVERY === 0) void this.part.look().then(() => this.write());
  }

  private made(slider: NetworkSlider) {
    const [label, input, output] = [made('label', 'range wide', slider.name), made('input'), made('output')];
    input.type = 'range';
    input.id = `impaired-${slider.field}`;
    input.max = String(slider.values.length - 1);
    input.addEventListener('input', () => {
      const value = slider.values[Number(input.value)]!;
      this.say(slider, input, output, value);
      void this.send({[slider.field]: value});
    });
    label.append(input, output);
    element('impaired-sliders').append(label);
    return {slider, input, output};
  }

  private async send(command: NetworkCommand): Promise<void> {
    await this.part.command(command);
    this.write();
  }

  private write(): void {
    const {state, problem} = this.part;
    setText(element('impaired-said'), problem);
    if (state === undefined) return;
    this.rows.show(networkRows(state));
    this.profile.value = state.profile;
    for (const {slider, input, output} of this.sliders) {
      input.value = String(placeOf(slider, state[slider.field]));
      this.say(slider, input, output, state[slider.field]);
    }
  }

  private say(slider: NetworkSlider, input: HTMLInputElement, output: HTMLElement, value: number): void {
    const text = textOf(slider, value);
    setText(output, text);
    input.setAttribute('aria-valuetext', text);
  }
}
