import {askServer} from '../link/ask_server';
import {sessionInAddress} from '../link/own_session';
import {element, made} from '../page/page';
import {addressOfSession, type Recorded, readSessions, recordedSays} from '../playback/recorded_sessions';

const LOOK_EVERY = 50;  // calls of `show`, which come about ten times a second

/** The recordings on the server's machine. A press opens one for this page alone. */
export class SessionsCard {
  private readonly ask = askServer('sessions');
  private readonly card = element('sessions-card');
  private readonly list = element('sessions');
  private shows = 0;
  private shown = '';

  /** `role`: of this visitor at the server. A guest may open no recording, and is not asked for. */
  show({connected, role}: {connected: boolean; role: string}): void {
    if (!connected || role === '' || role === 'viewer') {
      this.shows = 0;
      return;
    }
    if (this.shows++ % LOOK_EVERY === 0) void this.look();
  }

  private async look(): Promise<void> {
    const answer = await this.ask();
    if (answer?.status !== 200) return;
    const sessions = readSessions(answer.text);
    const shown = JSON.stringify(sessions);
    this.card.hidden = sessions.length === 0;
    if (shown === this.shown) return;
    this.shown = shown;
    this.list.replaceChildren(...sessions.map((session) => this.line(session)));
  }

  private line(session: Recorded): HTMLElement {
    const line = made('li');
    const link = made('a', 'event', session.name);
    link.setAttribute('href', addressOfSession(session.name));
    link.title = 'Open it for this page alone';
    if (session.name === sessionInAddress(location.search)) line.setAttribute('aria-current', 'true');
    link.append(made('small', '', recordedSays(session)));
    line.append(link);
    return line;
  }
}
