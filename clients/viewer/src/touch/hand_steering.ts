import {FULL_SCALE_N} from '../scene/force_color';
import {type Box, type Intent, intentOfGamepad, intentOfKeys, isAtRest, type Pointer, rumbleOf, steered} from './steering';

const LOOK_EVERY_MS = 50;
const RUMBLE_MS = 150;  // longer than the time between two calls of feel()
const TOUCH_BUTTON = 0;  // A on an Xbox gamepad, the cross on a PlayStation's

/** Steers a doctor's hand without a device: by a gamepad, which rumbles with the force, or by Shift, arrows, Enter. */
export class HandSteering {
  private readonly keys = new Set<string>();
  private pointer: Pointer | undefined;
  private pressedBefore = false;

  /** `flipTouch`: begins or ends the touch, as the page's Touch button does. */
  constructor(private readonly canvas: HTMLElement, private readonly held: () => boolean, private readonly flipTouch: () => void) {
    window.addEventListener('keydown', (event) => this.keyDown(event), {capture: true});
    window.addEventListener('keyup', ({key}) => {
      if (key === 'Shift') this.keys.clear();
      this.keys.delete(key);
    });
    window.addEventListener('blur', () => this.keys.clear());
    canvas.addEventListener('pointermove', () => (this.pointer = undefined));  // a moved mouse ends the steering
    window.setInterval(() => this.lookAtButton(), LOOK_EVERY_MS);
  }

  /** The place of the steered hand; undefined until keys or a gamepad steer it, and again once the mouse moves. */
  move(step_s: number): Pointer | undefined {
    const intent = this.intent();
    if (this.pointer === undefined && isAtRest(intent)) return undefined;
    const {left, top, width, height} = this.canvas.getBoundingClientRect();
    const box: Box = {left, top, width, height};
    this.pointer = steered(this.pointer, intent, box, step_s);
    return this.pointer;
  }

  /** Makes the gamepad rumble with the force; call it about ten times a second. */
  feel(force_N: number | undefined): void {
    const strength = this.held() && this.pointer !== undefined ? rumbleOf(force_N, FULL_SCALE_N) : 0;
    const actuator = gamepad()?.vibrationActuator;
    if (strength === 0 || actuator === undefined || actuator === null) return;
    actuator.playEffect('dual-rumble', {duration: RUMBLE_MS, strongMagnitude: strength, weakMagnitude: 0.5 * strength})
        .catch(() => undefined);  // a gamepad that cannot shake stays still
  }

  private intent(): Intent {
    const pad = gamepad();
    const byPad = pad === undefined ? undefined : intentOfGamepad(pad);
    return byPad === undefined || isAtRest(byPad) ? intentOfKeys(this.keys) : byPad;
  }

  /** With Shift, the arrows move the hand; without it, they turn the view. */
  private keyDown(event: KeyboardEvent): void {
    if (!this.held() || !event.shiftKey || !(event.key.startsWith('Arrow') || event.key === 'Enter')) return;
    if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
    event.preventDefault();
    event.stopPropagation();
    this.keys.add(event.key);
  }

  private lookAtButton(): void {
    const pressed = gamepad()?.buttons[TOUCH_BUTTON]?.pressed ?? false;
    if (pressed && !this.pressedBefore) this.flipTouch();
    this.pressedBefore = pressed;
  }
}

const gamepad = () => navigator.getGamepads?.().find((pad) => pad !== null) ?? undefined;
