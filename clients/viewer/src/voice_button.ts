import {element, later} from './page/page';
import type {View} from './views/view';
import type {Side, Voice} from './voice/voice';

/** Where this page speaks and what it hears. The role decides, but a visitor at the server itself chooses by the view. */
export function sideOf(role: string, view: View, played: boolean): Side {
  const who = role === 'local' ? view : role;
  const patient = '/patient/voice';
  const doctor = '/doctor/voice';
  if (played || (who !== 'doctor' && who !== 'technician')) return {speaks: undefined, hears: [patient, doctor]};
  return who === 'doctor' ? {speaks: doctor, hears: [patient]} : {speaks: patient, hears: [doctor]};
}

/**
 * The button *Voice*. The first press joins the conversation: the page hears the others, and the microphone stays closed.
 * Later presses open and close the microphone. It is open, too, while V is held. The code (voice/) is loaded with the
 * first press.
 */
export class VoiceButton {
  private readonly button = element<HTMLButtonElement>('voice');
  private voice: Promise<Voice> | undefined;
  private joined: Voice | undefined;

  constructor(
      private readonly side: () => Side, private readonly explain: (problem: string) => void,
      private readonly pictureAge_s: () => number | undefined) {
    this.button.addEventListener('click', () => {
      if (this.voice === undefined) void this.join();
      else void this.joined?.setOpen(!this.joined.open);
    });
  }

  /** Guests may not listen. */
  showFor(role: string): void {
    this.button.hidden = role === 'viewer';
  }

  /** The key to talk is pressed, or released. */
  talk(held: boolean): void {
    if (this.voice !== undefined || held) void this.join().then((voice) => voice?.setOpen(held));
  }

  get counts(): Voice['counts'] | undefined {
    return this.joined?.counts;
  }

  private async join(): Promise<Voice | undefined> {
    try {
      this.voice ??= this.load();
      return (this.joined = await this.voice);
    } catch (problem) {
      this.voice = undefined;
      this.explain(String(problem));
      return undefined;
    }
  }

  private async load(): Promise<Voice> {
    const {joinVoice} = await later<typeof import('./voice/voice')>('voice.js');
    return joinVoice(this.button, this.side(), this.explain, this.pictureAge_s);
  }
}
