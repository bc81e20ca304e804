import {askServer} from '../../link/ask_server';
import {element, setText} from '../../page/page';
import {RowList} from '../../page/rows';
import {consentText, recordingRows, RecordingLink} from './recording_link';

/** Begins and ends a recording at the server's machine. It begins only after the tick for the patient's consent. */
export class RecordingCard {
  private readonly link = new RecordingLink(askServer('recording'));
  private readonly card = element('recording');
  private readonly rows = new RowList(element('recording-rows'));
  private readonly button = element<HTMLButtonElement>('record');
  private readonly given = element<HTMLInputElement>('consent-given');
  private readonly note = element<HTMLInputElement>('consent-note');
  private role = '';

  constructor() {
    this.button.addEventListener('click', ({detail}) => {
      if (detail < 2) void this.flip();  // the second press of a double click would end the recording
    });
    this.given.addEventListener('change', () => this.write());
  }

  show(connected: boolean, role: string): void {
    this.role = role;
    void this.link.look(connected);
    this.write();
  }

  private write(): void {
    const {state, problem} = this.link;
    this.card.hidden = state === undefined;
    if (state === undefined) return;
    const records = state.phase !== 'PHASE_IDLE';
    this.rows.show(recordingRows(state));
    setText(this.button, records ? 'End recording' : 'Record');
    this.button.disabled = state.phase === 'PHASE_COMPLETING' || (!records && !this.given.checked);
    this.given.disabled = this.note.disabled = records;
    setText(element('recording-said'), problem);
  }

  private async flip(): Promise<void> {
    const records = this.link.state?.phase === 'PHASE_RECORDING';
    await this.link.command(records ? {record: false} : {record: true, consent: consentText(this.role, this.note.value)});
    if (records) this.given.checked = false;  // consent is for one recording
    this.write();
  }
}
