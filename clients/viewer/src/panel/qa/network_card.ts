import type {Resource} from '../../link/resource';
import type {NetworkState as NetworkMessage} from '../../messages/generated';
import {element, made, setText} from '../../page/page';
import {
  networkRows, type NetworkCommand, type NetworkSlider, type NetworkState, placeOf, PROFILES, SLIDERS, textOf,
} from '../../playback/network_state';
import {RowList} from '../../page/rows';

export type ImpairedNetwork = Resource<NetworkMessage, NetworkState, NetworkCommand>;

/** QA's card that impairs a played session as a network would: a profile, sliders, and what they do. */
export class NetworkCard {
  private readonly card = element('impaired');
  private readonly profile = element<HTMLSelectElement>('impaired-profile');
  private readonly rows = new RowList(element('impaired-rows'));
  private readonly sliders = SLIDERS.map((slider) => this.made(slider));

  constructor(private readonly network: ImpairedNetwork) {
    network.onChange(() => this.write());
    this.profile.replaceChildren(...PROFILES.map((name) => new Option(name, name)));
    this.profile.addEventListener('change', () => void this.network.command({profile: this.profile.value}));
  }

  show(plays: boolean): void {
    this.card.hidden = !plays || this.network.state === undefined;
  }

  private made(slider: NetworkSlider) {
    const [label, input, output] = [made('label', 'range wide', slider.name), made('input'), made('output')];
    input.type = 'range';
    input.id = `impaired-${slider.field}`;
    input.max = String(slider.values.length - 1);
    input.addEventListener('input', () => {
      const value = slider.values[Number(input.value)]!;
      this.say(slider, input, output, value);
      void this.network.command({[slider.field]: value});
    });
    label.append(input, output);
    element('impaired-sliders').append(label);
    return {slider, input, output};
  }

  private write(): void {
    const {state, problem} = this.network;
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
