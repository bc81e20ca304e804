import type {Vector3} from 'three';

import type {HandHolder, LetGo, ViewerHand} from './link/messages';
import {toCamera} from './scene/frames';
import type {SceneView} from './scene/scene_view';

const EVERY_MS = 10;
const HOVER_M = 0.05;     // over the skin, towards the camera
const PRESSED_M = -0.04;  // under it
const SINKS_M_PER_S = 0.1;
const RISES_M_PER_S = 0.25;
const FASTEST_M_PER_S = 0.5;
const LONGEST_STEP_S = 0.05;  // a browser that was busy for longer does not make up for it in one jump

/** Tells people who holds the hand, when that is not simply this page. */
class HolderNotice {
  private readonly box = document.createElement('div');
  private readonly text = document.createElement('span');
  private readonly letGo = document.createElement('button');

  constructor(giveUp: () => void) {
    this.box.className = 'hand-notice';
    this.box.hidden = true;
    this.box.setAttribute('role', 'status');
    this.letGo.type = 'button';
    this.letGo.textContent = 'Let go';
    this.letGo.addEventListener('click', giveUp);
    this.box.append(this.text, this.letGo);
    document.body.append(this.box);
  }

  show(text: string, offersToLetGo: boolean): void {
    this.box.hidden = text === '';
    this.text.textContent = text;
    this.letGo.hidden = !offersToLetGo;
  }
}

/**
 * A hand that the pointer holds: over the skin it hovers, and while the first button or a finger is down it presses
 * slowly in. It is told about 100 times a second while it is held. When the pointer leaves or the browser is busy it
 * falls silent: the station lets go, but the hand stays this viewer's. The button, a hidden page and the end of the
 * connection give it up; until then another viewer only asks.
 */
export class HeldHand {
  private pointer: {x: number; y: number; pressed: boolean} | undefined;
  private skin: Vector3 | undefined;
  private at: Vector3 | undefined;
  private height_m = HOVER_M;
  private timer: number | undefined;
  private stepped_ms = 0;
  private holder: HandHolder = {viewer: 0n, asking: []};
  private mine = false;  // the server takes this viewer's hand
  private readonly notice = new HolderNotice(() => document.getElementById('hold-hand')?.click());

  constructor(
      private readonly view: SceneView,
      private readonly canvas: HTMLCanvasElement,
      private readonly tell: (hand: ViewerHand | LetGo) => void,
  ) {
    for (const moved of ['pointermove', 'pointerdown', 'pointerup'] as const)
      canvas.addEventListener(moved, ({clientX, clientY, buttons}) => {
        this.pointer = {x: clientX, y: clientY, pressed: (buttons & 1) === 1};
      });
    for (const gone of ['pointerleave', 'pointercancel'] as const)
      canvas.addEventListener(gone, () => (this.pointer = undefined));
    window.addEventListener('blur', () => (this.pointer = undefined));
    document.addEventListener('visibilitychange', () => {
      this.pointer = undefined;
      if (document.hidden && this.held) this.tell({letGo: true});
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
    if (!wanted) this.tell({letGo: true});
    this.showNotice();
    this.view.setTurning(!wanted);
    this.canvas.classList.toggle('holds-hand', wanted);
  }

  private step(): void {
    const now_ms = performance.now();
    const step_s = Math.min(LONGEST_STEP_S, (now_ms - this.stepped_ms) / 1000);
    this.stepped_ms = now_ms;
    if (this.pointer === undefined) return this.rest();
    this.skin = this.view.surfaceUnder(this.pointer.x, this.pointer.y) ?? this.skin;
    if (this.skin === undefined) return;
    const way_m = (this.pointer.pressed ? -SINKS_M_PER_S : RISES_M_PER_S) * step_s;
    this.height_m = Math.min(HOVER_M, Math.max(PRESSED_M, this.height_m + way_m));
    const towardsCamera = this.skin.clone().multiplyScalar(-1).normalize();
    const at = this.movedTowards(this.skin.clone().addScaledVector(towardsCamera, this.height_m), step_s);
    this.tell({sampledUs: BigInt(Math.round(1000 * now_ms)), handCamera: toCamera(at)});
  }

  /** `me`: this viewer's number at the server. A hand that has just become this viewer's begins over the skin. */
  showHolder(holder: HandHolder, me: bigint): void {
    const mine = me !== 0n && holder.viewer === me;
    if (mine && !this.mine) this.rest();
    this.mine = mine;
    this.holder = holder;
    this.showNotice();
  }

  private showNotice(): void {
    const {viewer, asking} = this.holder;
    const asked = this.held && this.mine && asking.length > 0;
    const waits = this.held && !this.mine && viewer !== 0n;
    this.notice.show(
        asked ? 'Another viewer asks for the hand.' :
        waits ? 'Another viewer holds the hand. It is told that you ask for it while you move yours.' : '',
        asked);
  }

  private rest(): void {
    this.at = undefined;
    this.height_m = HOVER_M;
  }

  /** No faster than a hand; a pointer jumps. */
  private movedTowards(wanted: Vector3, step_s: number): Vector3 {
    this.at ??= wanted.clone();
    return this.at.add(wanted.sub(this.at).clampLength(0, FASTEST_M_PER_S * step_s));
  }
}
