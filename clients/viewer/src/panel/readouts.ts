import {CaptureState} from '../messages/generated';
import {element, setText as write} from '../page/page';
import type {Touch} from '../present/instant';
import {total_ms} from '../present/time_account';
import type {Detail} from '../scene/frame_pacer';
import {forceColor} from '../scene/force_color';
import type {Reading} from '../state/viewer_state';
import {bannerFor} from './banner';
import type {Banner} from './banner_look';
import {lookOf} from '../words/phases';
import {TouchPlots} from './plots/touch_plots';
import {Voice} from './voice';

const milliseconds = (ms: number | undefined) =>
    ms === undefined ? '–' : ms < 999.5 ? `${Math.max(0, Math.round(ms))} ms` : `${(ms / 1000).toFixed(ms < 9950 ? 1 : 0)} s`;

const OLD_MS = 250;
const LEAST_N = 0.05;  // a smaller force is shown as 0.0 N
const NOTICE_MS = 10_000;
const PLOTS_EVERY = 2;  // the plots are drawn at each 2nd call of show(), 5 times a second: they cost the most

/** Writes the readings that every view has. */
export class Readouts {
  private readonly plots = new TouchPlots();
  private readonly voice = new Voice();
  private readonly eyes = document.querySelectorAll<HTMLElement>('.eye');
  private shows = 0;
  private notice: Banner | undefined;  // set for NOTICE_MS by showNotice()

  /** The station's values since the last presented instant. */
  addTrail(trail: readonly Touch[]): void {
    for (const touch of trail) this.plots.add(touch);
  }

  /** The numbers that belong to the picture just drawn. */
  showNumbers(reading: Reading): void {
    this.showPhase(reading);
    this.showTouch(reading);
  }

  show(reading: Reading): void {
    this.showLink(reading);
    this.showDepth(reading);
    this.showNumbers(reading);
    this.showFreshness(reading);
    this.updateBanner(reading);
    this.showToEyes();
    if (++this.shows % PLOTS_EVERY === 0) this.plots.draw();
  }

  /** The level of detail to which the drawing has adapted. */
  showDetail({stride, pixelRatio}: Detail): void {
    const share = Math.min(1, pixelRatio / window.devicePixelRatio);
    setText('drawn-detail', `${stride === 1 ? 'each pixel' : `mesh 1:${stride}`}, ${(100 * share).toFixed(0)} %`);
  }

  private showLink(reading: Reading): void {
    const {capture} = reading;
    const [state, text] = linkLook(reading);
    element('link').dataset['state'] = state;
    setText('link-text', text);
    const away = capture === undefined || capture.state === CaptureState.UNSPECIFIED;
    setText('source', away ? '' : shortSource(capture.source) + (capture.colorRegistered ? '' : ' · colour not aligned'));
    element('source').title = away ? '' : capture.source;
  }

  /** Shows the depth's accuracy only if depth is not as measured. */
  private showDepth({depth}: Reading): void {
    element('depth').hidden = !depth?.moved;
    if (!depth?.moved) return;
    setText('depth-mode', depth.mode === '' ? 'depth' : `depth: ${depth.mode}`);
    setText('depth-off', depth.howFar);
    element('depth').title = depth.more;
  }

  private showPhase({phase}: Reading): void {
    const look = lookOf(phase);
    element('badge').dataset['tone'] = look.tone;
    setText('phase-name', look.name);
    setText('phase-says', look.says);
    if (phase !== undefined) this.speak(this.voice.ofPhase(look, performance.now()), look.tone === 'alarm');
  }

  private speak(words: string | undefined, urgent: boolean): void {
    if (words !== undefined) setText(urgent ? 'spoken-alarm' : 'spoken', words);
  }

  /** In stereo, each eye gets the same line: a card would lie over one eye alone. */
  private showToEyes(): void {
    const alarm = element('banner').hidden ? '' : ` · ${element('banner-title').textContent}`;
    const line = `${element('phase-name').textContent} · ${element('force').textContent} N${alarm}`;
    for (const eye of this.eyes) write(eye, line);
  }

  private showTouch({force_N, torque_N_m, drive_N, indentation_mm, limited}: Reading): void {
    setText('force', force_N === undefined ? '–' : force_N.toFixed(1));
    setText('indentation', indentation_mm === undefined ? '–' : indentation_mm.toFixed(0));
    element('force').style.color = force_N === undefined || force_N < LEAST_N ? '' : forceColor(force_N).getStyle();
    element('torque').hidden = torque_N_m === undefined;  // most devices give none
    setText('torque', `torque ${(torque_N_m ?? 0).toFixed(2)} N m`);
    element('drive').hidden = (drive_N ?? 0) < LEAST_N;
    setText('drive', `drive ${(drive_N ?? 0).toFixed(1)} N, not contact`);
    element('limited').hidden = !limited || (force_N ?? 0) < LEAST_N;  // a scene without force has the limit 0 N
  }

  private showFreshness(reading: Reading): void {
    const {clockError_ms, paused} = reading;
    const account = paused ? undefined : reading.account;  // a session that stands still grows no older
    showAge('surface-age', reading.surface_ms);
    showAge('picture-age', paused ? undefined : account === undefined ? reading.picture_ms : total_ms(account), clockError_ms);
    if (paused) setText('picture-age', 'paused');
    showAge('site-age', account?.site);
    showAge('link-age', account?.network ?? (paused ? undefined : reading.link_ms), clockError_ms);
    showAge('computer-age', account?.computer);
    setText('fps', reading.picture_ms === undefined ? '–' : `${reading.fps.toFixed(0)} /s`);
    setText('dropped', String(reading.dropped));
    setText('late', reading.lateTicks === undefined ? '–' : String(reading.lateTicks));
  }

  private updateBanner(reading: Reading): void {
    document.body.dataset['old'] = String(reading.stale || (!reading.connected && reading.everConnected));
    document.body.dataset['numbers'] = reading.numbersOld ? 'old' : '';
    const banner = bannerFor(reading);
    this.showBanner(reading.stale || banner?.level === 'alarm' ? banner : this.notice ?? banner);
    setTitle(banner);
  }

  /** Shows `notice` in the banner for NOTICE_MS, except while the picture is stale or the readings cause an alarm. */
  showNotice(notice: Banner): void {
    this.notice = notice;
    window.setTimeout(() => {
      if (this.notice === notice) this.notice = undefined;
    }, NOTICE_MS);
  }

  showBanner(banner: Banner | undefined): void {
    element('banner').hidden = banner === undefined;
    this.speak(this.voice.ofBanner(banner, performance.now()), banner?.level === 'alarm');
    if (banner === undefined) return;
    element('banner').dataset['level'] = banner.level;
    setText('banner-title', banner.title);
    setText('banner-text', banner.text);
    element('rearm').hidden = banner.rearms !== true;
    element('accept-object').hidden = banner.acceptsObject !== true;
  }
}

function linkLook({connected, everConnected, stale, silence_ms}: Reading): [string, string] {
  if (!connected) return everConnected ? ['lost', 'disconnected'] : ['wait', 'connecting'];
  if (!stale) return ['live', 'connected'];
  return ['stale', silence_ms === undefined ? 'late' : 'silent'];
}

/** "session:/data/2026/anna.mcap" becomes "session: anna.mcap". */
const shortSource = (source: string) => source.replace(/^(\w+):.*\//, '$1: ');

/** The title is all that is seen of a page in the background, where nothing is drawn. */
function setTitle(banner: Banner | undefined): void {
  const title = banner?.level === 'alarm' ? `⚠ ${banner.title} – telepalp` : document.hidden ? 'Paused – telepalp' : 'telepalp viewer';
  if (document.title !== title) document.title = title;
}

/** `error_ms`: bound on the error of an age that compares two computers' clocks. */
function showAge(id: string, ms: number | undefined, error_ms?: number): void {
  const within = error_ms === undefined ? '' : `± ${Math.max(1, Math.ceil(error_ms))} `;
  setText(id, milliseconds(ms).replace(/ms$/, `${within}ms`));
  element(id).dataset['old'] = String(ms !== undefined && ms > OLD_MS);
}

const setText = (id: string, text: string) => write(element(id), text);
