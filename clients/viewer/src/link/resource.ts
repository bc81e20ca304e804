import type {Published} from '../messages/topics';
import type {Answer} from './ask_server';
import {GONE, refusal} from './refusal';

export type Ask<Command> = (command: Command) => Promise<Answer>;

/** How the page reads and shows the resource. */
export interface Traits<Message, State, Command> {
  /** undefined: the message is not the state after the last command yet. */
  read(message: Message): State | undefined;
  /**
   * Joins two waiting commands into one, so that a dragged slider sends no queue. Without this function, or if it returns
   * undefined, both are sent.
   */
  join?(waiting: Command, next: Command): Command | undefined;
  /** The state that a command will lead to, to show it at once. */
  after?(state: State, command: Command): State;
  /** Commands that may wait; further ones are dropped, because a held key repeats faster than a slow link carries. */
  mostWaiting?: number;
}

interface Waiting<Command> {
  command: Command;
  answered: Promise<boolean>;
  settle(done: boolean): void;
}

/**
 * A resource of the server. The stream brings its states; commands go one after the other. A state that was published
 * before the last command was carried out is not shown.
 */
export class Resource<Message, State, Command extends object> {
  state: State | undefined;  // undefined: the server does not have this resource, or its state has not come yet
  problem = '';              // a sentence for the visitor; empty: all is well

  private readonly listeners: (() => void)[] = [];
  private readonly waiting: Waiting<Command>[] = [];
  private busy = false;
  private newest: Published<Message> | undefined;
  private answered_ns = 0n;  // when the state after the last command was published

  constructor(private readonly ask: Ask<Command>, private readonly traits: Traits<Message, State, Command>) {}

  /** `call` is called when state or problem has changed. */
  onChange(call: () => void): void {
    this.listeners.push(call);
  }

  /** undefined: the server does not have this resource. */
  take(newest: Published<Message> | undefined): void {
    this.newest = newest;
    if (newest === undefined) {
      this.state = undefined;
      this.problem = '';
      this.answered_ns = 0n;
      this.changed();
    } else {
      this.show();
    }
  }

  /** Without a connection the last state stays, because a reconnect usually brings the same one back. */
  connected(is: boolean): void {
    const problem = is ? (this.problem === GONE ? '' : this.problem) : this.state === undefined ? '' : GONE;
    if (problem === this.problem) return;
    this.problem = problem;
    this.changed();
  }

  /** Resolves when the server has answered this command, or the one that it was joined to. True: it did what was asked. */
  command(command: Command): Promise<boolean> {
    if (this.waiting.length >= (this.traits.mostWaiting ?? Infinity)) return Promise.resolve(false);
    if (this.traits.after !== undefined && this.state !== undefined) {
      this.state = this.traits.after(this.state, command);
      this.changed();
    }
    const last = this.waiting[this.waiting.length - 1];
    const joined = last && this.traits.join?.(last.command, command);
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

  private async send(): Promise<void> {
    this.busy = true;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      const answer = await this.ask(next.command);
      this.problem = answer === undefined ? GONE : answer.status === 200 ? '' : refusal(answer.status, answer.text);
      if (answer?.status === 200) this.answered_ns = answer.published_ns;
      next.settle(this.problem === '');
    }
    this.busy = false;
    if (this.isBehind) return;  // a control that showed the state from before the command would jump back
    this.show();
    this.changed();
  }

  /** The state after the last command is on its way. */
  private get isBehind(): boolean {
    return this.newest !== undefined && this.newest.published_ns < this.answered_ns;
  }

  private show(): void {
    const {newest} = this;
    if (newest === undefined || this.busy || this.isBehind) return;
    const state = this.traits.read(newest.message);
    if (state === undefined) return;
    this.state = state;
    this.changed();
  }

  private changed(): void {
    for (const call of this.listeners) call();
  }
}
