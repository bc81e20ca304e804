import type {NetworkState as NetworkMessage} from '../messages/generated';
import type {Row} from '../page/rows';

/** The network between the played session and its receivers. */
export interface NetworkState extends Record<NetworkNumber, number> {
  profile: string;
  changed: boolean;
  packets_sent: number;
  packets_lost: number;
  images_arrived: number;
  images_late: number;
  images_lost: number;
  image_delay_ms: number;
}

export type NetworkNumber = 'delay_ms' | 'jitter_ms' | 'loss_percent' | 'burst_packets' | 'rate_Mbit_per_s';

/** The body of POST /playback/network. The profile applies first. */
export type NetworkCommand = {profile?: string} & Partial<Record<NetworkNumber, number>>;

/** One slider: its values in order. The server's bounds lie around them. */
export interface NetworkSlider {
  field: NetworkNumber;
  name: string;
  unit: string;
  values: readonly number[];
}

const steps = (most: number, step: number, least = 0) =>
    Array.from({length: Math.round((most - least) / step) + 1}, (_, at) => Math.round((least + at * step) * 100) / 100);

export const PROFILES = ['none', 'lan', 'lte', 'satellite', 'hostile'];
export const SLIDERS: readonly NetworkSlider[] = [
  {field: 'delay_ms', name: 'Delay', unit: 'ms', values: steps(600, 5)},
  {field: 'jitter_ms', name: 'Jitter', unit: 'ms', values: steps(200, 2)},
  {field: 'loss_percent', name: 'Loss', unit: '%', values: steps(30, 0.5)},
  {field: 'burst_packets', name: 'Loss bursts', unit: 'packets', values: steps(20, 1, 1)},
  {field: 'rate_Mbit_per_s', name: 'Rate', unit: 'Mbit/s', values: [0.5, 1, 2, 5, 10, 15, 20, 30, 40, 50, 60, 100, 200, 1000, 0]},
];

export function readNetwork(message: NetworkMessage): NetworkState {
  return {
    profile: message.profile, changed: message.changed, delay_ms: message.delayMs, jitter_ms: message.jitterMs,
    loss_percent: message.lossPercent, burst_packets: message.burstPackets, rate_Mbit_per_s: message.rateMbitPerS,
    packets_sent: Number(message.packetsSent), packets_lost: Number(message.packetsLost),
    images_arrived: Number(message.imagesArrived), images_late: Number(message.imagesLate),
    images_lost: Number(message.imagesLost), image_delay_ms: message.imageDelayMs,
  };
}

/** What two commands do one after the other, as one. */
export function joined(first: NetworkCommand, then: NetworkCommand): NetworkCommand {
  return then.profile === undefined ? {...first, ...then} : then;
}

/** The place of the slider nearest to `value`. A rate of 0 is unlimited: the last place. */
export function placeOf({values}: NetworkSlider, value: number): number {
  let best = 0;
  values.forEach((one, at) => {
    if (Math.abs(one - value) < Math.abs(values[best]! - value)) best = at;
  });
  return best;
}

export function textOf({field, unit}: NetworkSlider, value: number): string {
  if (field === 'rate_Mbit_per_s' && value === 0) return 'unlimited';
  return `${Math.round(value * 10) / 10} ${field === 'burst_packets' && value === 1 ? 'packet' : unit}`;
}

/** What is in effect, and what it did since the settings were changed. */
export function networkRows(state: NetworkState): Row[] {
  const {profile, changed, packets_sent, packets_lost, images_arrived, images_late, images_lost} = state;
  const impairs = changed || profile !== 'none';
  const effect: Row = {name: 'In effect', value: changed ? `${profile}, changed` : profile, level: impairs ? 'warn' : undefined};
  if (!impairs) return [{...effect, value: 'none, as recorded'}];
  const images = images_arrived + images_late + images_lost;
  return [
    effect,
    {name: 'Packets', value: `${packets_sent}, ${share(packets_lost, packets_sent)} lost`,
     says: 'Packets sent since these settings last changed, and the share lost on the way or in a full queue'},
    {name: 'Images', value: `${images_arrived} of ${images} arrived`, says: 'Depth images since these settings last changed'},
    {name: 'too late', value: String(images_late), part: true, says: 'Complete only after a newer one, so dropped'},
    {name: 'lost', value: String(images_lost), part: true,
     says: 'Incomplete, replaced by a newer one before sending, or predicted from an image that is missing'},
    {name: 'Image delay', value: `${state.image_delay_ms.toFixed(0)} ms`, says: 'How long the newest depth image was in the network'},
  ];
}

const share = (part: number, all: number) => `${all === 0 ? 0 : (100 * part / all).toFixed(1)} %`;
