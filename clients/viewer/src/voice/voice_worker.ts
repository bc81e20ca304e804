// Codes what the microphone hears and sends it, and decodes what the others say, away from the page's thread, which draws.
// It has a connection of its own, so that no picture is in line before a word.
import {SessionClock, now_ms} from '../link/session_clock';
import {Stream} from '../link/stream';
import type {PlaybackState, VoiceFrame} from '../messages/generated';
import type {VoiceTopic} from '../messages/topics';
import {FRAME_MS, MOST_EARLIER, RATE_HZ} from './frame';
import {VoiceDecoding} from './voice_decoding';
import type {FromVoiceWorker, ToVoiceWorker} from './worker_messages';

const ENCODING: AudioEncoderConfig = {
  codec: 'opus', sampleRate: RATE_HZ, numberOfChannels: 1, bitrate: 24_000,
  opus: {frameDuration: 1000 * FRAME_MS, application: 'voip', signal: 'voice', packetlossperc: 10, useinbandfec: true, usedtx: false},
} as AudioEncoderConfig;
const KEPT_TIMES = 50;  // frames

const tell = (message: FromVoiceWorker) => postMessage(message);

/** Sends what is said on one topic while the microphone is open. While it is closed, nothing is coded, and nothing sent. */
class Talker {
  open = false;
  private readonly encoder: AudioEncoder;
  private number = -1;           // of the newest frame from the microphone
  private begun = 0;
  private coding: number[] = []; // frames that the encoder has and has not given back
  private earlier: {number: number; opus: Uint8Array}[] = [];  // newest first
  private starts_ms: number[] = [];  // when frame 0 began, as the newest frames tell
  private sent = 0;

  constructor(private readonly topic: VoiceTopic, private readonly stream: Stream, private readonly clock: SessionClock) {
    this.encoder = new AudioEncoder({
      output: (chunk) => this.coded(chunk),
      error: (problem) => tell({warning: `this browser could not code speech: ${problem.message}`}),
    });
    this.encoder.configure(ENCODING);
  }

  /** The next 20 ms of the microphone. */
  heard(samples: Float32Array): void {
    ++this.number;
    this.starts_ms = [...this.starts_ms, now_ms() - (this.number + 1) * FRAME_MS].slice(-KEPT_TIMES);
    if (!this.open) {
      this.begun = this.number + 1;
      return;
    }
    if (this.encoder.state !== 'configured') return;
    this.coding.push(this.number);
    const data = new AudioData({
      format: 'f32', sampleRate: RATE_HZ, numberOfFrames: samples.length, numberOfChannels: 1,
      timestamp: 1000 * FRAME_MS * this.number, data: samples as Float32Array<ArrayBuffer>,
    });
    this.encoder.encode(data);
    data.close();
  }

  private coded(chunk: EncodedAudioChunk): void {
    const number = this.coding.shift();
    const offset_ms = this.clock.offset_ms;
    if (number === undefined || !this.open || number < this.begun || offset_ms === undefined) return;
    const opus = new Uint8Array(chunk.byteLength);
    chunk.copyTo(opus);
    const repeated: Uint8Array[] = [];
    for (const one of this.earlier) {
      if (one.number !== number - 1 - repeated.length || one.number < this.begun) break;
      repeated.push(one.opus);
    }
    const captured_ms = Math.min(...this.starts_ms) + number * FRAME_MS + offset_ms;
    this.stream.publish(this.topic, {
      capturedNs: BigInt(Math.round(1000 * captured_ms)) * 1000n, number, begun: this.begun, opus, earlier: repeated,
    });
    this.earlier = [{number, opus}, ...this.earlier].slice(0, MOST_EARLIER);
    tell({sent: ++this.sent});
  }
}

async function mayEncode(): Promise<boolean> {
  if (typeof AudioEncoder === 'undefined') return false;
  return AudioEncoder.isConfigSupported(ENCODING).then(({supported}) => supported === true, () => false);
}

let talker: Talker | undefined;

async function join({speaks, hears, query, microphone, loudspeaker}: Extract<ToVoiceWorker, {join: unknown}>['join']): Promise<void> {
  const clock = new SessionClock();
  const sides = new Map(hears.map((side) => [side, new VoiceDecoding(
      (frame) => loudspeaker.postMessage({side, frame, age_ms: ageOf(frame.spoken_ms)}, [frame.samples.buffer]))]));
  const ageOf = (spoken_ms: number) => clock.offset_ms === undefined ? undefined : now_ms() + clock.offset_ms - spoken_ms;
  const hear = (side: VoiceTopic) => (frame: VoiceFrame) => {
    if (frame.talker !== stream.viewer) sides.get(side)?.came(frame);
  };
  const stream = new Stream(
      `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/stream${query}`,
      {
        ...Object.fromEntries(hears.map((side) => [side, hear(side)])),
        '/playback': ({speed}: PlaybackState) => tell({speed}),
      },
      {publishes: speaks === undefined ? [] : [speaks], onRequest: []}, {
        connected: () => clock.restart(),
        warned: (warning) => tell({warning}),
        withdrawn: (topic) => {
          if (topic === '/playback') tell({speed: 1});
        },
        heard: () => {},
      });
  clock.start();
  const may = speaks !== undefined && await mayEncode();
  if (may) talker = new Talker(speaks, stream, clock);
  microphone.onmessage = ({data}: MessageEvent<Float32Array>) => talker?.heard(data);
  tell({mayEncode: may});
}

onmessage = ({data}: MessageEvent<ToVoiceWorker>) => {
  if ('join' in data) void join(data.join);
  else if (talker !== undefined) talker.open = data.open;
};
