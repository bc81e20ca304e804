import {BufferAttribute, BufferGeometry, Group, Mesh, MeshPhongMaterial} from 'three';

import type {InnerStructure, InnerStructures, ObjectPlacement} from '../messages/generated';
import {fromCamera, rotationFromCamera} from './frames';

/** Colours that colour-blind people can tell apart (Okabe and Ito 2008), as in `telepalp-station scene show`. */
const COLORS = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#cc79a7', '#0072b2', '#d55e00'];
const MOST_POINTS = 65535;

function numbers(bytes: Uint8Array): Uint16Array {
  return new Uint16Array(bytes.slice().buffer, 0, bytes.byteLength >> 1);
}

/** Points [m] and triangles of a structure; undefined when the message is not a mesh. */
export function meshOf({points, triangles, least, stepM}: InnerStructure):
    {positions: Float32Array; corners: Uint16Array} | undefined {
  const [steps, corners] = [numbers(points), numbers(triangles)];
  const count = steps.length / 3;
  if (least === undefined || !(stepM > 0) || steps.length % 3 !== 0 || corners.length % 3 !== 0) return undefined;
  if (count > MOST_POINTS || corners.some((corner) => corner >= count)) return undefined;
  const origin = [least.x, least.y, least.z] as const;
  return {positions: Float32Array.from(steps, (step, i) => (origin[i % 3] ?? 0) + stepM * step), corners};
}

/** The layers of the scene below the skin, at their places in the body. */
export class InnerStructuresView {
  readonly group = new Group();
  private readonly meshes = new Map<number, Mesh<BufferGeometry, MeshPhongMaterial>>();  // by effect

  constructor() {
    this.group.visible = false;
  }

  show({structures, hapticOriginCamera, cameraFromHaptic}: InnerStructures): void {
    for (const mesh of this.meshes.values()) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.meshes.clear();
    const turned = cameraFromHaptic && rotationFromCamera(cameraFromHaptic);
    if (hapticOriginCamera === undefined || turned === undefined) return;
    this.group.position.copy(fromCamera(hapticOriginCamera));
    this.group.quaternion.copy(turned);
    structures.forEach((structure, i) => this.add(structure, COLORS[i % COLORS.length] ?? '#ffffff'));
  }

  /** Puts each layer where the station displays it. */
  move(objects: readonly ObjectPlacement[]): void {
    for (const {effect, moved} of objects)
      if (moved !== undefined) this.meshes.get(effect)?.position.set(moved.x, moved.y, moved.z);
  }

  setShown(wanted: boolean): void {
    this.group.visible = wanted;
  }

  /** Number of triangles that are drawn while the layers are shown. */
  get triangles(): number {
    let sum = 0;
    for (const {geometry} of this.meshes.values()) sum += (geometry.getIndex()?.count ?? 0) / 3;
    return sum;
  }

  private add(structure: InnerStructure, color: string): void {
    const made = meshOf(structure);
    if (made === undefined) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(made.positions, 3));
    geometry.setIndex(new BufferAttribute(made.corners, 1));
    geometry.computeVertexNormals();
    const mesh = new Mesh(geometry, new MeshPhongMaterial({color, specular: '#222222', shininess: 20}));
    this.meshes.set(structure.effect, mesh);
    this.group.add(mesh);
  }
}
