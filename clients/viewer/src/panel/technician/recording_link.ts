import type {Answer} from '../../link/ask_server';
import {oneLine} from '../../page/page';
import {GONE} from '../../playback/timeline_words';
import type {Row} from '../../page/rows';

/** The body of POST /recording. */
export type RecordingCommand = {record: true; consent: string} | {record: false};
export type AskRecording = (command?: RecordingCommand) => Promise<Answer>;

type Phase = 'PHASE_IDLE' | 'PHASE_RECORDING' | 'PHASE_COMPLETING';
export interface RecordingState {
  phase: Phase;
  file: string;
  seconds: number;
  bytes: number;
  problem: string;
}

const LOOK_EVERY = 10;  // the state is asked for at each 10th call of `look`
const MOST_NOTE = 120;

/** Reads the server's reply; undefined if it cannot be read. Protobuf's JSON writes 64-bit numbers as text. */
export function readRecording(text: string): RecordingState | undefined {
  try {
    const {phase, file, seconds, bytes, problem} = JSON.parse(text) as Record<string, unknown>;
    if (typeof phase !== 'string') return undefined;
    return {phase: phase as Phase, file: String(file), seconds: Number(seconds), bytes: Number(bytes), problem: String(problem)};
  } catch {
    return undefined;
  }
}

/** The consent as it is written into the file: who ticked it, and the technician's note. */
export function consentText(role: string, note: string): string {
  const who = `ticked in the web viewer by ${role === '' ? 'a visitor' : role}`;
  const text = oneLine(note);
  return text === '' ? who : `${who}: ${text.slice(0, MOST_NOTE)}`;
}

/** The state as rows of a card. */
export function recordingRows({phase, file, seconds, bytes}: RecordingState): Row[] {
  if (file === '') return [{name: 'Now', value: 'not recording'}];
  const now = {PHASE_IDLE: 'not recording', PHASE_RECORDING: 'recording', PHASE_COMPLETING: 'completing the file'}[phase];
  const minutes = Math.floor(seconds / 60);
  return [
    {name: 'Now', value: now ?? phase, level: phase === 'PHASE_RECORDING' ? 'alarm' : undefined},
    {name: phase === 'PHASE_IDLE' ? 'Last file' : 'File', value: file, says: 'In the folder that the server was given by --record-dir'},
    {name: 'Length', value: `${minutes}:${Math.floor(seconds % 60).toString().padStart(2, '0')}, ${(bytes / 1e6).toFixed(1)} MB`},
  ];
}

/** The recording at the server's machine. Call `look` ten times a second: it asks about once a second. */
export class RecordingLink {
  state: RecordingState | undefined;  // undefined: this server offers no recording, or it is not known yet
  problem = '';                       // a sentence for the technician; empty: all is well

  private looks = 0;
  private offered = true;
  private asking = false;

  constructor(private readonly ask: AskRecording) {}

  async look(connected: boolean): Promise<void> {
    if (!connected) {
      this.offered = true;  // the next server may offer recording
      this.state = undefined;
      this.looks = 0;
      return;
    }
    if (!this.offered || this.asking || this.looks++ % LOOK_EVERY !== 0) return;
    await this.send(undefined);
  }

  async command(command: RecordingCommand): Promise<void> {
    this.problem = '';
    await this.send(command);
  }

  private async send(command: RecordingCommand | undefined): Promise<void> {
    this.asking = true;
    const answer = await this.ask(command);
    this.asking = false;
    if (answer === undefined) {
      if (command !== undefined) this.problem = GONE;
      return;
    }
    if (this.problem === GONE) this.problem = '';
    const state = answer.status === 200 ? readRecording(answer.text) : undefined;
    if (state !== undefined) this.state = state;
    else if (command !== undefined) this.problem = answer.text.trim();
    else if (answer.status === 200) this.offered = false;  // an empty state: nothing can be recorded here
    if (this.state !== undefined && this.state.problem !== '') this.problem = this.state.problem;
  }
}
