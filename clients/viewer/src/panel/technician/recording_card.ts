import {RecordingState_Phase as Phase} from '../../messages/generated';
import {element, setText} from '../../page/page';
import {RowList} from '../../page/rows';
import {beginRecording, type Recording, recordingRows} from './recording_state';

/** Begins and ends a recording at the server's machine. It begins only after the tick for the patient's consent. */
export class RecordingCard {
  private readonly card = element('recording');
  private readonly rows = new RowList(element('recording-rows'));
  private readonly button = element<HTMLButtonElement>('record');
  private readonly given = element<HTMLInputElement>('consent-given');
  private readonly withVoice = element<HTMLInputElement>('voice-consent');
  private readonly note = element<HTMLInputElement>('consent-note');
  private role = '';

  constructor(private readonly recording: Recording) {
    recording.onChange(() => this.write());
    this.button.addEventListener('click', ({detail}) => {
      if (detail < 2) void this.flip();  // the second press of a double click would end the recording
    });
    this.given.addEventListener('change', () => this.write());
  }

  /** `role`: of this visitor at the server. */
  show(role: string): void {
    this.role = role;
  }

  private write(): void {
    const {state, problem} = this.recording;
    this.card.hidden = state === undefined;
    if (state === undefined) return;
    const records = state.phase !== Phase.IDLE;
    this.rows.show(recordingRows(state));
    setText(this.button, records ? 'End recording' : 'Record');
    this.button.disabled = state.phase === Phase.COMPLETING || (!records && !this.given.checked);
    this.given.disabled = this.withVoice.disabled = this.note.disabled = records;
    setText(element('recording-said'), problem === '' ? state.problem : problem);
  }

  private async flip(): Promise<void> {
    const records = this.recording.state?.phase === Phase.RECORDING;
    await this.recording.command(records ? {record: false} : beginRecording(this.role, this.note.value, this.withVoice.checked));
    if (records) this.given.checked = this.withVoice.checked = false;  // consent is for one recording
    this.write();
  }
}
