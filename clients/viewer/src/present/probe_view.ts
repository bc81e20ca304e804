import type {Vec3} from '../messages/generated';

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
