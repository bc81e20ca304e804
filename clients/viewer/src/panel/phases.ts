import {Phase} from '../link/messages';

export interface PhaseLook {
  name: string;  // S1 Fig. 4's
  tone: 'quiet' | 'free' | 'between' | 'contact' | 'inner' | 'alarm';
  says: string;
}

const LOOKS: Record<Phase, PhaseLook> = {
  [Phase.Unspecified]: {name: 'No station', tone: 'quiet', says: 'no message from a haptic station'},
  [Phase.InBody]: {name: 'In body', tone: 'contact', says: 'the hand presses the skin: force control'},
  [Phase.BodyToPlane]: {name: 'Body to plane', tone: 'between', says: 'the device lifts the hand away from the body'},
  [Phase.OutBody]: {name: 'Out body', tone: 'free', says: 'the device follows the hand above the body'},
  [Phase.PlaneToBody]: {name: 'Plane to body', tone: 'between', says: 'no force: push the device down to the skin'},
  [Phase.ObjectLateral]: {name: 'Cylinder lateral', tone: 'inner', says: 'the hand presses the inner object’s side'},
  [Phase.AroundObject]: {name: 'Around cylinder', tone: 'inner', says: 'the hand is near the inner object'},
  [Phase.ObjectUpper]: {name: 'Cylinder upper', tone: 'inner', says: 'the hand is on top of the inner object'},
  [Phase.Released]: {name: 'Released', tone: 'quiet', says: 'no force until tracker and images are fresh'},
  [Phase.Faulted]: {name: 'Faulted', tone: 'alarm', says: 'no force until an operator re-arms the station'},
};

const NOT_KNOWN: PhaseLook = {name: '–', tone: 'quiet', says: 'the station’s values for this picture have not arrived'};

/**
 * Name and colour of a phase; an unknown number from a newer station is shown as a number. `phase` undefined: that of this
 * instant is not known.
 */
export function lookOf(phase: Phase | undefined): PhaseLook {
  if (phase === undefined) return NOT_KNOWN;
  return LOOKS[phase] ?? {name: `State ${Number(phase)}`, tone: 'quiet', says: 'the station is newer than this page: update the server'};
}
