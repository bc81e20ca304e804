import {Anchoring, type AnchorSettings, type Station, type Tool} from './anchoring';
import {matrixOf, type Rigid} from './rigid';

/** The part of the scene's headset that the anchor uses. */
export interface AnchoredScene {
  /** Places the patient. `matrix`: headset_from_scene, 4 x 4, column by column. */
  place(matrix: readonly number[]): void;
  /** Shows a picture in front of the user; undefined: removes it. */
  showNote(picture: HTMLCanvasElement | undefined): void;
}

const SHOWN_AFTER_MS = 5000;  // how long the last note stays after the headset is anchored
const NOTE = {width: 1024, height: 256};  // pixels

/** The settings in the page's address: ?anchor=paper, ?gravity=unknown, ?touches=5. */
export function settingsOf(query: URLSearchParams): AnchorSettings {
  const repeats = Math.round(Number(query.get('touches') ?? 1));
  return {
    paper: query.get('anchor') === 'paper',
    level: query.get('gravity') !== 'unknown',
    repeats: repeats >= 1 && repeats <= 20 ? repeats : 1,
  };
}

const rigidOf = ({position, orientation}: XRRigidTransform): Rigid => ({
  rotation: {x: orientation.x, y: orientation.y, z: orientation.z, w: orientation.w},
  translation: {x: position.x, y: position.y, z: position.z},
});

/** The tool of the right hand, or of the other one if the right one is not tracked. */
function toolIn(frame: XRFrame, session: XRSession, space: XRReferenceSpace): Tool | undefined {
  const tools = Array.from(session.inputSources, (source) => {
    const joint = (name: XRHandJoint) => {
      const of = source.hand?.get(name);
      return of && frame.getJointPose?.(of, space);
    };
    const finger = joint('index-finger-tip');
    const palm = joint('middle-finger-metacarpal');
    const pose = finger ?? (source.gripSpace && !source.hand ? frame.getPose(source.gripSpace, space) : undefined);
    return {
      right: source.handedness === 'right',
      tool: pose ? {pose: rigidOf(pose.transform), isFinger: finger != null, palm: palm ? rigidOf(palm.transform) : undefined} : undefined,
    };
  }).filter(({tool}) => tool !== undefined);
  return (tools.find(({right}) => right) ?? tools[0])?.tool;
}

function noteOf(text: string): HTMLCanvasElement {
  const canvas = Object.assign(document.createElement('canvas'), NOTE);
  const pen = canvas.getContext('2d')!;
  pen.fillStyle = '#10161d';
  pen.fillRect(0, 0, NOTE.width, NOTE.height);
  pen.fillStyle = '#ffffff';
  pen.font = '36px system-ui, sans-serif';
  pen.textAlign = 'center';
  const lines = text.split('\n');
  lines.forEach((line, i) => pen.fillText(line, NOTE.width / 2, NOTE.height / 2 + 52 * (i - (lines.length - 1) / 2) + 12, NOTE.width - 40));
  return canvas;
}

/** Feeds an Anchoring from one session of a headset, places the patient, and shows the notes. */
export class HeadsetAnchor {
  readonly anchoring: Anchoring;
  private shown = '';
  private anchored_ms: number | undefined;

  /** `stationNow`: the newest values of the station; undefined: it is silent. */
  constructor(
      private readonly session: XRSession, private readonly space: XRReferenceSpace, settings: AnchorSettings,
      private readonly scene: AnchoredScene, private readonly stationNow: () => Station | undefined,
  ) {
    this.anchoring = new Anchoring(settings);
    session.addEventListener('selectstart', () => this.anchoring.press());
    session.addEventListener('selectend', () => this.anchoring.release());
    session.addEventListener('squeeze', () => this.anchoring.again());
    space.addEventListener('reset', () => this.anchoring.again('The headset has moved its space: the anchor is lost.'));
  }

  /** One frame, before it is drawn. */
  frame(frame: XRFrame, now_ms: number): void {
    this.anchoring.frame(toolIn(frame, this.session, this.space), this.stationNow());
    const motion = this.anchoring.headsetFromScene;
    if (motion !== undefined) this.scene.place(matrixOf(motion));
    this.anchored_ms = this.anchoring.anchor === undefined ? undefined : this.anchored_ms ?? now_ms;
    this.tell(this.anchored_ms !== undefined && now_ms - this.anchored_ms > SHOWN_AFTER_MS ? '' : this.anchoring.note);
  }

  private tell(text: string): void {
    if (text === this.shown) return;
    this.shown = text;
    this.scene.showNote(text === '' ? undefined : noteOf(text));
  }
}
