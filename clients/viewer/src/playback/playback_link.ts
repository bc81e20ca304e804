import type {Answer} from '../link/ask_server';
import {afterCommand, type PlaybackCommand, type PlaybackState, readState} from './playback_state';
import {GONE, refusal} from './timeline_words';

export type Ask = (command?: PlaybackCommand) => Promise<Answer>;

/** What the page knows of the server when it looks again. */
export interface Site {
  connected: boolean;
  playsSession: boolean;
}

type Right = 'unknown' | 'moves' | 'none';

const MOST_WAITING = 4;  // a held key repeats faster than a slow link carries; further commands are dropped
const REST_LOOKS = 10;   // after no answer, each tenth look makes a request
const SEEK_LOOKS = 3;    // until a seek has been carried out, the server still reports the old position

/**
 * The session that the server plays, for a visitor who may move it. `look` is called on a steady beat and makes at most
 * one request. A server that plays no session is never asked. An empty command, once for each connection, finds out
 * whether this visitor may move the session.
 */
export class PlaybackLink {
  state: PlaybackState | undefined;  // undefined: there is nothing to move
  problem = '';                      // a sentence for the visitor; empty: all is well

  private right: Right = 'unknown';
  private rest = 0;
  private looking = false;
  private sending = false;
  private sent = 0;  // commands; a state that was read before the last one is old
  private readonly waiting: PlaybackCommand[] = [];

  constructor(private readonly ask: Ask) {}

  async look({connected, playsSession}: Site): Promise<void> {
    if (!connected) return this.lose();
    if (!playsSession) return this.forget();
    if (this.right === 'none' || this.looking || this.sending) return;
    if (this.rest > 0 && --this.rest > 0) return;
    this.looking = true;
    const before = this.sent;
    const answer = await this.ask(this.right === 'unknown' ? {} : undefined);
    this.looking = false;
    if (before === this.sent) this.take(answer);
  }

  /** Shows the effect at once and sends the commands one after the other. */
  async command(command: PlaybackCommand): Promise<void> {
    if (this.state === undefined || this.right !== 'moves' || this.waiting.length >= MOST_WAITING) return;
    this.state = afterCommand(this.state, command);
    ++this.sent;
    this.waiting.push(command);
    if (this.sending) return;
    this.sending = true;
    for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
      const answer = await this.ask(next);
      this.rest = next.seek_s === undefined ? 0 : SEEK_LOOKS;
      this.problem = answer === undefined ? GONE : answer.status === 200 ? '' : refusal(answer.status, answer.text);
    }
    this.sending = false;
  }

  private take(answer: Answer): void {
    if (answer === undefined || answer.status >= 500) {
      this.rest = REST_LOOKS;
      if (this.state !== undefined) this.problem = GONE;
      return;
    }
    const state = answer.status === 200 ? readState(answer.text) : undefined;
    if (this.problem === GONE) this.problem = '';
    if (state === undefined) return this.giveUp();
    this.state = state;
    this.right = 'moves';
  }

  /** Nothing is asked again on this connection. */
  private giveUp(): void {
    this.forget();
    this.right = 'none';
  }

  private forget(): void {
    this.state = undefined;
    this.problem = '';
    this.right = 'unknown';
    this.rest = 0;
  }

  /** Without a connection the last state stays, because a reconnect usually brings the same session back. */
  private lose(): void {
    this.right = 'unknown';
    this.rest = 0;
    if (this.state !== undefined) this.problem = GONE;
  }
}

