import type {SurfaceReport} from '../../messages/generated';
import type {Row} from '../../page/rows';

/** The stages of a frame on its way to the hand: from one instant of the report to the next. */
const STAGES: readonly {name: string; from: keyof SurfaceReport; to: keyof SurfaceReport; says: string}[] = [
  {name: 'Camera and encoder', from: 'capturedNs', to: 'encodedNs', says: 'From the exposure until the frame is ready to send'},
  {name: 'Network to station', from: 'encodedNs', to: 'receivedNs', says: 'From the server to the station'},
  {name: 'Decoder', from: 'receivedNs', to: 'decodedNs', says: 'At the station: waiting for the decoder, then decoding'},
  {name: 'Surface', from: 'decodedNs', to: 'touchableNs', says: 'At the station: building the surface, until the 2 kHz loop can use it'},
];
const LATE_MS = 100;

/** The way of the newest frame to the hand, stage by stage, and its sum. Empty without a station. */
export function delayRows(report: SurfaceReport | undefined): Row[] {
  if (report === undefined || report.touchableNs === 0n) return [{name: 'No frame at the hand', value: '–'}];
  const ms = (from: bigint, to: bigint) => Number(to - from) / 1e6;
  const whole_ms = ms(report.capturedNs, report.touchableNs);
  return [
    {
      name: 'Camera to hand',
      value: `${whole_ms.toFixed(0)} ms`,
      says: 'From the exposure until the surface can be touched',
      level: whole_ms > LATE_MS ? 'warn' : undefined,
    },
    ...STAGES.map(({name, from, to, says}) => ({
      name, says, part: true, value: `${ms(report[from] as bigint, report[to] as bigint).toFixed(1)} ms`,
    })),
  ];
}
