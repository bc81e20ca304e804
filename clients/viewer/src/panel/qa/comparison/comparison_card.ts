import type {Resource} from '../../../link/resource';
import type {ComparisonState as ComparisonMessage} from '../../../messages/generated';
import {element, setText} from '../../../page/page';
import type {ComparisonCommand, ComparisonState} from '../../../playback/comparison_state';
import {type Playback, seekTo} from '../../../playback/playback_state';
import {clock} from '../../../playback/timeline_words';
import {ComparisonPlots} from './comparison_plots';
import {comparisonSays} from './comparison_words';

export type Comparison = Resource<ComparisonMessage, ComparisonState, ComparisonCommand>;

/** QA's comparison: the played session (A) and another one of the server's folder (B), on one time axis. */
export class ComparisonCard {
  private readonly choice = element<HTMLSelectElement>('comparison-with');
  private readonly first = element<HTMLButtonElement>('comparison-first');
  private readonly plots = new ComparisonPlots((at_s) => this.seek(at_s));
  private listed = '';

  constructor(private readonly playback: Playback, private readonly comparison: Comparison) {
    comparison.onChange(() => this.write());
    this.choice.addEventListener('change', () => void comparison.command({with: this.choice.value}));
    this.first.addEventListener('click', () => {
      const first = comparison.state?.runs?.first;
      if (first !== undefined) this.seek(first.at_s);
    });
  }

  /** `moment_s`: to which the page's numbers belong. */
  show(moment_s: number): void {
    const {state} = this.comparison;
    const plays = this.playback.state !== undefined;
    element('comparison-card').hidden = !plays || state === undefined;
    element('comparison').hidden = !plays || state?.runs === undefined;
    if (plays && state?.runs !== undefined) this.plots.show(state.runs, moment_s);
  }

  private seek(at_s: number): void {
    const {state} = this.playback;
    if (state !== undefined) void this.playback.command({...seekTo(state, at_s), play: false});
  }

  private write(): void {
    const {state, problem} = this.comparison;
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
