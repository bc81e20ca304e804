import type {SessionEvents_Speech} from '../messages/generated';
import {made} from '../page/page';
import {clock} from './timeline_words';

const QUIETEST_DB = -50;  // of speech

/** A bar in a lane. Lengths are shares of the lane's width and height. */
export interface LaneBar {
  from: number;
  width: number;
  height: number;  // the louder, the higher
  title: string;
}

/** The lane of one side: the doctor's, or the one at the patient's side. */
export interface Lane {
  name: string;
  color: string;
  says: string;  // for a screen reader
  bars: LaneBar[];
}

const SIDES = [
  {doctor: false, name: 'Patient', who: 'the patient\u2019s side speaks', color: 'var(--good)'},
  {doctor: true, name: 'Doctor', who: 'the doctor speaks', color: 'var(--accent)'},
];

/** The lanes of the sides that speak at all. */
export function lanesOf(speech: readonly SessionEvents_Speech[], duration_s: number): Lane[] {
  return SIDES.flatMap(({doctor, name, who, color}) => {
    const own = duration_s > 0 ? speech.filter((one) => one.doctor === doctor && one.fromS < duration_s) : [];
    const spoken_s = own.reduce((sum, {fromS, untilS}) => sum + untilS - fromS, 0);
    const bars = own.map(({fromS, untilS, loudestDB}) => ({
      from: fromS / duration_s,
      width: Math.min(untilS - fromS, duration_s - fromS) / duration_s,
      height: Math.min(1, Math.max(0.3, 1 - loudestDB / QUIETEST_DB)),
      title: `${clock(fromS)} to ${clock(untilS)}: ${who}`,
    }));
    return bars.length === 0 ? [] : [{name, color, says: `${who} for ${clock(spoken_s)} of ${clock(duration_s)}`, bars}];
  });
}

const percent = (share: number) => `${100 * share}%`;

function drawn({name, color, says, bars}: Lane): HTMLElement {
  const lane = made('span');
  lane.setAttribute('role', 'img');
  lane.setAttribute('aria-label', says);
  lane.dataset['lane'] = name;
  lane.style.cssText = 'position: relative; display: block; height: 12px; margin-top: 2px; border-radius: 3px; overflow: hidden; background: var(--grid); cursor: pointer';
  lane.append(...bars.map(({from, width, height, title}) => {
    const bar = made('i');
    bar.title = title;
    bar.style.cssText = `position: absolute; bottom: 0; min-width: 1px; background: ${color}`;
    Object.assign(bar.style, {left: percent(from), width: percent(width), height: percent(height)});
    return bar;
  }));
  const label = made('b', '', name);
  label.style.cssText = 'position: absolute; left: 4px; font: 600 10px/12px system-ui, sans-serif; color: var(--ink); text-shadow: 0 0 3px var(--page), 0 0 3px var(--page); pointer-events: none';
  lane.append(label);
  return lane;
}

let box: HTMLElement | undefined;

/** Draws the lanes below `band`, which seeks where it is clicked, and so do they. Without speech, they are taken away. */
export function drawLanes(band: HTMLElement, speech: readonly SessionEvents_Speech[], duration_s: number): void {
  if (box === undefined) {
    box = made('span');
    box.id = 'voice-lanes';
    box.style.cssText = 'display: block; margin: 0 7px';
    box.addEventListener('click', ({clientX}) => band.dispatchEvent(new MouseEvent('click', {clientX})));
    band.after(box);
  }
  box.replaceChildren(...lanesOf(speech, duration_s).map(drawn));
}
