import type {Resource} from '../../link/resource';
import type {SourceState as SourceMessage} from '../../messages/generated';
import {element, setText} from '../../page/page';

/** The body of POST /source. */
export type SourceCommand = {source: string} | {look_for_cameras: true};

/** The source that the server shows to all, and those that a technician may choose. */
export interface SourceState {
  sources: readonly {name: string; title: string}[];
  present: string;
  opening: string;  // empty: none
  read_share: number;
  problem: string;
}
export type Source = Resource<SourceMessage, SourceState, SourceCommand>;

export const readSource = ({sources, present, opening, readShare, problem}: SourceMessage): SourceState =>
    ({sources, present, opening, read_share: readShare, problem});

/** What the card says of the present source, or of the one that is on its way. */
export function sourceSays({present, opening, read_share, problem}: SourceState): string {
  if (opening !== '') return `${opening} is being opened${read_share > 0 ? `: ${Math.floor(100 * read_share)} %` : '…'}`;
  return problem === '' ? `All see ${present}.` : `All still see ${present}. ${problem}`;
}

/** The technician's choice of the source that the server shows to all. */
export class SourceCard {
  private readonly choice = element<HTMLSelectElement>('source-choice');
  private readonly button = element<HTMLButtonElement>('source-show');
  private listed = '';

  constructor(private readonly source: Source) {
    source.onChange(() => this.write());
    this.choice.addEventListener('change', () => this.write());
    this.button.addEventListener('click', () => void source.command({source: this.choice.value}));
    element('source-look').addEventListener('click', () => void source.command({look_for_cameras: true}));
  }

  private write(): void {
    const {state, problem} = this.source;
    element('source-card').hidden = state === undefined;
    if (state === undefined) return;
    const listed = JSON.stringify(state.sources);
    if (listed !== this.listed) {
      const chosen = this.choice.value === '' ? state.present : this.choice.value;
      this.choice.replaceChildren(...state.sources.map(({name, title}) => new Option(`${name}: ${title}`, name)));
      this.choice.value = state.sources.some(({name}) => name === chosen) ? chosen : state.present;
    }
    this.listed = listed;
    this.button.disabled = state.opening !== '' || this.choice.value === state.present;
    setText(element('source-said'), problem === '' ? sourceSays(state) : problem);
  }
}
