import type {Answer} from '../link/ask_server';
import {GONE, refusal} from './timeline_words';

export type AskPart<Command> = (command?: Command) => Promise<Answer>;

/**
 * A part of the played session that the server keeps, such as its notes. `look` reads it; `command` changes it. While a
 * command is on its way, later ones are joined to one that follows it, so that a dragged slider sends no queue.
 */
export class PlayedPart<State, Command extends object> {
  state: State | undefined;  // undefined: not known yet
  problem = '';              // a sentence for the visitor; empty: all is well

  private waiting: Command | undefined;
  private busy = false;
  private changes = 0;  // a state that was read before the last command is old

  constructor(
      private readonly ask: AskPart<Command>, private readonly read: (text: string) => State | undefined,
      private readonly join: (waiting: Command, next: Command) => Command) {}

  async look(): Promise<void> {
    if (this.busy) return;
    const before = this.changes;
    const answer = await this.ask();
    if (answer !== undefined && this.problem === GONE) this.problem = '';
    if (before === this.changes && answer?.status === 200) this.state = this.read(answer.text) ?? this.state;
  }

  /** Resolves when the server has answered this command and those joined to it. True: it did what was asked. */
  async command(command: Command): Promise<boolean> {
    ++this.changes;
    this.waiting = this.waiting === undefined ? command : this.join(this.waiting, command);
    if (this.busy) return false;
    this.busy = true;
    for (let next = this.take(); next !== undefined; next = this.take()) {
      const answer = await this.ask(next);
      this.problem = answer === undefined ? GONE : answer.status === 200 ? '' : refusal(answer.status, answer.text);
      if (answer?.status === 200) this.state = this.read(answer.text) ?? this.state;
    }
    this.busy = false;
    return this.problem === '';
  }

  forget(): void {
    this.state = undefined;
    this.problem = '';
  }

  private take(): Command | undefined {
    const next = this.waiting;
    this.waiting = undefined;
    return next;
  }
}
