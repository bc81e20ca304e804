/** What keys or a gamepad ask of the hand: speed right and down on the screen, -1 to 1, and pressure, 0 to 1. */
export interface Intent {
  right: number;
  down: number;
  press: number;
}

/** A place on the page, and how hard the hand presses there. */
export interface Pointer {
  x: number;
  y: number;
  press: number;
}

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Time in which a key or a fully deflected stick moves the hand across the picture's shorter side [s]. */
const ACROSS_S = 3;
/** Dead zone: a released stick is off its middle by up to this share of its full deflection. */
const DEAD = 0.15;

const within = (value: number, least: number, most: number) => Math.min(most, Math.max(least, value));
const live = (axis: number | undefined) =>
    Math.abs(axis ?? 0) < DEAD ? 0 : within(((axis ?? 0) - Math.sign(axis ?? 0) * DEAD) / (1 - DEAD), -1, 1);

/** Where the hand is after `step_s` seconds: it stays in the picture, and begins in its middle. */
export function steered(pointer: Pointer | undefined, {right, down, press}: Intent, box: Box, step_s: number): Pointer {
  const {x, y} = pointer ?? {x: box.left + box.width / 2, y: box.top + box.height / 2};
  const way = (Math.min(box.width, box.height) * step_s) / ACROSS_S;
  return {
    x: within(x + right * way, box.left, box.left + box.width - 1),
    y: within(y + down * way, box.top, box.top + box.height - 1),
    press,
  };
}

/** The left stick moves, the right trigger presses as far as it is pulled; by the standard mapping of gamepads. */
export function intentOfGamepad({axes, buttons}: Pick<Gamepad, 'axes' | 'buttons'>): Intent {
  return {right: live(axes[0]), down: live(axes[1]), press: within(buttons[7]?.value ?? 0, 0, 1)};
}

/** The keys that are down: arrows move, Enter presses. */
export function intentOfKeys(down: ReadonlySet<string>): Intent {
  const axis = (less: string, more: string) => Number(down.has(more)) - Number(down.has(less));
  return {right: axis('ArrowLeft', 'ArrowRight'), down: axis('ArrowUp', 'ArrowDown'), press: down.has('Enter') ? 1 : 0};
}

export const isAtRest = ({right, down, press}: Intent) => right === 0 && down === 0 && press === 0;

/** The strength of a gamepad's rumble, 0 to 1: the force's share of `peak_N`, and 0 below 2 %, which cannot be felt. */
export function rumbleOf(force_N: number | undefined, peak_N: number): number {
  const share = (force_N ?? 0) / peak_N;
  return share < 0.02 ? 0 : within(share, 0, 1);
}
