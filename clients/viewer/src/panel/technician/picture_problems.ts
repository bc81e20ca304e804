import type {DepthSummary} from '../../depth/depth_summary';
import type {Light} from '../../present/instant';
import type {Row} from '../../page/rows';

/** From this value on a row warns, and from this one it alarms. */
interface Limits {
  warn: number;
  alarm: number;
}
const HOLES: Limits = {warn: 0.05, alarm: 0.2};
const LEVEL_M: Limits = {warn: 0.003, alarm: 0.006};
const CLIPPED: Limits = {warn: 0.05, alarm: 0.2};
const ASIDE: Limits = {warn: 0.3, alarm: 0.5};
const NEAREST_M = 0.5;   // nearer, structured light and time of flight measure nothing
const FARTHEST_M = 1.6;  // farther, one level of a disparity sensor is more than 7 mm
const DARK = 55;         // mean luminance of 0 to 255
const BRIGHT = 215;

const levelOf = (value: number, {warn, alarm}: Limits): Row['level'] =>
  value >= alarm ? 'alarm' : value >= warn ? 'warn' : 'good';
const percent = (share: number) => `${(100 * share).toFixed(1)} %`;

/**
 * How good the picture is for touching the patient: each property with its value, and how to mend what is bad.
 * `frames_per_s`: of the camera; undefined without one, as in a played session.
 */
export function pictureRows(
    {holes, middle_m, level_m, aside}: DepthSummary, light: Light | undefined, frames_per_s: number | undefined): Row[] {
  return [
    {name: 'Holes', value: percent(holes), level: levelOf(holes, HOLES),
     says: 'Share of the picture’s middle that is not measured. Aim the camera straight at the skin, keep sunlight ' +
         'off the skin, and cover shiny things.'},
    distanceRow(middle_m),
    {name: 'Depth step', value: level_m === 0 ? '–' : `${(1000 * level_m).toFixed(1)} mm`, level: levelOf(level_m, LEVEL_M),
     says: 'The step between neighbouring depth levels at the patient. It grows with the square of the distance: move ' +
         'the camera nearer.'},
    framingRow(aside),
    ...lightRows(light),
    ...frames_per_s === undefined ? [] : [rateRow(frames_per_s)],
  ];
}

function distanceRow(middle_m: number): Row {
  const [tooNear, tooFar] = [middle_m < NEAREST_M, middle_m > FARTHEST_M];
  return {
    name: 'Distance',
    value: middle_m === 0 ? '–' : `${middle_m.toFixed(2)} m`,
    level: tooNear || tooFar ? 'alarm' : 'good',
    says: `From the camera to the picture’s middle. ${NEAREST_M} to ${FARTHEST_M} m is good. ` +
        (middle_m === 0 ? 'The middle is not measured: see Holes.' : tooNear ? 'Move the camera away.' : tooFar ? 'Move the camera nearer.' : 'Leave the camera where it is.'),
  };
}

const rateRow = (frames_per_s: number): Row => ({
  name: 'Images', value: `${frames_per_s.toFixed(1)} /s`, level: frames_per_s < 20 ? 'warn' : 'good',
  says: 'Depth images that the camera gave in the last second.',
});

function framingRow({x, y}: DepthSummary['aside']): Row {
  const off = Math.max(Math.abs(x), Math.abs(y));
  const side = Math.abs(x) >= Math.abs(y) ? (x < 0 ? 'left' : 'right') : (y < 0 ? 'top' : 'bottom');
  return {
    name: 'Framing',
    value: off < ASIDE.warn ? 'centred' : `at the ${side}`,
    level: levelOf(off, ASIDE),
    says: 'Place of the nearest part, the patient’s front, in the picture. Turn the camera until this part is centred.',
  };
}

function lightRows(light: Light | undefined): Row[] {
  if (light === undefined) return [{name: 'Light', value: 'no colour', says: 'No colour image has come.'}];
  const {mean, clipped} = light;
  const word = mean < DARK ? 'too dark' : mean > BRIGHT ? 'too bright' : 'good';
  return [
    {name: 'Light', value: `${word} (${mean.toFixed(0)})`, level: word === 'good' ? 'good' : 'warn',
     says: 'Mean brightness of the colour image, 0 to 255. If not good, change the lamps or the exposure.'},
    {name: 'Overexposed', value: percent(clipped), level: levelOf(clipped, CLIPPED),
     says: 'Share of the colour image that is white. Turn lamps away, or lower the exposure.'},
  ];
}
