import type {Banner} from './banner_look';
import type {PhaseLook} from '../words/phases';

const SETTLED_MS = 1000;  // what is shorter is not spoken
const REST_MS = 3000;     // the least time between two words, except of an alarm
const AGAIN_MS = 30_000;  // a warning that comes and goes is spoken again after this time

/** What one part of the page shows: a new `key` is a new meaning, '' none. */
interface Meaning {
  key: string;
  words: string;
  urgent: boolean;
  again_ms: number;
}

/** Of a phase, a listener tells apart: on the way to the skin and from it, the hand is free. */
const meaningOf = ({tone, name, says}: PhaseLook): Meaning => ({
  key: tone === 'between' ? 'free' : tone === 'quiet' ? name : tone, words: `${name}: ${says}`, urgent: tone === 'alarm', again_ms: 0,
});

/** What one part of the page shows, since when, and what was spoken of it last. */
class Part {
  private key = '';
  private since_ms = 0;
  spoken = '';

  /** True if `meaning` has lasted, and is another one than that spoken last. */
  isNews({key, urgent}: Meaning, now_ms: number): boolean {
    if (key !== this.key) this.since_ms = now_ms;
    this.key = key;
    if (key === '') this.spoken = '';
    return key !== this.spoken && (urgent || now_ms - this.since_ms >= SETTLED_MS);
  }
}

/**
 * What a screen reader says of phase and banner: a meaning that has lasted and was not spoken last; an alarm at once. A
 * hand that palpates changes the phase several times a second, and the text of a banner contains a running time.
 */
export class Voice {
  private readonly phase = new Part();
  private readonly banner = new Part();
  private readonly spokenAt = new Map<string, number>();
  private spoke_ms = -Infinity;

  /** The words to speak now; undefined: none. */
  ofPhase(look: PhaseLook, now_ms: number): string | undefined {
    return this.say(this.phase, meaningOf(look), now_ms);
  }

  ofBanner(banner: Banner | undefined, now_ms: number): string | undefined {
    const {title = '', text = '', level = 'wait'} = banner ?? {};
    return this.say(this.banner, {key: title, words: `${title}. ${text}`, urgent: level === 'alarm', again_ms: AGAIN_MS}, now_ms);
  }

  private say(part: Part, meaning: Meaning, now_ms: number): string | undefined {
    const {key, words, urgent, again_ms} = meaning;
    if (!part.isNews(meaning, now_ms)) return undefined;
    const rested = now_ms - this.spoke_ms >= REST_MS && now_ms - (this.spokenAt.get(key) ?? -Infinity) >= again_ms;
    if (!rested && !urgent) return undefined;
    part.spoken = key;
    this.spoke_ms = now_ms;
    this.spokenAt.set(key, now_ms);
    return words;
  }
}
