import type {Rotation, Vec3} from '../link/messages';

/** telepalp.msg.UltrasoundImage; see proto/messages/inside.proto. Directions and places are in the depth camera's frame. */
export interface UltrasoundImage {
  stampNs: bigint;
  onSkin: boolean;
  faceCamera?: Vec3;
  intoBodyCamera?: Vec3;
  acrossCamera?: Vec3;
  widthM: number;
  depthM: number;
  jpeg: Uint8Array;
}

export interface InnerStructure {
  name: string;
  effect: number;     // place of the effect in the scene's list
  least?: Vec3;
  stepM: number;
  points: Uint8Array;     // 16-bit numbers, little-endian
  triangles: Uint8Array;  // 16-bit numbers, little-endian
}

/** telepalp.msg.InnerStructures, in the haptic base's frame H. */
export interface InnerStructures {
  structures: InnerStructure[];
  hapticOriginCamera?: Vec3;
  cameraFromHaptic?: Rotation;
  sender: number;
}

/** telepalp.msg.ObjectPlacement: how far the object of an effect has moved, in H. */
export interface ObjectPlacement {
  effect: number;
  moved?: Vec3;
  unseen: boolean;       // the skin above it is hidden
  slideUnseen: boolean;  // the skin above it is too smooth to show whether it slides
}

/** The image that the link worker drew last, without its pixels: from the link worker to the page. */
export interface ProbeView {
  stampNs: bigint;
  widthM: number;
  depthM: number;
  onSkin: boolean;  // false: the probe has no image, and the panel is black
  drawn: number;    // images drawn since the page was opened
  face: Vec3 | undefined;
  intoBody: Vec3 | undefined;
  across: Vec3 | undefined;
}
