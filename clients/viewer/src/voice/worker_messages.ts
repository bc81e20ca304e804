import type {VoiceTopic} from '../messages/topics';

/** From the page to the voice worker. */
export type ToVoiceWorker =
    {join: {speaks: VoiceTopic | undefined; hears: VoiceTopic[]; query: string; microphone: MessagePort; loudspeaker: MessagePort}} |
    {open: boolean};

/** From the voice worker to the page. */
export type FromVoiceWorker =
    {mayEncode: boolean} | {sent: number} |  // messages so far
    {warning: string};
