import type {VoiceFrame} from '../messages/generated';
import {FRAME_MS, FRAME_SAMPLES, MOST_EARLIER, RATE_HZ, type SpokenFrame} from './frame';

const MOST_WAITING = 25;         // frames in the decoder; a page that lay in the background has more
const MOST_ON = 3000;            // frames: a minute
const MOST_BACK = 50;
const SPEED_TOLERANCE = 0.2;
const JUDGED_FRAMES = 10;        // from which a speed is computed

interface Packet {
  number: number;
  begun: number;
  spoken_ms: number;
  opus: Uint8Array;
}

/** The packets of a message that are newer than frame `after`, in order. */
export function newPackets({number, begun, opus, earlier, capturedNs}: VoiceFrame, after: number): Packet[] {
  const packets = [opus, ...earlier].map((one, back) => ({number: number - back, begun, spoken_ms: Number(capturedNs) / 1e6 - back * FRAME_MS, opus: one}));
  return packets.filter((one) => one.number > after && one.number >= begun).reverse();
}

/**
 * Decodes one side of the conversation, each frame once and in order: a message repeats the packets of those before it,
 * which may be lost. A recorded session that is played at another speed than 1 is silent: it would be noise.
 */
export class VoiceDecoding {
  private decoder: AudioDecoder | undefined;
  private talker = 0n;
  private newest = -1;
  private before: VoiceFrame | undefined;  // from which the speed is judged next
  private isAtSpeed1 = true;
  private decoding: Packet[] = [];

  constructor(private readonly decoded: (frame: SpokenFrame) => void) {}

  came(frame: VoiceFrame): void {
    const on = frame.number - this.newest;
    const far = on > MOST_ON || on < -MOST_BACK;  // the talker's page, or the played session, began again
    if (frame.talker !== this.talker || far || this.decoder?.state !== 'configured') this.restart(frame);
    if (!this.atSpeed1(frame)) return;
    for (const packet of newPackets(frame, this.newest)) this.decode(packet);
  }

  private restart({talker, number, begun}: VoiceFrame): void {
    if (this.decoder?.state === 'configured') this.decoder.close();
    this.decoder = new AudioDecoder({output: (data) => this.came20ms(data), error: (problem) => console.warn('voice:', problem.message)});
    this.decoder.configure({codec: 'opus', sampleRate: RATE_HZ, numberOfChannels: 1});
    this.talker = talker;
    this.newest = Math.max(begun, number - MOST_EARLIER) - 1;
    this.decoding = [];
    this.before = undefined;
    this.isAtSpeed1 = true;
  }

  private atSpeed1(frame: VoiceFrame): boolean {
    const {before} = this;
    const frames = before?.begun === frame.begun ? frame.number - before.number : -1;
    if (frames >= 0 && frames < JUDGED_FRAMES) return this.isAtSpeed1;
    this.before = frame;
    if (before === undefined || frames < 0) return this.isAtSpeed1;
    const took_ms = Number(frame.capturedNs - before.capturedNs) / 1e6;
    return (this.isAtSpeed1 = Math.abs(took_ms / (frames * FRAME_MS) - 1) <= SPEED_TOLERANCE);
  }

  private decode(packet: Packet): void {
    this.newest = packet.number;
    if (this.decoder === undefined || this.decoding.length >= MOST_WAITING) return;
    this.decoding.push(packet);
    this.decoder.decode(new EncodedAudioChunk({
      type: 'key', timestamp: 1000 * FRAME_MS * packet.number, duration: 1000 * FRAME_MS, data: packet.opus as Uint8Array<ArrayBuffer>,
    }));
  }

  private came20ms(data: AudioData): void {
    const packet = this.decoding.shift();
    const samples = new Float32Array(FRAME_SAMPLES);
    if (data.numberOfFrames <= FRAME_SAMPLES)
      data.copyTo(samples.subarray(FRAME_SAMPLES - data.numberOfFrames), {planeIndex: 0, format: 'f32-planar'});
    data.close();
    if (packet !== undefined) this.decoded({talker: this.talker, number: packet.number, begun: packet.begun, spoken_ms: packet.spoken_ms, samples});
  }
}
