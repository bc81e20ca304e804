// Runs on the browser's audio thread: hands the microphone's sound to the voice worker 20 ms at a time, and plays what the
// worker has decoded.
import {FRAME_SAMPLES} from './frame';
import {JitterBuffer} from './jitter_buffer';
import {LipSync} from './lip_sync';
import type {HeardFrame} from './worker_messages';

// The browser's types of this global scope are in no library of TypeScript.
declare class AudioWorkletProcessor {
  readonly port: MessagePort;
}
declare const registerProcessor: (name: string, processor: new () => AudioWorkletProcessor) => void;
declare const currentTime: number;  // [s]

/** Messages to a processor: the port to the voice worker. */
export interface Wire {
  worker: MessagePort;
}
/** Messages to the loudspeaker: how long ago the picture was captured that is shown when a sound of now is heard. */
export interface ShownPicture {
  pictureAge_ms: number;
}

const COUNTS_EVERY_S = 0.5;

class Microphone extends AudioWorkletProcessor {
  private worker: MessagePort | undefined;
  private block = new Float32Array(FRAME_SAMPLES);
  private filled = 0;

  constructor() {
    super();
    this.port.onmessage = ({data}: MessageEvent<Wire>) => (this.worker = data.worker);
  }

  process([input]: Float32Array[][]): boolean {
    const samples = input?.[0] ?? new Float32Array(128);  // without a source there is silence, and time goes on
    for (const sample of samples) {
      this.block[this.filled++] = sample;
      if (this.filled < FRAME_SAMPLES) continue;
      this.worker?.postMessage(this.block, [this.block.buffer]);
      this.block = new Float32Array(FRAME_SAMPLES);
      this.filled = 0;
    }
    return true;
  }
}

/** One side of the conversation that is heard. */
interface Heard {
  buffer: JitterBuffer;
  block: Float32Array | undefined;
}

class Loudspeaker extends AudioWorkletProcessor {
  private readonly sides = new Map<string, Heard>();
  private readonly lips = new LipSync();
  private at = FRAME_SAMPLES;  // in the blocks
  private told_s = 0;

  constructor() {
    super();
    this.port.onmessage = ({data}: MessageEvent<Wire | ShownPicture>) => {
      if ('worker' in data) data.worker.onmessage = ({data: heard}: MessageEvent<HeardFrame>) => this.came(heard);
      else this.lips.shown(data.pictureAge_ms);
    };
  }

  private came({side, frame, age_ms}: HeardFrame): void {
    const heard = this.sides.get(side) ?? {buffer: new JitterBuffer(), block: undefined};
    this.sides.set(side, heard);
    heard.buffer.add(frame, 1e3 * currentTime, age_ms);
    // The doctor is not in the picture, so the doctor's words do not wait for it.
    const {fastest_ms} = heard.buffer;
    if (side === '/patient/voice' && fastest_ms !== undefined) heard.buffer.held_ms = this.lips.delay_ms(fastest_ms);
  }

  process(_inputs: Float32Array[][], [output]: Float32Array[][]): boolean {
    const samples = output?.[0];
    if (samples === undefined) return true;
    for (let i = 0; i < samples.length; ++i, ++this.at) {
      if (this.at >= FRAME_SAMPLES) this.next(i);
      let sum = 0;
      for (const {block} of this.sides.values()) sum += block?.[this.at] ?? 0;
      samples[i] = sum;
    }
    return true;
  }

  private next(offset: number): void {
    this.at = 0;
    const now_s = currentTime + offset / 48_000;
    for (const heard of this.sides.values()) heard.block = heard.buffer.pull(1e3 * now_s);
    if (now_s - this.told_s < COUNTS_EVERY_S) return;
    this.told_s = now_s;
    for (const [side, {buffer}] of this.sides) this.port.postMessage({side, delay_ms: buffer.delay_ms, held_ms: buffer.held_ms, ...buffer.counts});
  }
}

registerProcessor('microphone', Microphone);
registerProcessor('loudspeaker', Loudspeaker);
