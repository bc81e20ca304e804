import type {StationState, Vec3} from '../messages/generated';
import {type Anchor, anchorByOnePose, anchorHeadset, isRefusal, pivotTip, type Touch} from './anchor_fit';
import {FrameFinder} from './frame_finder';
import {after, inverse, mean, minus, moved, norm, plus, type Rigid, turn} from './rigid';

/** The settings of one anchoring. */
export interface AnchorSettings {
  paper: boolean;   // S2's one pose of a flat hand, in place of touches
  level: boolean;   // the device's base is level, so that only heading and place are fitted
  repeats: number;  // touches of each place
}

/** A tracked hand or controller at one frame of the headset. */
export interface Tool {
  pose: Rigid;      // in the headset's reference space
  isFinger: boolean;  // true: the pose's origin is the finger's tip. false: a controller, whose tip pivot calibration finds
  palm: Rigid | undefined;  // pose of a hand's palm, with the fingers along -z; undefined for a controller
}

export const PLACES = 3;
const APART_M = 0.15;    // two places of the end-effector lie at least this far apart
const STILL_M = 0.004;   // tip and end-effector move less than this within STILL_FRAMES, or the touch is not taken
const STILL_FRAMES = 20;
const MOST_PIVOT_POSES = 400;
const LEAST_PIVOT_POSES = 20;

const NOWHERE: Vec3 = {x: 0, y: 0, z: 0};

export type Station = Pick<StationState, 'device' | 'deviceCamera' | 'workspaceShift'>;

/** A touch with a pose of the tool whose tip is at `touched`, as telepalp-mixed anchor reads it. */
interface KeptTouch extends Touch {
  pose: Rigid;
}

/** S2: the depth camera's x right, y down, z forward are the scene's x, -y, -z. */
const inScene = ({x, y, z}: Vec3): Vec3 => ({x, y: -y, z: -z});
const unshifted = (at: Vec3, shift: Vec3 | undefined): Vec3 => (shift === undefined ? at : minus(at, shift));

/**
 * Anchors a headset to the haptic device, so that the patient is seen where he is felt. The doctor touches the
 * end-effector, whose position the station publishes, at three places. Pure: no clock, socket or page.
 */
export class Anchoring {
  /** The anchor in use; undefined: not anchored, or the headset has reset its reference space. */
  anchor: Anchor | undefined;
  /** What the user does next, and why the last touch was not taken; at most three lines. */
  note = '';

  private readonly frames = new FrameFinder();
  private recent: {tip: Vec3; device: Vec3; pose: Rigid; palm: Rigid | undefined}[] = [];
  private touches: KeptTouch[] = [];
  private pivot: Rigid[] = [];
  private tip: Vec3 | undefined;  // of a controller, in its own frame
  private holds = false;          // the user holds the trigger or a pinch
  private tool: Tool | undefined;
  private station: Station | undefined;
  private problem = '';

  constructor(private readonly settings: AnchorSettings) {}

  /** One frame of the headset. undefined: the tool is not tracked, or the station is silent. */
  frame(tool: Tool | undefined, station: Station | undefined): void {
    [this.tool, this.station] = [tool, station];
    if (station?.device !== undefined && station.deviceCamera !== undefined)
      this.frames.add(station.device, inScene(station.deviceCamera));
    if (tool !== undefined && this.needsPivot) {
      if (this.holds && this.pivot.length < MOST_PIVOT_POSES) this.pivot.push(tool.pose);
    } else if (tool !== undefined && station?.device !== undefined) {
      const tip = moved(tool.pose, tool.isFinger ? NOWHERE : this.tip ?? NOWHERE);
      const device = unshifted(station.device, station.workspaceShift);
      this.recent = [...this.recent.slice(1 - STILL_FRAMES), {tip, device, pose: tool.pose, palm: tool.palm}];
    } else {
      this.recent = [];
    }
    this.note = this.sentence();
  }

  /** The user pulls the trigger or begins a pinch: a touch is taken, or pivot calibration begins. */
  press(): void {
    this.holds = true;
    this.problem = '';
    if (this.anchor !== undefined || this.needsPivot) return;
    const obstacle = this.obstacle();
    if (obstacle !== '') this.problem = obstacle;
    else this.settings.paper ? this.takePose() : this.takeTouch();
    this.note = this.sentence();
  }

  /** The user lets go of the trigger or ends the pinch. */
  release(): void {
    if (this.holds && this.needsPivot && this.pivot.length >= LEAST_PIVOT_POSES) this.endPivot();
    this.holds = false;
  }

  /** Starts again with the first touch, and keeps the controller's tip. `why`: a sentence for the user. */
  again(why = ''): void {
    [this.touches, this.recent, this.anchor, this.problem] = [[], [], undefined, why];
    this.note = this.sentence();
  }

  /** headset_from_scene, for the workspace shift of the newest state; undefined: not anchored. */
  get headsetFromScene(): Rigid | undefined {
    const sceneFromHaptic = this.frames.sceneFromHaptic;
    if (this.anchor === undefined || sceneFromHaptic === undefined) return undefined;
    const shift = this.station?.workspaceShift ?? NOWHERE;
    const deviceFromHaptic = {rotation: {x: 0, y: 0, z: 0, w: 1}, translation: minus(NOWHERE, shift)};
    return after(this.anchor.headsetFromDevice, after(deviceFromHaptic, inverse(sceneFromHaptic)));
  }

  /** The touches as the table that `telepalp-mixed anchor` reads; rows of place -1 are the poses of pivot calibration. */
  get table(): string {
    const numbers = (values: readonly number[]) => values.map((value) => value.toFixed(6)).join(',');
    const row = (place: number, known: Vec3, {rotation, translation}: Rigid) => {
      const sine = Math.hypot(rotation.x, rotation.y, rotation.z);  // of half the angle
      const scale = sine < 1e-9 ? 2 : 2 * Math.atan2(sine, rotation.w) / sine;
      const {x, y, z} = translation;
      return `${place},${numbers([known.x, known.y, known.z, x, y, z, scale * rotation.x, scale * rotation.y, scale * rotation.z])}\n`;
    };
    return 'place,known_x_m,known_y_m,known_z_m,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad\n' +
        (this.tip === undefined ? '' : this.pivot.map((pose) => row(-1, NOWHERE, pose)).join('')) +
        this.touches.map(({place, known, pose}) => row(place, known, pose)).join('');
  }

  get taken(): number {
    return this.touches.length;
  }

  private get needsPivot(): boolean {
    return !this.settings.paper && this.tool !== undefined && !this.tool.isFinger && this.tip === undefined;
  }

  private get place(): number {
    return Math.floor(this.touches.length / this.settings.repeats);
  }

  private endPivot(): void {
    const tip = pivotTip(this.pivot);
    if (isRefusal(tip)) [this.pivot, this.problem] = [[], `${tip.what} ${tip.fix}`];
    else this.tip = tip;
  }

  /** Why no touch can be taken now, for the user; empty: a touch can be taken. */
  private obstacle(): string {
    if (this.tool === undefined) return 'The headset does not see the hand.';
    if (this.station?.device === undefined) return 'The station sends no place of the end-effector.';
    const first = this.recent[0];
    if (first === undefined || this.recent.length < STILL_FRAMES) return 'Hold still for a moment.';
    if (this.recent.some(({tip, device}) => norm(minus(tip, first.tip)) > STILL_M || norm(minus(device, first.device)) > STILL_M))
      return 'The tip or the end-effector moves: hold still.';
    const near = this.touches.find(({place, known}) => place !== this.place && norm(minus(known, first.device)) < APART_M);
    if (!this.settings.paper && near !== undefined)
      return `Move the end-effector at least ${100 * APART_M} cm away from the other places.`;
    if (this.settings.paper && this.frames.sceneFromHaptic === undefined) return 'Move the end-effector about first.';
    return '';
  }

  private takeTouch(): void {
    const {tip, pose} = this.recent[this.recent.length - 1]!;
    const touched = mean(this.recent.map((one) => one.tip));
    this.touches.push({
      place: this.place, known: mean(this.recent.map(({device}) => device)), touched,
      pose: {...pose, translation: plus(pose.translation, minus(touched, tip))},
    });
    if (this.touches.length < PLACES * this.settings.repeats) return;
    const anchor = anchorHeadset(this.touches, this.settings.level);
    if (isRefusal(anchor)) this.again(`${anchor.what} ${anchor.fix}`);
    else this.anchor = anchor;
  }

  private takePose(): void {
    const {device, palm} = this.recent[this.recent.length - 1]!;
    const hand = palm ?? this.tool!.pose;
    const anchor = anchorByOnePose(device, hand.translation, turn(hand.rotation, {x: 0, y: 0, z: -1}));
    if (isRefusal(anchor)) this.problem = `${anchor.what} ${anchor.fix}`;
    else this.anchor = anchor;
  }

  private sentence(): string {
    const problem = this.problem === '' ? '' : `${this.problem}\n`;
    if (this.anchor !== undefined) {
      const misses = Number.isNaN(this.anchor.rms_m) ? 'One pose has no residual.' : `The touches miss by ${(1e3 * this.anchor.rms_m).toFixed(1)} mm.`;
      return `Anchored. ${misses}\nSqueeze the controller, or press Anchor: again.`;
    }
    if (this.needsPivot)
      return `${problem}Rest the controller's end on a fixed point.\nHold the trigger, and turn the controller widely.`;
    if (this.settings.paper) return `${problem}Lay a flat hand on the end-effector, fingers away from you.\nThen pinch with the other hand.`;
    const repeat = this.settings.repeats === 1 ? '' : `, touch ${1 + (this.touches.length % this.settings.repeats)} of ${this.settings.repeats}`;
    return `${problem}Place ${this.place + 1} of ${PLACES}${repeat}: put the tip on the end-effector, hold still.\n` +
        `Then pull the trigger, or pinch with the other hand.`;
  }
}
