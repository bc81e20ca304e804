import type {TouchHealth} from '../state/health';
import type {Banner} from './banner_look';

const MAY_TOUCH = ['', 'local', 'doctor'];  // local: on the machine of a server without keys

/** True if this page may touch, and a station uses its hand. */
export const movesAHand = ({holdsHand, role, untaken}: TouchHealth) => holdsHand && !untaken && MAY_TOUCH.includes(role);

/** What a user who wants to touch should do next; undefined when there is nothing to say. */
export function touchAdvice(health: TouchHealth): Banner | undefined {
  const {handShown, holdsHand, role, untaken} = health;
  if (holdsHand && !MAY_TOUCH.includes(role))
    return {level: 'warn', title: 'Only doctors may touch', text: 'Sign out at /sign-out, and sign in with a doctor’s token.'};
  if (holdsHand && untaken)
    return {
      level: 'warn',
      title: 'Touch reaches no station',
      text: 'Start the demo with deploy/demo --hand browser, or the station with --tracker browser.',
    };
  if (handShown !== false) return placementAdvice(health) ?? motionAdvice(health);
  return holdsHand
      ? {level: 'wait', title: 'Touch', text: 'Move the pointer over the skin; hold the left button, or a finger, down to push in.'}
      : {level: 'wait', title: 'No hand', text: 'Move the hand into the tracker’s view; if the station runs with --tracker browser, press Touch (T).'};
}

/** Says that the patient's motion does not fit the station's prediction; undefined while it fits. */
function motionAdvice({unmodelled}: TouchHealth): Banner | undefined {
  return unmodelled
      ? {level: 'wait', title: 'Unusual motion of the patient', text: 'The force follows the newest image, and may lag behind the patient.'}
      : undefined;
}

/** How well the place of the objects inside the body is known; undefined while it is. */
function placementAdvice({objectUnseen}: TouchHealth): Banner | undefined {
  return objectUnseen
      ? {level: 'warn', title: 'Inner object not seen', text: 'The skin above it is hidden. The object is shown where it last was.'}
      : undefined;
}
