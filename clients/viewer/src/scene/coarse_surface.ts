import {BufferAttribute, BufferGeometry, DynamicDrawUsage, GLSL3, type IUniform, ShaderMaterial} from 'three';

import type {DepthFrame} from '../depth/decode_depth';
import {type CoarseMesh, coarseMeshFor, type Intrinsics, layCoarseMesh} from './coarse_mesh';
import {COARSE_FRAGMENT, COARSE_VERTEX} from './coarse_shaders';

/** Geometry and material of the surface for a browser without a graphics card. */
export class CoarseSurface {
  readonly geometry = new BufferGeometry();
  readonly material: ShaderMaterial;
  private mesh: CoarseMesh | undefined;
  private size = '';

  /** `uniforms`: those of the Surface, shared. */
  constructor(uniforms: Record<string, IUniform>) {
    this.material = new ShaderMaterial(
        {glslVersion: GLSL3, vertexShader: COARSE_VERTEX, fragmentShader: COARSE_FRAGMENT, uniforms, defines: {COLORED: ''}});
  }

  show(frame: DepthFrame, intrinsics: Intrinsics, stride: number): void {
    const mesh = this.meshFor(frame, stride);
    layCoarseMesh(mesh, frame, intrinsics);
    for (const name of ['position', 'lamp']) this.geometry.getAttribute(name).needsUpdate = true;
    this.geometry.getIndex()!.needsUpdate = true;
    this.geometry.setDrawRange(0, mesh.used);
  }

  /** True: the camera's colours; false: colours by depth, and no texture look-up for each pixel. */
  setColored(colored: boolean): void {
    const defines = this.material.defines!;
    if ('COLORED' in defines === colored) return;
    if (colored) defines['COLORED'] = '';
    else delete defines['COLORED'];
    this.material.needsUpdate = true;
  }

  private meshFor({width, height}: DepthFrame, stride: number): CoarseMesh {
    const size = `${width} x ${height} / ${stride}`;
    if (this.mesh !== undefined && this.size === size) return this.mesh;
    this.size = size;
    const mesh = (this.mesh = coarseMeshFor(width, height, stride));
    this.geometry.dispose();
    const changing = (values: Float32Array | Uint16Array, items: number) => {
      const attribute = new BufferAttribute(values, items);
      attribute.setUsage(DynamicDrawUsage);
      return attribute;
    };
    this.geometry.setAttribute('position', changing(mesh.positions, 3));
    this.geometry.setAttribute('lamp', changing(mesh.lamp, 1));
    this.geometry.setAttribute('pixel', new BufferAttribute(mesh.pixels, 2));
    this.geometry.setIndex(changing(mesh.corners, 1));
    return mesh;
  }
}
