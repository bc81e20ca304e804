import type {StationCompensation, StationState} from '../../messages/generated';
import {fixed} from '../numbers';
import type {Row} from '../../page/rows';

const mm = (m: number) => `${fixed(1000 * m, 1)} mm`;
const signed = (m: number) => `${m > 0.00005 ? '+' : ''}${mm(m)}`;
const mJ = (joule: number) => `${fixed(1000 * joule, 1)} mJ`;

/** A surface that is shifted by more than this hides a step between two snapshots. */
const SLEWED_M = 0.0005;
const DAMPED_N = 0.05;
/** The drive's largest force, 3 N, over 7 cm: more than any lift and position control of one contact needs. */
const MOST_DRIVE_J = 0.2;

/** A value that is less certain than this tells the hand nothing. */
const UNKNOWN_M = 0.01;

/** `value_m` with its bound; the bound alone, as a warning, where it is wide and larger than the value. */
function withBound(value_m: number, bound_m: number, text = mm): Pick<Row, 'value' | 'level'> {
  if (bound_m >= UNKNOWN_M && bound_m > Math.abs(value_m))
    return {value: `unknown, ± ${fixed(1000 * bound_m, 0)} mm`, level: 'warn'};
  return {value: `${text(value_m).replace(' mm', '')} ± ${mm(bound_m)}`};
}

/**
 * What the station compensates at the presented instant, by how much, and how sure it is: the whole list, no other
 * delay is compensated. `state`: of the same instant.
 */
export function compensationRows(
    compensation: StationCompensation | undefined, state: Pick<StationState, 'passivityJ'> | undefined): Row[] {
  if (compensation === undefined) return [{name: 'No data', value: 'no station reports'}];
  const {handCarriedM, handSigmaM, surfaceCarriedM, surfaceSigmaM, slewedM, dampingN, handExcessJ, driveJ} = compensation;
  const rows: Row[] = [
    {
      name: 'Hand predicted',
      ...withBound(handCarriedM, 2 * handSigmaM),
      says: `Distance from the tracker's newest sample, ${ms(compensation.handAgeS)} old, to the predicted hand. ± is two ` +
          'standard deviations.',
    },
    {
      name: 'Skin predicted',
      ...withBound(surfaceCarriedM, 2 * surfaceSigmaM, signed),
      says: `Predicted movement of the skin captured ${ms(compensation.surfaceAgeS)} ago. +: away from the body. ± is two standard ` +
          'deviations of noise, fit and prediction.',
    },
    {
      name: 'Hand moved to skin',
      value: mm(compensation.shownOffsetM),
      says: 'Distance of the drawn hand from the tracked hand. A hand that presses is drawn on the skin, not below it.',
    },
  ];
  if (Math.abs(slewedM) > SLEWED_M)
    rows.push({
      name: 'Skin, gradual change',
      value: signed(slewedM),
      says: 'Distance of the displayed skin from the measured one. It shrinks gradually, so that the skin never jumps.',
    });
  if (compensation.support < 0.995)
    rows.push({
      name: 'Contact displayed',
      value: `${Math.round(100 * compensation.support)} %`,
      says: 'Share of the contact force that the device gives. It is below 100 % where the surface is old or ends.',
      level: 'warn',
    });
  if (compensation.objects.some(({unseen, slideUnseen}) => slideUnseen && !unseen))
    rows.push({
      name: 'Inner objects',
      value: 'up and down only',
      says: 'Depth does not show whether smooth skin, such as a belly’s, slides along itself. If the patient moves ' +
          'sideways, the objects below this skin are felt where they lay before.',
    });
  rows.push(...deviceRows(compensation));
  rows.push(
      {
        name: 'Hand: excess work',
        value: mJ(handExcessJ),
        says: 'Work on the hand in this contact beyond the work that the newest measured skin would do.',
      },
      {
        name: 'Display: energy balance',
        value: state === undefined ? '–' : mJ(state.passivityJ),
        says: 'Energy taken from the hand less energy stored, relative to the displayed surface. Below 0: the display ' +
            'created energy.',
      },
      {
        name: 'Drive: work',
        value: mJ(driveJ),
        says: `Work of lift and position control on the hand since this contact began. Beyond ± ${1000 * MOST_DRIVE_J} mJ, the device swings or is held back.`,
        level: Math.abs(driveJ) > MOST_DRIVE_J ? 'warn' : undefined,
      },
      {
        name: 'Damping',
        value: `${fixed(dampingN, 2)} N`,
        says: 'Force of the passivity controller, which removes energy that the display created.',
        level: dampingN > DAMPED_N ? 'warn' : undefined,
      });
  return rows;
}

/** The delay of the device's own loop, and what it does to the stiffness that the hand feels. */
function deviceRows({loopDelayS, stiffnessLimitNPerM, effectsNPerM}: StationCompensation): Row[] {
  if (loopDelayS === undefined) return [];
  const softened = effectsNPerM > stiffnessLimitNPerM;
  const limit = `${fixed(stiffnessLimitNPerM, 0)} N/m`;
  return [{
    name: 'Device: loop delay',
    value: `${fixed(1000 * loopDelayS, 1)} ms${softened ? `, at most ${limit}` : ''}`,
    says: 'Age of the device’s reading plus age of its command, in 99 of 100 ticks at most this. With it, the device ' +
        `displays at most ${limit} without swinging; the scene asks for ${fixed(effectsNPerM, 0)} N/m.` +
        (softened ? ' So the hand feels a softer patient.' : ''),
    level: softened ? 'warn' : undefined,
  }];
}

function ms(seconds: number): string {
  return Number.isFinite(seconds) ? `${(1000 * seconds).toFixed(0)} ms` : 'an unknown time';
}
