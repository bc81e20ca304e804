import {Phase} from '../messages/generated';

export interface PhaseLook {
  name: string;  // as in proto/words/phase_names.h
  tone: 'quiet' | 'free' | 'between' | 'contact' | 'inner' | 'alarm';
  says: string;
}

const LOOKS: Record<Phase, PhaseLook> = {
  [Phase.UNSPECIFIED]: {name: 'No station', tone: 'quiet', says: 'no message from a haptic station'},
  [Phase.IN_BODY]: {name: 'Pressing the skin', tone: 'contact', says: 'the hand feels the skin'},
  [Phase.BODY_TO_PLANE]: {name: 'Lifting off', tone: 'between', says: 'the device lifts the hand away from the body'},
  [Phase.OUT_BODY]: {name: 'Above the skin', tone: 'free', says: 'the device follows the hand above the body'},
  [Phase.PLANE_TO_BODY]: {name: 'Approaching the skin', tone: 'between', says: 'no force: push the device down to the skin'},
  [Phase.CYLINDER_LATERAL]: {name: 'Side of an inner object', tone: 'inner', says: 'the hand presses it from its side'},
  [Phase.AROUND_CYLINDER]: {name: 'Near an inner object', tone: 'inner', says: 'the hand is in the body, close to it'},
  [Phase.CYLINDER_UPPER]: {name: 'On an inner object', tone: 'inner', says: 'the hand presses its upper side'},
  [Phase.RELEASED]: {name: 'Force paused', tone: 'quiet', says: 'no force until tracker and images are fresh'},
  [Phase.FAULTED]: {name: 'Faulted', tone: 'alarm', says: 'no force until an operator re-arms the station'},
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

/** A change of phase in words. A session recorded by an older station has other words in its text. */
export const changeInWords = (from: Phase, to: Phase): string =>
    `${from === Phase.UNSPECIFIED ? 'Start' : lookOf(from).name} → ${lookOf(to).name}`;
