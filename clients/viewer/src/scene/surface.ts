import {
  BufferGeometry,
  BufferAttribute,
  Color,
  DataTexture,
  GLSL3,
  LinearFilter,
  Mesh,
  NearestFilter,
  NoColorSpace,
  RedIntegerFormat,
  ShaderMaterial,
  SRGBColorSpace,
  Texture,
  UnsignedShortType,
  Vector2,
  Vector3,
  Vector4,
} from 'three';

import type {DepthFrame} from '../depth/decode_depth';
import type {DepthSummary} from '../depth/depth_summary';
import {CoarseSurface} from './coarse_surface';
import {SURFACE_FRAGMENT, SURFACE_VERTEX} from './surface_shaders';

interface DepthSpan {
  near_m: number;
  far_m: number;
}

/** Two triangles for each square of `stride` pixels, wound to face the camera. */
function gridTriangles(width: number, height: number, stride: number): Uint32Array {
  const [columns, rows] = [Math.floor((width - 1) / stride), Math.floor((height - 1) / stride)];
  const corners = new Uint32Array(6 * columns * rows);
  let next = 0;
  for (let row = 0; row < rows; ++row)
    for (let column = 0; column < columns; ++column) {
      const at = stride * (row * width + column);
      const below = at + stride * width;
      for (const corner of [at, below, at + stride, at + stride, below, below + stride]) corners[next++] = corner;
    }
  return corners;
}

/** S1 II.E: the remote scene as a 3D mesh in the camera's colours. No triangle spans a depth break. */
export class Surface {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;

  private measured = 0;
  private stride = 1;
  private frame: DepthFrame | undefined;
  private depth: DataTexture | undefined;
  private readonly color = new Texture();
  private picture: ImageBitmap | undefined;
  private showColor = true;
  private picked: DepthSpan = {near_m: 0.5, far_m: 1.5};  // of the picture
  private wanted: DepthSpan | undefined;                  // by the user

  private readonly uniforms = {
    depthSamples: {value: null as DataTexture | null},
    size: {value: new Vector2(2, 2)},
    stride: {value: 1},
    unit_m: {value: 0.001},
    intrinsics: {value: new Vector4(1, 1, 0, 0)},
    colorPicture: {value: this.color},
    colored: {value: 0},
    plain: {value: true},
    range_m: {value: new Vector2(0.5, 1.5)},
    touchedAt: {value: new Vector3()},
    touched: {value: 0},
    touchColor: {value: new Color()},
    touchScreenColor: {value: new Color()},  // touchColor, encoded for the screen (sRGB)
    eye: {value: new Vector3()},
    opacity: {value: 1},
  };

  private readonly coarse: CoarseSurface | undefined;  // undefined: a graphics card draws every pixel

  /** Approximate number of vertices on the measured surface in the displayed frame; 0 before the first. */
  get meshVertices(): number {
    return Math.round(this.measured / this.stride ** 2);
  }

  /** `software`: the browser has no graphics card, so the surface is drawn with little work per pixel. */
  constructor(software: boolean) {
    this.color.colorSpace = software ? NoColorSpace : SRGBColorSpace;
    this.color.flipY = false;
    this.color.generateMipmaps = false;
    this.color.minFilter = this.color.magFilter = software ? NearestFilter : LinearFilter;
    this.coarse = software ? new CoarseSurface(this.uniforms) : undefined;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: SURFACE_VERTEX,
      fragmentShader: SURFACE_FRAGMENT,
      uniforms: this.uniforms,
    });
    this.mesh = new Mesh(this.coarse?.geometry ?? new BufferGeometry(), this.coarse?.material ?? material);
    this.mesh.frustumCulled = false;  // only the graphics card knows the positions of the vertices
    this.mesh.visible = false;
    this.mesh.onBeforeRender = (_renderer, _scene, camera) =>
        this.mesh.worldToLocal(this.uniforms.eye.value.setFromMatrixPosition(camera.matrixWorld));
  }

  /** `k`: the camera matrix, row-major; without one, that of a Kinect is assumed for the frame's size. */
  showDepth(frame: DepthFrame, summary: DepthSummary, k: readonly number[] | undefined): void {
    const {width, height} = frame;
    this.frame = frame;
    const size = this.uniforms.size.value;
    if (this.coarse !== undefined) size.set(width, height);
    else if (this.depth === undefined || size.x !== width || size.y !== height) this.resize(frame);
    else this.depth.image.data = frame.samples;
    if (this.depth !== undefined) this.depth.needsUpdate = true;
    const [fx, , cx, , fy, cy] = k ?? [];
    const usual = width * 0.9;
    this.uniforms.intrinsics.value.set(fx || usual, fy || usual, cx ?? width / 2, cy ?? height / 2);
    this.uniforms.unit_m.value = frame.unit_m;
    this.picked = {near_m: summary.near_m, far_m: summary.far_m};
    this.applyRange();
    this.measured = summary.measured;
    this.applyColor();
    this.layCoarse();
    this.mesh.visible = true;
  }

  /**
   * The first intersection of the ray with the measured surface; undefined: none within 4 m. `direction` has length 1.
   */
  meet(origin: Vector3, direction: Vector3): Vector3 | undefined {
    const [step_m, far_m, thick_m] = [0.004, 4, 0.05];  // at this distance behind it, the ray passes behind the rim
    const at = new Vector3();
    for (let way_m = 0; way_m < far_m; way_m += step_m) {
      const measured_m = this.depthBehind(at.copy(direction).multiplyScalar(way_m).add(origin));
      if (measured_m > 0 && -at.z >= measured_m && -at.z < measured_m + thick_m)
        return at.multiplyScalar(measured_m / -at.z);
    }
    return undefined;
  }

  /** The measured depth at the pixel in which the camera sees the point `at`; 0 if it is not measured. */
  depthBehind({x, y, z}: Vector3): number {
    if (this.frame === undefined || z > -0.05) return 0;
    const {width, height, samples, unit_m} = this.frame;
    const {column, row} = this.pixelOf({x, y, z});
    if (column < 0 || row < 0 || column >= width || row >= height) return 0;
    return (samples[row * width + column] ?? 0) * unit_m;
  }

  /** The pixel of the depth image in which the camera sees the point `at` of the scene. */
  pixelOf({x, y, z}: Pick<Vector3, 'x' | 'y' | 'z'>): {column: number; row: number} {
    const {x: fx, y: fy, z: cx, w: cy} = this.uniforms.intrinsics.value;
    return {column: Math.round(cx - (fx * x) / z), row: Math.round(cy + (fy * y) / z)};
  }

  showPicture(picture: ImageBitmap): void {
    this.picture?.close();
    this.picture = picture;
    this.color.image = picture;
    this.color.needsUpdate = true;
    this.applyColor();
  }

  /** False: the surface is coloured by depth, as it is without a colour picture. */
  setColored(wanted: boolean): void {
    this.showColor = wanted;
    this.applyColor();
  }

  /** 1: the skin hides everything below it; less: what lies below shows through. */
  setOpacity(opacity: number): void {
    this.uniforms.opacity.value = opacity;
    this.mesh.material.transparent = opacity < 1;
    this.mesh.renderOrder = opacity < 1 ? -1 : 0;  // before everything else that is translucent
  }

  /** Draws no surface any more; everything else goes on. */
  hide(): void {
    this.mesh.layers.disableAll();
  }

  /** The depths between which colours differ; undefined: those of the picture. */
  setRange(range: DepthSpan | undefined): void {
    this.wanted = range;
    this.applyRange();
  }

  private applyRange(): void {
    const {near_m, far_m} = this.wanted ?? this.picked;
    this.uniforms.range_m.value.set(near_m, far_m);
  }

  /** Marks the touched point of the surface. `strength` 0 … 1. */
  setTouch(at: Vector3 | undefined, strength: number, color: Color): void {
    if (at !== undefined) this.uniforms.touchedAt.value.copy(at);
    this.uniforms.touched.value = at === undefined ? 0 : strength;
    this.uniforms.touchColor.value.copy(color);
    this.uniforms.touchScreenColor.value.copy(color).convertLinearToSRGB();
  }

  private applyColor(): void {
    this.uniforms.colored.value = this.showColor && this.picture !== undefined ? 1 : 0;
    this.uniforms.plain.value = this.showColor;
    this.coarse?.setColored(this.uniforms.colored.value === 1);
  }

  private layCoarse(): void {
    if (this.frame === undefined) return;
    const {x: fx, y: fy, z: cx, w: cy} = this.uniforms.intrinsics.value;
    this.coarse?.show(this.frame, {fx, fy, cx, cy}, this.stride);
  }

  private resize({width, height, samples}: DepthFrame): void {
    this.depth?.dispose();
    this.depth = new DataTexture(samples, width, height, RedIntegerFormat, UnsignedShortType);
    this.depth.internalFormat = 'R16UI';
    this.depth.minFilter = this.depth.magFilter = NearestFilter;
    this.depth.unpackAlignment = 2;
    this.uniforms.depthSamples.value = this.depth;
    this.uniforms.size.value.set(width, height);
    this.layGrid();
  }

  /** Draws only every `stride`-th pixel of the depth image. */
  setStride(stride: number): void {
    if (stride === this.stride) return;
    this.stride = stride;
    this.uniforms.stride.value = stride;
    this.layCoarse();
    if (this.depth !== undefined) this.layGrid();
  }

  private layGrid(): void {
    const {x: width, y: height} = this.uniforms.size.value;
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setIndex(new BufferAttribute(gridTriangles(width, height, this.stride), 1));
  }
}
