import type {Instant} from '../present/instant';
import type {HandOver, LetGo, ViewerHand} from './messages';
import type {Extra, FromWorker, News, ToWorker} from './worker_messages';

/** The page's interface to the link worker. Each request gets one answer, and it is not repeated before the answer. */
export class SiteLink {
  private readonly worker = new Worker('link_worker.js', {type: 'module'});
  private readonly owed = new Set<'instant' | 'news'>();

  constructor(onInstant: (instant: Instant) => void, onNews: (news: News) => void) {
    this.worker.onmessage = ({data}: MessageEvent<FromWorker>) => {
      const answered = 'news' in data ? 'news' : 'instant';
      this.owed.delete(answered);
      if ('news' in data) onNews(data.news);
      else onInstant(data.instant);
    };
  }

  /** The answer comes later: for news at once, for an instant as soon as a new one can be presented. */
  ask(what: 'instant' | 'news'): void {
    if (this.owed.has(what)) return;
    this.owed.add(what);
    this.say({ask: what});
  }

  publishHand(hand: ViewerHand | LetGo | HandOver): void {
    this.say({hand});
  }

  /** What the present view needs besides the usual. */
  setExtra(extra: Extra): void {
    this.say({extra});
  }

  private say(message: ToWorker): void {
    this.worker.postMessage(message);
  }
}
