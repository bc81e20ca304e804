import {
  AmbientLight,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  MOUSE,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Spherical,
  StereoCamera,
  TOUCH,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

import type {DepthSummary} from '../depth/depth_summary';
import type {Vec3} from '../messages/generated';
import {DrawnAside} from './drawn_aside';
import {type Detail, FramePacer} from './frame_pacer';
import {drawsInSoftware, plainContext} from './graphics';
import {fromCamera, toCamera} from './frames';
import {Halo} from './halo';
import {Hand} from './hand';
import {Headset} from './headset';
import {InnerStructuresView} from './inner_structures';
import {Pointed} from './pointed';
import {Probe} from './probe';
import {ProbePlane} from './probe_plane';
import {Surface} from './surface';
import {Transducer} from './transducer';

/** Levels of detail, finest first, with a graphics card, and without one. */
const DETAILS: readonly Detail[] = [
  {stride: 1, pixelRatio: 2},
  {stride: 1, pixelRatio: 1},
  {stride: 1, pixelRatio: 0.7},
  {stride: 1, pixelRatio: 0.5},
  {stride: 2, pixelRatio: 0.5},
];
const SOFTWARE_DETAILS: readonly Detail[] = [
  {stride: 3, pixelRatio: 1},
  {stride: 4, pixelRatio: 0.7},
  {stride: 4, pixelRatio: 0.5},
  {stride: 6, pixelRatio: 0.5},
  {stride: 8, pixelRatio: 0.4},
];
const SOFTWARE_LEVEL = 2;  // the first level without a graphics card: an index into SOFTWARE_DETAILS
const EYE_DISTANCE_M = 0.063;  // the mean of adults

/** The size of the picture [CSS pixels], and its own pixels per CSS pixel. */
interface Sight {
  width: number;
  height: number;
  ratio: number;
}

/** The 3D view: its objects, its camera, and its drawing, which happens only after a change. */
export class SceneView {
  readonly surface: Surface;
  readonly hand: Hand;
  readonly transducer = new Transducer();
  readonly inner = new InnerStructuresView();
  readonly probePlane = new ProbePlane();
  readonly probe = new Probe();
  readonly halo = new Halo();
  readonly pointed = new Pointed();

  /**
   * Callbacks of each drawing: when it begins, when it is put into the canvas, which the browser shows together with all
   * that the page writes in this turn, when the graphics card has finished it, and when the next one may begin.
   */
  onDraw: () => void = () => undefined;
  onShown: () => void = () => undefined;
  onDrawn: () => void = () => undefined;
  onFree: () => void = () => undefined;
  /** The headset shows the scene, or shows it no more. */
  onHeadset: (on: boolean) => void = () => undefined;
  /** The browser has lost the graphics context, or has got it back. */
  onGraphics: (lost: boolean) => void = () => undefined;

  /** Data about the surface in the last frame that the graphics card has finished. */
  drawnVertices = 0;

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly world = new Group();  // what the patient's site shows, in the scene's frame
  private readonly camera = new PerspectiveCamera(42, 1, 0.01, 20);
  private readonly controls: OrbitControls;
  private readonly caster = new Raycaster();
  private stereo: StereoCamera | undefined;  // undefined: one picture
  private readonly home = {target: new Vector3(0, 0, -1), distance_m: 0.9};
  private placed = false;
  private sight: Sight = {width: 1, height: 1, ratio: 1};
  private size = '';  // of the canvas now
  private box = {width: 0, height: 0};  // of the canvas [CSS pixels], by a ResizeObserver: clientWidth forces a layout
  private drawingVertices = 0;
  private readonly details: readonly Detail[];
  private readonly aside: DrawnAside | undefined;  // undefined: a graphics card draws into the canvas
  private readonly pacer: FramePacer;
  readonly headset: Headset;

  /** Throws when the browser has no WebGL 2. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    const software = drawsInSoftware();
    document.documentElement.dataset['graphics'] = software ? 'software' : 'card';
    this.surface = new Surface(software);
    this.hand = new Hand(software);
    this.details = software ? SOFTWARE_DETAILS : DETAILS;
    this.renderer = new WebGLRenderer(software ? {canvas, context: plainContext(canvas)} : {canvas, antialias: true, powerPreference: 'high-performance'});
    this.aside = software ? new DrawnAside(this.renderer) : undefined;
    this.pacer = new FramePacer(
        this.renderer.getContext() as WebGL2RenderingContext, this.details.length, () => this.draw(),
        this.aside && (() => this.show()),
        () => {
          this.drawnVertices = this.drawingVertices;
          this.onDrawn();
        },
        () => this.onFree());
    this.headset = new Headset(this.renderer, this.scene, this.world, () => this.drawForHeadset(), () => this.leaveHeadset());
    this.pacer.level = software ? SOFTWARE_LEVEL : 0;
    const lamp = new DirectionalLight('#fff4e6', 2.1);
    lamp.position.set(-0.45, 0.65, 0.85);
    this.scene.add(this.world);
    this.world.add(
        this.surface.mesh, this.hand.mesh, this.transducer.group, this.inner.group, this.probePlane.mesh, this.probe.group,
        this.halo.group, this.pointed.group, new HemisphereLight('#cfe3ff', '#3a2a22', 1.1),
        new AmbientLight('#ffffff', 0.25), lamp);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.12;
    this.controls.maxDistance = 4;
    this.controls.maxPolarAngle = 0.93 * Math.PI;
    this.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(([entry]) => {
      this.box = entry?.contentRect ?? this.box;
      this.invalidate();
    }).observe(canvas);
    for (const [event, lost] of [['webglcontextlost', true], ['webglcontextrestored', false]] as const)
      canvas.addEventListener(event, () => {
        this.onGraphics(lost);
        this.invalidate();
      });
    this.resetView();
    this.renderer.compile(this.scene, this.camera);  // the graphics process does it while the page goes on
  }

  /** Shows the scene in a headset, or no more. Throws when the headset or the user refuses. */
  async setHeadset(wanted: boolean): Promise<void> {
    if (wanted) await this.headset.begin(this.home.target);
    else await this.headset.end();
  }

  private drawForHeadset(): void {
    this.onDraw();
    this.drawingVertices = this.surface.meshVertices;
    this.renderer.render(this.scene, this.camera);
    this.drawnVertices = this.drawingVertices;
    this.onShown();
    this.onDrawn();
    this.onFree();
  }

  private leaveHeadset(): void {
    this.size = '';  // the headset's pictures had another size
    this.onHeadset(false);
    this.invalidate();
  }

  /** Shows the hand, or the probe that it holds. */
  setHandShown(wanted: boolean): void {
    this.hand.setShown(wanted);
    this.transducer.setShown(wanted);
  }

  setBackground(color: string): void {
    this.scene.background = new Color(color);
    this.invalidate();
  }

  /** Side by side for a 3D screen: the left half for the left eye. */
  setStereo(wanted: boolean): void {
    this.stereo = wanted ? new StereoCamera() : undefined;
    if (this.stereo !== undefined) this.stereo.eyeSep = EYE_DISTANCE_M;
    this.invalidate();
  }

  /**
   * The picture at its own size, a pixel for each pixel of the screen, in the finest detail of this computer. Valid until
   * the end of this turn of the page: a browser keeps the drawn pixels no longer.
   */
  pictureNow(): HTMLCanvasElement {
    this.surface.setStride(this.details[0]!.stride);
    this.fitCanvas({...this.sight, ratio: window.devicePixelRatio});
    this.render();
    this.invalidate();  // the next drawing has the usual detail again
    return this.canvas;
  }

  /** Requests a drawing with the next screen refresh. */
  invalidate(): void {
    this.pacer.ask();
  }

  /** Duration of the last drawing on the graphics card, and the level of detail that it led to (0: finest). */
  get drawn_ms(): number {
    return this.pacer.drawn_ms;
  }
  get coarseness(): number {
    return this.pacer.level;
  }
  get detail(): Detail {
    return this.details[this.pacer.level] as Detail;
  }

  /**
   * The home position of the view: in front of the surface at the picture's middle. The first frame moves the view
   * there.
   */
  setHome({near_m, middle_m}: DepthSummary): void {
    if (middle_m <= 0) return;
    this.home.target.set(0, 0, -0.5 * (near_m + middle_m));
    this.home.distance_m = Math.min(2.2, Math.max(0.45, 0.88 * middle_m));
    if (!this.placed) this.resetView();
    this.placed = true;
  }

  /** True if the first button and one finger turn the view; false if they are used for something else. */
  setTurning(wanted: boolean): void {
    this.controls.mouseButtons.LEFT = wanted ? MOUSE.ROTATE : null;
    this.controls.touches.ONE = wanted ? TOUCH.ROTATE : null;
  }

  /** The point of the measured surface under a position on the page. */
  surfaceUnder(clientX: number, clientY: number): Vector3 | undefined {
    const {left, top, width, height} = this.canvas.getBoundingClientRect();
    const place = new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    this.caster.setFromCamera(place, this.camera);
    return this.surface.meet(this.caster.ray.origin, this.caster.ray.direction);
  }

  /** The pixel of the depth image under a position on the page, with its depth along the camera's axis. */
  pixelUnder(clientX: number, clientY: number): {column: number; row: number; depth_m: number} | undefined {
    const at = this.surfaceUnder(clientX, clientY);
    return at && {...this.surface.pixelOf(at), depth_m: -at.z};
  }

  /** The same place in the camera's frame. */
  placeUnder(clientX: number, clientY: number): Vec3 | undefined {
    const at = this.surfaceUnder(clientX, clientY);
    return at && toCamera(at);
  }

  /** Arrows at these places in the camera's frame. */
  showPointed(places: readonly Vec3[]): void {
    this.pointed.show(places.map(fromCamera));
    this.invalidate();
  }

  resetView(): void {
    this.controls.target.copy(this.home.target);
    const away = new Vector3().setFromSpherical(new Spherical(this.home.distance_m, Math.PI / 2 + 0.52, 0.22));
    this.camera.position.copy(this.home.target).add(away);
    this.controls.update();
    this.invalidate();
  }

  /** Orbits the view around its target [rad], and moves it nearer (`zoom` < 1) or away. */
  orbit(azimuth: number, polar: number, zoom = 1): void {
    const away = this.camera.position.clone().sub(this.controls.target);
    const place = new Spherical().setFromVector3(away);
    place.theta += azimuth;
    place.phi = Math.min(0.93 * Math.PI, Math.max(0.07, place.phi + polar));
    place.radius = Math.min(this.controls.maxDistance, Math.max(this.controls.minDistance, place.radius * zoom));
    this.camera.position.copy(this.controls.target).add(away.setFromSpherical(place));
    this.controls.update();
    this.invalidate();
  }

  private draw(): boolean {
    if (this.headset.isOn) return false;  // the headset asks for its own frames
    this.onDraw();
    const {detail} = this;
    this.surface.setStride(detail.stride);
    this.sight = this.sizeAt(detail) ?? this.sight;
    this.fitCamera(this.sight);
    if (this.controls.update()) this.invalidate();
    this.drawingVertices = this.surface.meshVertices;
    if (this.aside === undefined || this.stereo !== undefined) {
      this.fitCanvas(this.sight);
      this.render();
      this.onShown();
    } else {
      this.aside.begin(Math.floor(this.sight.width * this.sight.ratio), Math.floor(this.sight.height * this.sight.ratio));
      this.render();
      this.aside.end();
    }
    return this.drawingVertices > 0;
  }

  /** Shows the picture that was drawn aside. */
  private show(): void {
    if (this.headset.isOn || this.stereo !== undefined) return;
    this.fitCanvas(this.sight);
    this.aside?.copyToCanvas();
    this.onShown();
  }

  private render(): void {
    const {renderer, scene, camera, stereo} = this;
    if (stereo === undefined) return renderer.render(scene, camera);
    const size = renderer.getSize(new Vector2());
    camera.updateMatrixWorld();
    stereo.aspect = 0.5;  // each eye has half the width
    stereo.update(camera);
    renderer.setScissorTest(true);
    for (const [eye, left] of [[stereo.cameraL, 0], [stereo.cameraR, size.width / 2]] as const) {
      renderer.setScissor(left, 0, size.width / 2, size.height);
      renderer.setViewport(left, 0, size.width / 2, size.height);
      renderer.render(scene, eye);
    }
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, size.width, size.height);
  }

  /** The size of the picture at this level of detail; undefined: the canvas has none yet. */
  private sizeAt({pixelRatio}: Detail): Sight | undefined {
    const {width, height} = this.box;
    if (width === 0 || height === 0) return undefined;
    return {width, height, ratio: Math.min(window.devicePixelRatio, pixelRatio)};
  }

  private fitCamera({width, height}: Sight): void {
    const aspect = width / height;
    if (aspect === this.camera.aspect) return;
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }

  /** Sets the size of the canvas. Called just before drawing or copying into it, because it clears the picture. */
  private fitCanvas({width, height, ratio}: Sight): void {
    const size = `${width} x ${height} at ${ratio}`;
    if (size === this.size) return;
    this.size = size;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }
}
