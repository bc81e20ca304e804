import type {Answer} from '../link/ask_server';
import {GONE, refusal} from './timeline_words';

export type AskPart<Command> = (command?: Command) => Promise<Answer>;

interface Waiting<Command> {
  command: Command;
  answered: Promise<boolean>;
  settle(done: boolean): void;
}

/**
 * A part of the played session that the server keeps, such as its notes. `look` reads it; `command` changes it. One
 * command is on its way at a time. `join` makes one command of two that wait, so that a dragged slider sends no queue;
 * undefined: both are sent.
 */
export class PlayedPart<State, Command extends object> {
  state: State | undefined;  // undefined: not known yet
  problem = '';              // a sentence for the visitor; empty: all is well

  private readonly waiting: Waiting<Command>[] = [];
  private busy = false;
  private changes = 0;  // a state that was read before the last command is old

  constructor(
      private readonly ask: AskPart<Command>, private readonly read: (text: string) => State | undefined,
      private readonly join: (waiting: Command, next: Command) => Command | undefined) {}

  async look(): Promise<void> {
    if (this.busy) return;
    const before = this.changes;
    const answer = await this.ask();
    if (answer !== undefined && this.problem === GONE) this.problem = '';
    if (before === this.changes && answer?.status === 200) this.state = this.read(answer.text) ?? this.state;
  }

  /** Resolves when the server has answered this command, or the one that it was joined to. True: it did what was asked. */
  command(command: Command): Promise<boolean> {
    ++this.changes;
    const last = this.waiting[this.waiting.length - 1];
    const joined = last && this.join(last.command, command);
    if (last !== undefined && joined !== undefined) {
      last.command = joined;
      return last.answered;
    }
    let settle = (_done: boolean) => {};
    const answered = new Promise<boolean>((resolve) => {
      settle = resolve;
    });
    this.waiting.push({command, answered, settle});
    if (!this.busy) void this.send();
    return answered;
  }

  forget(): void {
    this.state = undefined;
    this.problem = '';
  }

  private async send(): Promise<void> {
    this.busy = true;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      const answer = await this.ask(next.command);
      this.problem = answer === undefined ? GONE : answer.status === 200 ? '' : refusal(answer.status, answer.text);
      if (answer?.status === 200) this.state = this.read(answer.text) ?? this.state;
      next.settle(this.problem === '');
    }
    this.busy = false;
  }
}
