import {measureHeight} from '../page/layout';
import {ownQuery} from '../link/own_session';
import {element, setText} from '../page/page';
import {type Focus, commandForKey} from './playback_keys';
import {type Playback, type PlaybackCommand, seekTo} from './playback_state';
import {clock, timelineLook} from './timeline_words';

/** The bar that moves a played session. It is hidden unless the server plays one that this visitor may move. */
export class TimelineBar {
  private readonly bar = element('timeline');
  private readonly play = element<HTMLButtonElement>('timeline-play');
  private readonly step = element<HTMLButtonElement>('timeline-step');
  private readonly slider = element<HTMLInputElement>('timeline-slider');
  private readonly time = element('timeline-time');
  private readonly speed = element<HTMLSelectElement>('timeline-speed');
  private readonly loop = element<HTMLButtonElement>('timeline-loop');
  private readonly problem = element('timeline-problem');
  private dragged = false;

  constructor(private readonly link: Playback) {
    this.play.addEventListener('click', () => this.send({play: this.link.state?.playing === false}));
    this.step.addEventListener('click', () => this.send({step: 1}));
    this.loop.addEventListener('click', () => this.send({loop: this.link.state?.loop === false}));
    this.speed.addEventListener('change', () => this.send({speed: Number(this.speed.value)}));
    this.slider.addEventListener('input', () => this.drag());
    this.slider.addEventListener('change', () => this.drop());
    // A slider that is brought back to where it was tells of no change. One that changed does so before the timeout.
    for (const ended of ['pointerup', 'pointercancel'] as const)
      window.addEventListener(ended, () => window.setTimeout(() => (this.dragged = false)));
    window.addEventListener('keydown', (event) => this.takeKey(event), {capture: true});
    measureHeight('timeline', '--floor');
    link.onChange(() => this.show());
  }

  private send(command: PlaybackCommand): void {
    void this.link.command(command);
    this.show();
  }

  /** The seek is sent when the slider is let go: a seek on each pixel would make all viewers jump. */
  private drag(): void {
    this.dragged = true;
    this.time.textContent = `${clock(Number(this.slider.value))} / ${clock(this.link.state?.duration_s ?? 0)}`;
  }

  private drop(): void {
    this.dragged = false;
    if (this.link.state !== undefined) this.send(seekTo(this.link.state, Number(this.slider.value)));
  }

  private takeKey(event: KeyboardEvent): void {
    const {state} = this.link;
    if (state === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector('dialog[open]') !== null) return;
    const command = commandForKey(event.key, focusOf(event.target), state);
    if (command === undefined) return;
    event.preventDefault();
    if (!event.repeat || command.seek_s !== undefined) this.send(command);
  }

  private show(): void {
    const {state, problem} = this.link;
    this.bar.hidden = state === undefined;
    element('timeline-own').hidden = ownQuery() === '';
    this.loop.hidden = ownQuery() !== '';  // its own session begins again at its end, always
    if (state === undefined) return;
    const look = timelineLook(state);
    setText(this.play, look.symbol);
    this.play.setAttribute('aria-label', look.play);
    this.play.title = `${look.play} (space)`;
    this.loop.setAttribute('aria-checked', String(look.loop));
    setText(this.problem, problem);
    this.problem.hidden = problem === '';
    this.showSpeeds(look.speeds);
    this.speed.value = look.speed;
    if (this.dragged) return;
    this.slider.max = String(look.longest_s);
    this.slider.value = String(look.position_s);
    this.slider.setAttribute('aria-valuetext', look.spokenTime);
    setText(this.time, look.time);
  }

  private showSpeeds(speeds: readonly string[]): void {
    if (Array.from(this.speed.options, ({value}) => value).join() === speeds.join()) return;
    this.speed.replaceChildren(...speeds.map((speed) => new Option(`${speed} ×`, speed)));
  }
}

function focusOf(target: EventTarget | null): Focus {
  if (target instanceof HTMLSelectElement) return 'choice';
  if (target instanceof HTMLInputElement && target.id !== 'timeline-slider') return 'choice';  // moved or written by its own keys
  if (target instanceof HTMLButtonElement) return 'button';
  return target instanceof HTMLCanvasElement ? 'scene' : 'other';
}
