import type {Resource} from '../../link/resource';
import type {RoomVoiceState} from '../../messages/generated';
import {element, made, setText} from '../../page/page';

/** Microphone and loudspeaker of the patient's room, at the server. */
export type RoomVoice = Resource<RoomVoiceState, RoomVoiceState, {open: boolean}>;

/** What the card says: of the microphone, then of the loudspeaker. */
export function roomVoiceSays({open, hears, microphoneProblem, loudspeakerProblem}: RoomVoiceState): string[] {
  const microphone = microphoneProblem !== '' ? `The room is not heard: ${microphoneProblem}` :
      hears ? 'All who may listen hear the room.' :
      open ? 'The microphone is being opened…' : 'The microphone is closed: nobody hears the room.';
  const loudspeaker = loudspeakerProblem === '' ? 'The room hears the doctor.' : `The room does not hear the doctor: ${loudspeakerProblem}`;
  return [microphone, loudspeaker];
}

/** What a press on the button does, and how the button looks. */
export const roomVoiceButton = ({open, hears}: RoomVoiceState) =>
    ({text: open ? (hears ? '● Close the microphone' : 'Close the microphone') : 'Open the microphone', light: hears, next: !open});

/** The technician's card *Sound of the room*: a light while the microphone is open, and the button that opens it. */
export class RoomVoiceCard {
  private readonly box = made('section', 'card');
  private readonly button = made('button');
  private readonly said = [made('p', 'said'), made('p', 'said')];

  constructor(private readonly room: RoomVoice) {
    this.box.id = 'room-voice';
    this.box.dataset['views'] = 'technician';
    this.button.id = 'room-microphone';
    this.button.addEventListener('click', () => void room.command({open: room.state !== undefined && roomVoiceButton(room.state).next}));
    for (const line of this.said) line.setAttribute('role', 'status');
    const acts = made('p', 'acts');
    acts.append(this.button);
    this.box.append(made('h2', '', 'Sound of the room'), ...this.said, acts);
    element('recording').before(this.box);
    room.onChange(() => this.show());
    this.show();
  }

  private show(): void {
    const {state, problem} = this.room;
    this.box.hidden = state === undefined;
    if (state === undefined) return;
    const {text, light} = roomVoiceButton(state);
    setText(this.button, text);
    this.button.setAttribute('aria-pressed', String(light));
    this.button.style.color = light ? 'var(--alarm)' : '';
    this.button.title = `By ALSA’s device ${state.device}, at the server`;
    const says = roomVoiceSays(state);
    this.said.forEach((line, at) => setText(line, at === 0 && problem !== '' ? problem : says[at] ?? ''));
  }
}
