import {askServer} from '../link/ask_server';
import {GONE, refusal} from '../link/refusal';
import {sessionInAddress} from '../link/own_session';
import {element, made, setText} from '../page/page';
import {addressOfSession, bring, type Recorded, recordedSays} from '../playback/recorded_sessions';

/** The recordings on the server's machine. A press opens one for this page alone. */
export class SessionsCard {
  private readonly ask = askServer('/sessions');
  private readonly card = element('sessions-card');
  private readonly list = element('sessions');
  private brings = false;  // a file is on its way

  constructor() {
    const file = element<HTMLInputElement>('session-file');
    element('bring-session').addEventListener('click', () => file.click());
    file.addEventListener('change', () => void this.bring(file.files?.[0]));
    window.addEventListener('dragover', (event) => event.preventDefault());  // else the browser would leave the page
    window.addEventListener('drop', (event) => {
      event.preventDefault();
      if (!this.card.hidden) void this.bring(event.dataTransfer?.files[0]);
    });
  }

  /** undefined: the server has no folder of recordings, or it is not for this visitor. */
  know(sessions: readonly Recorded[] | undefined): void {
    this.card.hidden = sessions === undefined;
    this.list.replaceChildren(...(sessions ?? []).map((session) => this.line(session)));
  }

  /** Sends the file to the server, and opens it there for this page alone. */
  private async bring(file: File | undefined): Promise<void> {
    if (file === undefined || this.brings) return;
    this.brings = true;
    const say = (text: string) => setText(element('sessions-said'), text);
    say(`${file.name} is sent to the server: 0 %`);
    const refused = await bring(
        file,
        async (part) => {
          const answer = await this.ask(part);
          return answer === undefined ? GONE : answer.status === 200 ? '' : refusal(answer.status, answer.text);
        },
        (share) => say(`${file.name} is sent to the server: ${Math.floor(100 * share)} %`));
    this.brings = false;
    if (refused === '') location.assign(addressOfSession(file.name));
    else say(refused);
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
