import type {Resource, Traits} from '../../link/resource';
import type {ExposureState} from '../../messages/generated';
import {element, setText} from '../../page/page';

/** The body of POST /exposure. */
export interface ExposureCommand {
  automatic?: boolean;
  exposure?: number;
  gain?: number;
}
export const EXPOSURE: Traits<ExposureState, ExposureState, ExposureCommand> =
    {read: (message) => message, join: (first, then) => ({...first, ...then})};
export type CameraExposure = Resource<ExposureState, ExposureState, ExposureCommand>;

const PLACES = 100;  // of a slider

/** The value at a slider's place: each step changes it by the same share, as each stop of a camera does. */
export function valueAt(place: number, least: number, most: number): number {
  const from = Math.max(least, most / 10_000);  // a driver that begins at 0 has no share to step by
  return Number((from * (most / from) ** (place / PLACES)).toPrecision(3));
}

/** The place nearest to `value`. */
export function placeAt(value: number, least: number, most: number): number {
  const from = Math.max(least, most / 10_000);
  return Math.round(PLACES * Math.log(Math.max(value, from) / from) / Math.log(most / from));
}

/** The technician's card for the exposure of the camera's colour images. */
export class ExposureCard {
  private readonly automatic = element<HTMLInputElement>('exposure-automatic');
  private readonly exposure = element<HTMLInputElement>('exposure');
  private readonly gain = element<HTMLInputElement>('gain');

  constructor(private readonly camera: CameraExposure) {
    camera.onChange(() => this.write());
    this.automatic.addEventListener('change', () => void camera.command({automatic: this.automatic.checked}));
    this.exposure.addEventListener('input', () => this.send('exposure', this.exposure, camera.state?.least, camera.state?.most));
    this.gain.addEventListener('input', () => this.send('gain', this.gain, camera.state?.leastGain, camera.state?.mostGain));
  }

  private send(what: 'exposure' | 'gain', slider: HTMLInputElement, least = 0, most = 1): void {
    const value = Math.min(most, Math.max(least, valueAt(Number(slider.value), least, most)));
    this.say(what, value);
    void this.camera.command({automatic: false, [what]: value});
  }

  private say(what: 'exposure' | 'gain', value: number): void {
    const text = `${Number(value.toPrecision(3))} ${what === 'exposure' ? this.camera.state?.unit ?? '' : ''}`.trim();
    setText(element(`${what}-text`), text);
    element(what).setAttribute('aria-valuetext', text);
  }

  private write(): void {
    const {state, problem} = this.camera;
    element('exposure-card').hidden = state === undefined;
    if (state === undefined) return;
    element('exposure-none').hidden = state.offered;
    element('exposure-set').hidden = !state.offered;
    setText(element('exposure-said'), problem === '' ? state.problem : problem);
    if (!state.offered) return;
    this.automatic.checked = state.automatic;
    this.exposure.value = String(placeAt(state.exposure, state.least, state.most));
    this.gain.value = String(placeAt(state.gain, state.leastGain, state.mostGain));
    this.say('exposure', state.exposure);
    this.say('gain', state.gain);
  }
}
