import type {Resource} from '../../link/resource';
import {type RecordingState as RecordingMessage, RecordingState_Phase as Phase} from '../../messages/generated';
import {oneLine} from '../../page/page';
import type {Row} from '../../page/rows';

/** The body of POST /recording. */
export type RecordingCommand = {record: true; consent: string; voice_consent?: string} | {record: false};
export type Recording = Resource<RecordingMessage, RecordingState, RecordingCommand>;

export interface RecordingState {
  phase: Phase;
  file: string;
  seconds: number;
  bytes: number;
  problem: string;
}

const MOST_NOTE = 120;

export const readRecording = ({phase, file, seconds, bytes, problem}: RecordingMessage): RecordingState =>
    ({phase, file, seconds, bytes: Number(bytes), problem});

/** The consent as it is written into the file: who ticked it, and the technician's note. */
export function consentText(role: string, note: string): string {
  const who = `ticked in the web viewer by ${role === '' ? 'a visitor' : role}`;
  const text = oneLine(note);
  return text === '' ? who : `${who}: ${text.slice(0, MOST_NOTE)}`;
}

/** The command to begin a recording, with what is said only if all who speak consent to it. */
export function beginRecording(role: string, note: string, withVoice: boolean): RecordingCommand {
  const consent = consentText(role, note);
  return {record: true, consent, ...(withVoice && {voice_consent: consent})};
}

/** The state as rows of a card. */
export function recordingRows({phase, file, seconds, bytes}: RecordingState): Row[] {
  if (file === '') return [{name: 'Now', value: 'not recording'}];
  const now = {[Phase.IDLE]: 'not recording', [Phase.RECORDING]: 'recording', [Phase.COMPLETING]: 'completing the file'}[phase];
  const minutes = Math.floor(seconds / 60);
  return [
    {name: 'Now', value: now, level: phase === Phase.RECORDING ? 'alarm' : undefined},
    {name: phase === Phase.IDLE ? 'Last file' : 'File', value: file, says: 'In the folder that the server was given by --record-dir'},
    {name: 'Length', value: `${minutes}:${Math.floor(seconds % 60).toString().padStart(2, '0')}, ${(bytes / 1e6).toFixed(1)} MB`},
  ];
}
