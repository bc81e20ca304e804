import type {Touch} from '../calibration/offset_fit';
import type {InnerStructures} from '../messages/generated';
import type {OwnTopics} from '../messages/topics';
import type {ColorCoding} from '../present/color_choice';
import type {Instant} from '../present/instant';
import type {ProbeView} from '../present/probe_view';
import {linkWorker} from './early_worker';
import type {Asked, Extra, FromWorker, News, ToWorker} from './worker_messages';

/** The page's interface to the link worker. Each request gets one answer, and it is not repeated before the answer. */
export class SiteLink {
  private readonly worker: Worker;
  private readonly owed = new Set<Asked>(['instant']);

  constructor(on: {
    instant: (instant: Instant) => void;
    news: (news: News) => void;
    probe: (probe: ProbeView) => void;
    inside: (inside: InnerStructures) => void;
    touches: (touches: Touch[]) => void;
  }) {
    const {worker, early} = linkWorker();
    this.worker = worker;
    const take = (data: FromWorker) => {
      if ('inside' in data) return on.inside(data.inside);
      if ('touches' in data) return on.touches(data.touches);
      this.owed.delete('news' in data ? 'news' : 'probe' in data ? 'probe' : 'instant');
      if ('news' in data) on.news(data.news);
      else if ('probe' in data) on.probe(data.probe);
      else on.instant(data.instant);
    };
    queueMicrotask(() => {  // once the page's script has created all that `on` uses
      worker.onmessage = ({data}: MessageEvent<FromWorker>) => take(data);
      early.splice(0).forEach(take);
    });
  }

  /** The answer comes later: for news at once, for an instant or a probe's pose as soon as there is a new one. */
  ask(what: Asked): void {
    if (this.owed.has(what)) return;
    this.owed.add(what);
    this.say({ask: what});
  }

  publishHand(hand: OwnTopics['/viewer/hand']): void {
    this.say({hand});
  }

  /** Asks for the touches of a place, for a calibration; undefined: of none. */
  takePlace(takePlace: number | undefined): void {
    this.say({takePlace});
  }

  /** How the camera's colour comes. */
  askForColor(color: ColorCoding): void {
    this.say({color});
  }

  /** What the present view needs besides the usual. */
  setExtra(extra: Extra): void {
    this.say({extra});
  }

  /** The canvas on which the worker draws the ultrasound images; the page can no longer draw on it. */
  drawUltrasoundOn(ultrasound: OffscreenCanvas): void {
    this.say({ultrasound}, [ultrasound]);
  }

  private say(message: ToWorker, transfer: Transferable[] = []): void {
    this.worker.postMessage(message, transfer);
  }
}
