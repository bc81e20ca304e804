import {CanvasTexture, type Group, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, type Scene, SRGBColorSpace, Vector3, type WebGLRenderer} from 'three';

/** Where the middle of the patient lies for a person who stands or sits before a bed: y up from the floor [m]. */
const PATIENT_AT = new Vector3(0, 0.95, -0.55);

/** The part of the browser's WebXR that is used here. */
interface XrSystem {
  isSessionSupported(mode: 'immersive-vr'): Promise<boolean>;
  requestSession(mode: 'immersive-vr', options: {optionalFeatures: string[]}): Promise<XRSession>;
}
const xrOf = () => (navigator as Navigator & {xr?: XrSystem}).xr;

/** True if a headset can show the scene. */
export async function headsetIsThere(): Promise<boolean> {
  try {
    return (await xrOf()?.isSessionSupported('immersive-vr')) ?? false;
  } catch {
    return false;  // a permissions policy forbids it
  }
}

/**
 * Shows the scene in a headset (S2): the patient lies before the viewer at the height of a bed, in true size. The depth
 * camera's axis points down, so that the patient's front is up.
 */
export class Headset {
  /** Gets the place of the user's hand or controller in the scene's frame [m] at each frame; undefined: untracked. */
  onHand: (at: Vector3 | undefined) => void = () => undefined;
  /** Called at each frame before it is drawn; mixed/ anchors the patient to the haptic device in it. */
  onFrame: ((frame: XRFrame) => void) | undefined;
  private session: XRSession | undefined;
  private note: Mesh<PlaneGeometry, MeshBasicMaterial> | undefined;

  /** `world`: all that the patient's site shows. `draw`: draws one frame. `onEnd`: the headset shows nothing more. */
  constructor(
      private readonly renderer: WebGLRenderer,
      private readonly scene: Scene,
      private readonly world: Group,
      private readonly draw: () => void,
      private readonly onEnd: () => void,
  ) {}

  get isOn(): boolean {
    return this.session !== undefined;
  }

  /** The session and its reference space; undefined: no session. */
  get present(): {session: XRSession; space: XRReferenceSpace} | undefined {
    const space = this.renderer.xr.getReferenceSpace();
    return this.session && space ? {session: this.session, space} : undefined;
  }

  /** Places the patient. `matrix`: headset_from_scene, 4 x 4, column by column. */
  place(matrix: readonly number[]): void {
    new Matrix4().fromArray(matrix).decompose(this.world.position, this.world.quaternion, this.world.scale);
  }

  /** Shows a picture, four times as wide as high, in front of a person who stands or sits; undefined: removes it. */
  showNote(picture: HTMLCanvasElement | undefined): void {
    this.note?.removeFromParent();
    this.note?.geometry.dispose();
    this.note?.material.map?.dispose();
    this.note?.material.dispose();
    this.note = undefined;
    if (picture === undefined) return;
    const map = new CanvasTexture(picture);
    map.colorSpace = SRGBColorSpace;
    this.note = new Mesh(new PlaneGeometry(0.8, 0.2), new MeshBasicMaterial({map}));
    this.note.position.set(0, 1.45, -0.9);
    this.scene.add(this.note);
  }

  /** `middle`: the patient's middle in the scene. Throws when the headset or the user refuses. */
  async begin(middle: Vector3): Promise<void> {
    const session = await xrOf()!.requestSession('immersive-vr', {optionalFeatures: ['local-floor', 'hand-tracking']});
    this.session = session;
    session.addEventListener('end', () => this.ended());
    this.renderer.xr.enabled = true;
    this.renderer.xr.setReferenceSpaceType('local-floor');
    await this.renderer.xr.setSession(session);
    this.world.rotation.set(-Math.PI / 2, 0, 0);
    this.world.position.copy(PATIENT_AT).sub(middle.clone().applyEuler(this.world.rotation));
    this.renderer.setAnimationLoop((_time, frame?: XRFrame) => {
      if (frame === undefined) return;  // three.js also calls this for the window, without an XRFrame
      this.onFrame?.(frame);
      this.onHand(this.handIn(frame, session));
      this.draw();
    });
  }

  /** The tip of the index finger, or the grip of a controller; of the right hand if it is tracked. */
  private handIn(frame: XRFrame, session: XRSession): Vector3 | undefined {
    const space = this.renderer.xr.getReferenceSpace();
    if (space === null) return undefined;
    const places = Array.from(session.inputSources, (source) => {
      const tip = source.hand?.get('index-finger-tip');
      const pose = tip !== undefined ? frame.getJointPose?.(tip, space) : source.gripSpace && frame.getPose(source.gripSpace, space);
      return {right: source.handedness === 'right', at: pose?.transform.position};
    }).filter(({at}) => at !== undefined);
    const at = (places.find(({right}) => right) ?? places[0])?.at;
    this.world.updateMatrixWorld();
    return at && this.world.worldToLocal(new Vector3(at.x, at.y, at.z));
  }

  async end(): Promise<void> {
    await this.session?.end();
  }

  private ended(): void {
    this.session = undefined;
    this.onFrame = undefined;
    this.showNote(undefined);
    this.onHand(undefined);
    this.renderer.setAnimationLoop(null);
    this.renderer.xr.enabled = false;
    this.world.rotation.set(0, 0, 0);
    this.world.position.set(0, 0, 0);
    this.onEnd();
  }
}
