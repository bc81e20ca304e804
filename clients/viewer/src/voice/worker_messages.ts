import type {VoiceTopic} from '../messages/topics';
import type {SpokenFrame} from './frame';

/** From the page to the voice worker. */
export type ToVoiceWorker =
    {join: {speaks: VoiceTopic | undefined; hears: VoiceTopic[]; query: string; microphone: MessagePort; loudspeaker: MessagePort}} |
    {open: boolean};

/** From the voice worker to the page. */
export type FromVoiceWorker =
    {mayEncode: boolean} | {sent: number} |  // messages so far
    {speed: number} |  // at which a recorded session is played; 1 without one
    {warning: string};

/** From the voice worker to the loudspeaker: a decoded frame of one side, and how long ago its first sample was spoken. */
export interface HeardFrame {
  side: VoiceTopic;
  frame: SpokenFrame;
  age_ms: number | undefined;
}
