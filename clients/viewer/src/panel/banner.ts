import {CaptureState, Phase} from '../messages/generated';
import {type Place, slowest, type TimeAccount, total_ms} from '../present/time_account';
import type {Health, Unsteady} from '../state/health';
import type {Banner} from './banner_look';
import {megabits} from './megabits';
import {movesAHand, touchAdvice} from './touch_advice';

const RECENT_MS = 1000;
const NOTHING_MS = 250;  // the station's state comes each 10 ms
const LATE_MS = 400;
const WARM_S = 4;

const seconds = (ms: number) => `${(ms / 1000).toFixed(1)} s`;

/** The most important message for the user, or undefined if everything works. The worst problem comes first. */
export function bannerFor(health: Health): Banner | undefined {
  if (!health.connected) {
    const wait = health.retryIn_ms === undefined ? 'Connecting…' : `Trying again in ${seconds(health.retryIn_ms)}.`;
    return health.everConnected
        ? {level: 'alarm', title: 'Disconnected', text: `${wait} The picture is the last one received.`}
        : {level: 'wait', title: 'Connecting to the patient’s site', text: wait};
  }
  if (health.opening !== undefined)
    return {level: 'wait', title: 'Opening the session', text: `The server reads the file’s index: ${Math.floor(100 * health.opening)} %.`};
  if (health.unopened !== undefined)
    return {level: 'alarm', title: 'The session is not opened', text: `${health.unopened}. To see what the server publishes, open its address without a moment.`};
  if (health.phase === Phase.FAULTED && isRecent(health.station_ms))
    return {level: 'alarm', title: 'Station faulted', ...afterFault(health)};
  if (health.graphicsLost)
    return {
      level: 'alarm',
      title: 'No picture',
      text: 'This computer’s graphics stopped. The picture restarts by itself; if not, reload the page. The readings continue.',
    };
  if (health.capture?.state === CaptureState.LOST)
    return {level: 'alarm', title: 'Camera lost', text: health.capture.detail || 'The server keeps trying to open the camera.'};
  if (health.picture_ms === undefined && health.capture?.source.startsWith('session:'))
    return {level: 'wait', title: 'No picture', text: 'The played session has given no depth image yet. A session of telepalp-replay contains none.'};
  if (health.picture_ms === undefined)
    return {level: 'wait', title: 'Waiting for the camera', text: health.capture?.detail || 'No depth image yet.'};
  if (health.capture?.state === CaptureState.ENDED)
    return {level: 'wait', title: 'The played recording has ended', text: 'The last picture stays.'};
  if (health.paused) return {level: 'wait', title: 'Paused', text: 'The played session is stopped at this moment.'};
  if (health.silence_ms !== undefined) return {level: 'warn', title: 'Stale picture', text: silenceSays(health)};
  if (health.unsteady !== undefined && isRecent(health.station_ms)) return unsteadyBanner(health.unsteady, health.holdsHand);
  if (health.yields_s !== undefined && health.yields_s < WARM_S && isRecent(health.station_ms))
    return {
      level: 'warn',
      title: 'The device is warm',
      text: `In ${health.yields_s.toFixed(1)} s the device gives less force, and the hand sinks in deeper. Press less, or let go.`,
    };
  if (health.stale)
    return {
      level: 'warn',
      title: 'Stale picture',
      text: whereTo(health.account === undefined ? health.picture_ms : total_ms(health.account), health.account),
    };
  if (health.objectOverPlace && isRecent(health.station_ms))
    return {
      level: 'warn',
      title: 'Something lies over the place',
      ...underObject(health),
    };
  if (health.handOutsideWindow && isRecent(health.station_ms))
    return {
      level: 'warn',
      title: 'No exact depth at the hand',
      text: 'The hand has left the part of the image that is exact, so it feels no force until exact images of its new place come. Move more slowly.',
    };
  if (health.surfaceStale)
    return {
      level: 'warn',
      title: 'No surface to feel',
      text: health.surface_ms === undefined ? '' : `The device is beyond the measured surface, or the surface is too old: ${seconds(health.surface_ms)}.`,
    };
  if (health.station_ms !== undefined && health.station_ms > RECENT_MS)
    return {level: 'warn', title: 'Station silent', text: `The station has sent no message for ${seconds(health.station_ms)}.`};
  if (health.late_ms !== undefined && health.late_ms > LATE_MS)
    return {
      level: 'warn',
      title: 'Late readings',
      text: `Hand and force come ${seconds(health.late_ms)} after the picture, and are not shown in it.`,
    };
  return touchAdvice(health) ?? lineIsShared(health);
}

function lineIsShared({lineLeft_B_per_s}: Health): Banner | undefined {
  if (lineLeft_B_per_s === undefined) return undefined;
  return {
    level: 'wait',
    title: 'Something else uses this line',
    text: `About ${megabits(lineLeft_B_per_s)} are left for the station. If images become coarse or late, end downloads and videos on this line.`,
  };
}

/** A browser re-arms only the station whose hand it moves: beside any other device, an operator must look first. */
function afterFault(health: Health): Pick<Banner, 'text' | 'rearms'> {
  if (movesAHand(health)) return {text: 'No force. Take the hand off the patient, then re-arm.', rearms: true};
  return {text: 'No force. Remove the cause that the station’s terminal names, then run on its machine: telepalp-station rearm. ' +
      'If a browser’s hand moves this station: press Touch (T), then Re-arm.'};
}

/** A browser accepts an object only for the station whose hand it moves: beside any other device, nobody sees the hand. */
function underObject(health: Health): Pick<Banner, 'text' | 'acceptsObject'> {
  const now = 'You feel the skin as it was remembered, for 1 s; then its force fades. To feel what lies there:';
  if (movesAHand(health)) return {text: `${now} lift the hand above it, and choose “This is skin now”.`, acceptsObject: true};
  return {text: `${now} lift 3 cm clear of it, and press again.`};
}

const BLAME: Record<Place, (part: string) => string> = {
  site: (part) => `Patient’s site: no newer image was sent for ${part}. The connection works.`,
  network: (part) => `Network: images need ${part} from the server to this computer.`,
  computer: (part) => `This computer: it needs ${part} to decode and draw. Close other programs, or make the window smaller.`,
};

function unsteadyBanner(unsteady: Unsteady, holdsHand: boolean): Banner {
  const then = holdsHand ? 'Your press is let go: release the button before you press again.' : 'Take the hand off the device.';
  if (unsteady === 'full drive')
    return {level: 'warn', title: 'Drive at its limit', text: `The drive pushes the free device with its largest force. ${then}`};
  const {swing_mm, hertz} = unsteady;
  return {
    level: 'warn',
    title: 'The device swings',
    text: `It swings by ${swing_mm.toFixed(0)} mm, ${hertz.toFixed(0)} times a second, and the hand rests. ${then}`,
  };
}

/** The text while no image comes. It changes once a second, because a screen reader reads out each change. */
function silenceSays({silence_ms, heardAny_ms, station_ms}: Health): string {
  const since = (ms: number) => (ms < 1000 ? '' : ` for ${Math.floor(ms / 1000)} s`);
  if (heardAny_ms !== undefined && heardAny_ms > NOTHING_MS)
    return `Nothing has come from the server${since(heardAny_ms)}. The picture is the last one received.`;
  const numbers = station_ms !== undefined && station_ms < NOTHING_MS ? ' The numbers go on.' : '';
  return `No image has come${since(silence_ms ?? 0)}. The connection works.${numbers}`;
}

/** Names the place that causes most of the picture's age. */
function whereTo(age_ms: number, account: TimeAccount | undefined): string {
  if (account === undefined) return `The picture is ${seconds(age_ms)} old.`;
  const place = slowest(account);
  return `The picture is ${seconds(age_ms)} old. ${BLAME[place](seconds(account[place]))}`;
}

function isRecent(age_ms: number | undefined): boolean {
  return age_ms !== undefined && age_ms <= RECENT_MS;
}
