import {ownQuery} from '../link/own_session';
import type {VoiceTopic} from '../messages/topics';
import {RATE_HZ} from './frame';
import type {ShownPicture} from './voice_worklet';
import type {FromVoiceWorker, ToVoiceWorker} from './worker_messages';

const LOOKS_AT_PICTURE_EVERY_MS = 100;
const STILL_S = 2;  // from this age on the picture stands still: the session is paused, or its images do not come

/** Where a page speaks (undefined: nowhere), and what it hears. */
export interface Side {
  speaks: VoiceTopic | undefined;
  hears: VoiceTopic[];
}

/** What a loudspeaker has played of one side: the counts of its jitter buffer. */
interface HeardCounts {
  side: VoiceTopic;
  delay_ms: number;
  held_ms: number;  // at least so long the side waits for its picture
  played: number;
  concealed: number;
}

/** A conversation that this page has joined: it hears the others, and has a microphone, which begins closed. */
export class Voice {
  open = false;
  /** For tests and the console: messages sent, and what was played by side. */
  readonly counts: {sent: number; heard: {[side: string]: HeardCounts}} = {sent: 0, heard: {}};
  private stream: MediaStream | undefined;
  private mayEncode: boolean | undefined;
  private asked = false;  // the user wants the microphone open
  private speed = 1;      // of a played session

  constructor(
      private readonly button: HTMLButtonElement, private readonly side: Side, private readonly explain: (problem: string) => void,
      pictureAge_s: () => number | undefined, private readonly audio: AudioContext, private readonly worker: Worker) {
    const [microphone, loudspeaker] = [this.node('microphone'), this.node('loudspeaker')];
    loudspeaker.port.onmessage = ({data}: MessageEvent<HeardCounts>) => (this.counts.heard[data.side] = data);
    loudspeaker.connect(audio.destination);
    setInterval(() => {
      const age_s = pictureAge_s();
      const told = {pictureAge_ms: 1000 * ((age_s ?? 0) - audio.outputLatency)} satisfies ShownPicture;
      if (age_s !== undefined && age_s < STILL_S) loudspeaker.port.postMessage(told);
    }, LOOKS_AT_PICTURE_EVERY_MS);
    this.microphone = microphone;
    worker.onmessage = ({data}: MessageEvent<FromVoiceWorker>) => this.heard(data);
    const ports = [microphone, loudspeaker].map((node) => {
      const {port1, port2} = new MessageChannel();
      node.port.postMessage({worker: port1}, [port1]);
      return port2;
    });
    const join = {...side, query: ownQuery(), microphone: ports[0]!, loudspeaker: ports[1]!};
    worker.postMessage({join} satisfies ToVoiceWorker, ports);
    this.show();
  }

  private readonly microphone: AudioWorkletNode;

  async setOpen(open: boolean): Promise<void> {
    this.asked = open;
    if (open && this.side.speaks === undefined) return this.explain('This page hears the conversation and has no microphone in it.');
    if (open && this.mayEncode === false)
      return this.explain('This browser cannot code speech (it has no AudioEncoder for Opus): you hear the others, but they do not hear you. Use a newer browser.');
    if (open && !(await this.hasMicrophone())) return;
    this.apply(this.asked);  // the key may have been released meanwhile
  }

  private node(name: string): AudioWorkletNode {
    return new AudioWorkletNode(this.audio, name, {numberOfInputs: name === 'microphone' ? 1 : 0, outputChannelCount: [1]});
  }

  private async hasMicrophone(): Promise<boolean> {
    if (this.stream !== undefined) return true;
    try {
      const audio = {echoCancellation: true, noiseSuppression: true, autoGainControl: true, channelCount: 1};
      const stream = await navigator.mediaDevices.getUserMedia({audio});
      this.stream ??= stream;
    } catch (problem) {
      this.explain(`No microphone: ${String(problem)}. Connect one, and allow this page to use it.`);
      return false;
    }
    const [track] = this.stream.getAudioTracks();
    track!.enabled = this.open;
    track!.addEventListener('ended', () => this.lost());
    this.audio.createMediaStreamSource(this.stream).connect(this.microphone);
    this.microphone.connect(this.audio.destination);  // it gives silence; without an output, it would not run
    return true;
  }

  private lost(): void {
    this.stream = undefined;
    this.apply(false);
    this.explain('The microphone is gone: the others do not hear you. Connect it again, then press Voice.');
  }

  private apply(open: boolean): void {
    this.open = open && this.stream !== undefined;
    for (const track of this.stream?.getAudioTracks() ?? []) track.enabled = this.open;
    this.worker.postMessage({open: this.open} satisfies ToVoiceWorker);
    this.show();
  }

  private show(): void {
    const silent = this.side.speaks === undefined || this.mayEncode === false;
    const silence = this.speed === 1 ? '' : `Silent at ${this.speed} ×`;
    this.button.textContent = this.open ? '● Speaking' : silence !== '' ? silence : silent ? 'Listening' : 'Muted';
    this.button.setAttribute('aria-pressed', String(this.open));
  }

  private heard(data: FromVoiceWorker): void {
    if ('sent' in data) {
      this.counts.sent = data.sent;
    } else if ('mayEncode' in data || 'speed' in data) {
      if ('mayEncode' in data) this.mayEncode = data.mayEncode;
      else this.speed = data.speed;
      this.show();
    } else {
      this.explain(data.warning);
    }
  }
}

/**
 * Joins the conversation. `button`: shows the state of the microphone. `pictureAge_s`: how long ago the shown picture was
 * captured. Throws if this browser plays no sound so.
 */
export async function joinVoice(
    button: HTMLButtonElement, side: Side, explain: (problem: string) => void, pictureAge_s: () => number | undefined): Promise<Voice> {
  const audio = new AudioContext({sampleRate: RATE_HZ, latencyHint: 'interactive'});
  await audio.audioWorklet.addModule('voice_worklet.js');
  await audio.resume();
  return new Voice(button, side, explain, pictureAge_s, audio, new Worker('voice_worker.js', {type: 'module'}));
}
