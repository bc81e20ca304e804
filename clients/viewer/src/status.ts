import {inWords} from './depth/depth_fidelity';
import {lookOf} from './words/phases';
import type {TimeAccount} from './present/time_account';
import type {Reading} from './state/viewer_state';
import type {VoiceButton} from './voice_button';

interface Facts extends Reading {
  meshVertices: number;
  handPosition: number[] | undefined;
  drawn_ms: number;
  coarseness: number;
  view: string;
  probeImages: number;
  innerTriangles: number;
  anchor: {touches: number; rms_m: number | undefined};
  voice: VoiceButton['counts'];
}

/** The status in `window.telepalp`, for tests and for debugging; read-only. */
export interface ViewerStatus {
  readonly connected: boolean;
  readonly frames: number;
  readonly fps: number;
  readonly dropped: number;
  readonly meshVertices: number;
  readonly force_N: number;  // of the contact; 0 while the device is driven
  readonly drive_N: number;  // of the drive; 0 in contact
  readonly indentation_m: number;
  readonly phase: string;
  readonly yields_s: number | undefined;
  readonly handPosition_m: readonly number[] | undefined;
  readonly depth: string | undefined;
  readonly pictureAge_ms: number | undefined;
  readonly linkAge_ms: number | undefined;
  readonly surfaceAge_ms: number | undefined;
  readonly clockError_ms: number | undefined;
  readonly pictureInstant_ms: number | undefined;
  readonly numbersInstant_ms: number | undefined;
  readonly handInstant_ms: number | undefined;
  readonly stale: boolean;
  readonly paused: boolean;
  readonly unsteady: Reading['unsteady'];
  readonly silenceLimit_ms: number | undefined;
  readonly imageGap_ms: number | undefined;
  readonly account: TimeAccount | undefined;
  readonly holdsHand: boolean;
  readonly undecodable: number;
  readonly decode_ms: number;
  readonly drawn_ms: number;
  readonly coarseness: number;
  readonly view: string;
  readonly role: string;
  readonly probeImages: number;     // of the ultrasound probe, shown since the page was opened
  readonly innerTriangles: number;  // of the layers below the skin
  readonly anchorTouches: number;
  readonly anchorRms_m: number | undefined;  // the headset is anchored to the device, and its touches miss by this; NaN: by one pose
  readonly voice: VoiceButton['counts'];     // of the conversation that the page has joined
}

/** Sets `window.telepalp` to a live, read-only status. Returns an object for values that other code sets. */
export function publishStatus(facts: () => Facts): {decode_ms: number} {
  const own = {decode_ms: 0};
  const snapshot = (): ViewerStatus => {
    const now = facts();
    return Object.freeze({
      connected: now.connected,
      frames: now.frames,
      fps: now.fps,
      dropped: now.dropped,
      meshVertices: now.meshVertices,
      force_N: now.force_N ?? 0,
      drive_N: now.drive_N ?? 0,
      indentation_m: (now.indentation_mm ?? 0) / 1000,
      phase: lookOf(now.phase).name,
      yields_s: now.yields_s,
      handPosition_m: now.handPosition,
      depth: now.depth && inWords(now.depth),
      pictureAge_ms: now.picture_ms,
      linkAge_ms: now.link_ms,
      surfaceAge_ms: now.surface_ms,
      clockError_ms: now.clockError_ms,
      pictureInstant_ms: now.pictureInstant_ms,
      numbersInstant_ms: now.numbersInstant_ms,
      handInstant_ms: now.handInstant_ms,
      stale: now.stale,
      paused: now.paused,
      unsteady: now.unsteady,
      silenceLimit_ms: now.silenceLimit_ms,
      imageGap_ms: now.imageGap_ms,
      account: now.account,
      holdsHand: now.holdsHand,
      undecodable: now.undecodable,
      decode_ms: own.decode_ms,
      drawn_ms: now.drawn_ms,
      coarseness: now.coarseness,
      view: now.view,
      role: now.role,
      probeImages: now.probeImages,
      innerTriangles: now.innerTriangles,
      anchorTouches: now.anchor.touches,
      anchorRms_m: now.anchor.rms_m,
      voice: now.voice,
    });
  };
  Object.defineProperty(window, 'telepalp', {get: snapshot, enumerable: true});
  return own;
}
