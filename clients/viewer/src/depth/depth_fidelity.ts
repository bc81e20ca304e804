import type {DepthImage} from '../messages/generated';

/** The accuracy that a depth image states. The texts are the same as in proto/wire/depth_loss. */
export interface DepthFidelity {
  moved: boolean;  // true: depth may differ from the measurement
  mode: string;    // of the codec; empty: not stated
  howFar: string;  // "off by up to 2.85 mm at 1 m"
  more: string;    // explanation for the user
}

const MOVING_MODE = 'bounded';
const LONGEST_MODE = 32;

/** False for NaN, too. */
const isCredible = (bound: number) => bound >= 0 && bound <= 1;

const millimetres = (m: number) => `${Number((1000 * m).toPrecision(3))} mm`;

export function depthFidelity({format, bound}: Pick<DepthImage, 'format' | 'bound'>): DepthFidelity {
  const mode = format.slice(0, LONGEST_MODE);
  if (bound === undefined && mode !== MOVING_MODE)
    return {moved: false, mode, howFar: mode === '' ? 'not stated' : 'lossless', more: ''};
  const more = 'Depth is near-lossless to save bytes: it is for looking at, not for touching.';
  if (bound === undefined || !isCredible(bound.leastM) || !isCredible(bound.perM))
    return {moved: true, mode, howFar: 'off by an unknown amount', more};
  return {
    moved: true,
    mode,
    howFar: `off by up to ${millimetres(Math.max(bound.leastM, bound.perM))} at 1 m`,
    more: `${more} At z metres from the camera its error is at most ${millimetres(bound.perM)} times z squared, or ` +
        `${millimetres(bound.leastM)} where that is larger.`,
  };
}

export const inWords = ({mode, howFar}: DepthFidelity) => (mode === '' ? howFar : `${mode}, ${howFar}`);
