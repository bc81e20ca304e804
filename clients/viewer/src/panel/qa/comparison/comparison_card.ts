import {askServer} from '../../../link/ask_server';
import {element, setText} from '../../../page/page';
import {type ComparisonCommand, type ComparisonState, readComparison} from '../../../playback/comparison_state';
import {PlayedPart} from '../../../playback/played_part';
import type {PlaybackLink} from '../../../playback/playback_link';
import {seekTo} from '../../../playback/playback_state';
import {clock} from '../../../playback/timeline_words';
import {ComparisonPlots} from './comparison_plots';
import {comparisonSays} from './comparison_words';

// Calls of `show`, which come about ten times a second, between two requests.
const UNKNOWN_EVERY = 50;
const READING_EVERY = 5;
const COMPARED_EVERY = 300;  // another visitor may choose another session

/** QA's comparison: the played session (A) and another one of the server's folder (B), on one time axis. */
export class ComparisonCard {
  private readonly part =
      new PlayedPart<ComparisonState, ComparisonCommand>(askServer('playback/comparison'), readComparison, (_, next) => next);
  private readonly choice = element<HTMLSelectElement>('comparison-with');
  private readonly first = element<HTMLButtonElement>('comparison-first');
  private readonly plots = new ComparisonPlots((at_s) => this.seek(at_s));
  private shows = 0;
  private listed = '';
  private session: string | undefined;  // the played session; undefined: none is played

  constructor(private readonly playback: PlaybackLink) {
    this.choice.addEventListener('change', () => void this.part.command({with: this.choice.value}).then(() => this.write()));
    this.first.addEventListener('click', () => {
      const first = this.part.state?.runs?.first;
      if (first !== undefined) this.seek(first.at_s);
    });
  }

  /** `moment_s`: to which the page's numbers belong. A complete comparison is asked for seldom: a reply has about 60 kB. */
  show(moment_s: number): void {
    const session = this.playback.state?.session;
    if (session !== this.session) {
      this.session = session;
      this.shows = 0;
      this.part.forget();
    }
    const {state} = this.part;
    element('comparison-card').hidden = session === undefined || state === undefined;
    element('comparison').hidden = session === undefined || state?.runs === undefined;
    if (session === undefined) return;
    const every = state === undefined || state.with === '' ? UNKNOWN_EVERY : state.complete ? COMPARED_EVERY : READING_EVERY;
    if (this.shows++ % every === 0) void this.part.look().then(() => this.write());
    if (state?.runs !== undefined) this.plots.show(state.runs, moment_s);
  }

  private seek(at_s: number): void {
    const {state} = this.playback;
    if (state !== undefined) void this.playback.command({...seekTo(state, at_s), play: false});
  }

  private write(): void {
    const {state, problem} = this.part;
    if (state === undefined) return;
    const names = state.sessions.join('\n');
    if (names !== this.listed) this.choice.replaceChildren(new Option('none', ''), ...state.sessions.map((name) => new Option(name, name)));
    this.listed = names;
    this.choice.value = state.with;
    setText(element('comparison-said'), problem === '' ? comparisonSays(state) : problem);
    const first = state.runs?.first;
    this.first.hidden = first === undefined;
    if (first !== undefined) setText(this.first, `First difference: ${clock(first.at_s)}`);
  }
}
