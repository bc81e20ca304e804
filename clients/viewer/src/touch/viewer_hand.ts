import type {Vector3} from 'three';

import type {HandHolder} from '../messages/generated';
import {NOBODY} from '../messages/nobody';
import type {OwnTopics} from '../messages/topics';
import {toCamera} from '../scene/frames';
import type {SceneView} from '../scene/scene_view';
import type {HandSteering} from './hand_steering';
import type {Pointer} from './steering';

const EVERY_MS = 10;
const HOVER_M = 0.05;     // height over the skin, towards the camera
const PRESSED_M = -0.04;  // height of a pressing hand: below the skin
const SINKS_M_PER_S = 0.1;
const RISES_M_PER_S = 0.25;
const REST_PX = 3;
const REST_MS = 1200;
const LONGEST_STEP_S = 0.05;  // after a longer pause of the browser the hand does not sink further
const ASK_TIMES = 5;        // a message may be lost
const ASK_EVERY_MS = 100;

/** The text that tells the user who holds the hand; empty if only this page does. */
class HolderNotice {
  private readonly box = document.createElement('div');
  private readonly text = document.createElement('span');
  private readonly handOver = document.createElement('button');

  constructor(handOver: () => void) {
    this.box.className = 'hand-notice';
    this.box.hidden = true;
    this.box.setAttribute('role', 'status');
    this.handOver.type = 'button';
    this.handOver.textContent = 'Hand over';
    this.handOver.addEventListener('click', handOver);
    this.box.append(this.text, this.handOver);
    document.body.append(this.box);
  }

  show(text: string, offersToHandOver: boolean): void {
    this.box.hidden = text === '';
    this.text.textContent = text;
    this.handOver.hidden = !offersToHandOver;
  }
}

/**
 * A hand that follows the pointer, keys, a gamepad, or the hand that a headset tracks. It hovers over the skin, and it
 * presses slowly in while the first button or a finger is down. The station limits its speed, and flies it over the
 * patient while nothing presses. Its position is sent about 100 times a second. When the pointer leaves the picture or
 * the browser is busy, nothing is sent: the station releases, and after 2 s another viewer may take the hand. The
 * button, a hidden page or the end of the connection gives up the hand, and *Hand over* passes it to a viewer that
 * asks. Until one of these happens, other viewers can only ask for it.
 */
export class ViewerHandInput {
  private pointer: Pointer | undefined;
  private skin: Vector3 | undefined;
  private height_m = HOVER_M;
  private timer: number | undefined;
  private stepped_ms = 0;
  private holder: HandHolder = NOBODY;
  private mine = false;  // true: this viewer holds the hand
  private rested: Pointer & {since_ms: number} | undefined;
  private pressEnded = false;  // until the button or finger is up
  /** The hand that a headset tracks, in the scene's frame [m]; undefined: none. It overrides the pointer. */
  tracked: Vector3 | undefined;
  /** Keys and gamepad that steer the hand; set once, after construction. */
  steering: HandSteering | undefined;
  private readonly notice = new HolderNotice(() => this.handOver());

  constructor(
      private readonly view: SceneView,
      private readonly canvas: HTMLCanvasElement,
      private readonly publish: (hand: OwnTopics['/viewer/hand']) => void,
  ) {
    for (const moved of ['pointermove', 'pointerdown', 'pointerup'] as const)
      canvas.addEventListener(moved, ({clientX, clientY, buttons}) => {
        this.pointer = {x: clientX, y: clientY, press: (buttons & 1) === 1 ? 1 : 0};
        if (this.pointer.press === 0) this.pressEnded = false;  // also when it is down again before the next step
      });
    for (const gone of ['pointerleave', 'pointercancel'] as const)
      canvas.addEventListener(gone, () => (this.pointer = undefined));
    window.addEventListener('blur', () => (this.pointer = undefined));
    document.addEventListener('visibilitychange', () => {
      this.pointer = undefined;
      if (document.hidden && this.held) this.publish({letGo: true});
    });
  }

  get held(): boolean {
    return this.timer !== undefined;
  }

  setHeld(wanted: boolean): void {
    if (wanted === this.held) return;
    window.clearInterval(this.timer);
    this.timer = wanted ? window.setInterval(() => this.step(), EVERY_MS) : undefined;
    this.rest();
    if (!wanted) this.publish({letGo: true});
    this.showNotice();
    this.view.setTurning(!wanted);
    this.canvas.classList.toggle('holds-hand', wanted);
  }

  /** True if the pointer has not moved, and not changed its press, for a second. */
  get pointerRests(): boolean {
    return this.held && this.rested !== undefined && performance.now() - this.rested.since_ms > REST_MS;
  }

  /** Lets the hand rise from the skin, until the button or finger is up and down again. */
  endPress(): void {
    this.pressEnded = true;
  }

  private noteRest(pointer: Pointer, now_ms: number): void {
    const {rested} = this;
    if (rested !== undefined && rested.press === pointer.press && Math.hypot(rested.x - pointer.x, rested.y - pointer.y) < REST_PX) return;
    this.rested = {...pointer, since_ms: now_ms};
  }

  private step(): void {
    const now_ms = performance.now();
    const step_s = Math.min(LONGEST_STEP_S, (now_ms - this.stepped_ms) / 1000);
    this.stepped_ms = now_ms;
    if (this.tracked !== undefined) return this.send(this.tracked, now_ms, false);
    this.pointer = this.steering?.move(step_s) ?? this.pointer;
    if (this.pointer === undefined) return this.rest();
    this.noteRest(this.pointer, now_ms);
    this.skin = this.view.surfaceUnder(this.pointer.x, this.pointer.y) ?? this.skin;
    if (this.skin === undefined) return;
    if (this.pointer.press === 0) this.pressEnded = false;
    const press = this.pressEnded ? 0 : this.pointer.press;
    const way_m = (press > 0 ? -SINKS_M_PER_S * press : RISES_M_PER_S) * step_s;
    this.height_m = Math.min(HOVER_M, Math.max(PRESSED_M, this.height_m + way_m));
    const towardsCamera = this.skin.clone().multiplyScalar(-1).normalize();
    this.send(this.skin.clone().addScaledVector(towardsCamera, this.height_m), now_ms, press === 0);
  }

  private send(at: Vector3, now_ms: number, hovers: boolean): void {
    this.publish({sampledUs: BigInt(Math.round(1000 * now_ms)), handCamera: toCamera(at), hovers});
  }

  /** Asks the station to re-arm after a fault. */
  rearm(): void {
    this.ask({rearm: true});
  }

  /** Tells the station that the object over the hand's place is skin. */
  acceptObject(): void {
    this.ask({acceptObject: true});
  }

  private ask(what: OwnTopics['/viewer/hand']): void {
    for (let time = 0; time < ASK_TIMES; ++time) setTimeout(() => this.publish(what), time * ASK_EVERY_MS);
  }

  /** `me`: this viewer's number at the server. When this viewer gets the hand, the hand starts over the skin. */
  showHolder(holder: HandHolder, me: bigint): void {
    const mine = me !== 0n && holder.viewer === me;
    if (mine && !this.mine) this.rest();
    this.mine = mine;
    this.holder = holder;
    this.showNotice();
  }

  /** Passes the hand to the viewer that asks, and stops moving it. */
  private handOver(): void {
    const [to] = this.holder.asking;
    if (to === undefined) return;
    this.publish({handOverTo: to});
    document.getElementById('hold-hand')?.click();
  }

  private showNotice(): void {
    const {viewer, asking} = this.holder;
    const asked = this.held && this.mine && asking.length > 0;
    const waits = this.held && !this.mine && viewer !== 0n;
    this.notice.show(
        asked ? 'Another viewer asks for the hand.' :
        waits ? 'Another viewer holds the hand. Move the pointer over the skin to ask for it.' : '',
        asked);
  }

  private rest(): void {
    this.rested = undefined;
    this.height_m = HOVER_M;
  }
}
