// How soon a page says that its server is silent: the server is stopped by SIGSTOP, and what the page shows is noted with
// its times by an observer in the page.
import {status, untilStatus} from './browser.mjs';
import {sleep, until} from './running_program.mjs';

/** Notes, from now on, each change of what the page says about its age. Times are those of Date.now(). */
async function observe(page) {
  await page.evaluate(() => {
    const text = (id) => document.getElementById(id).textContent;
    const banner = document.getElementById('banner');
    const look = () => ({
      at_ms: performance.timeOrigin + performance.now(),
      dimmed: getComputedStyle(document.getElementById('scene')).filter.includes('brightness(0.6)'),
      light: document.getElementById('link').dataset.state,
      banner: banner.hidden ? '' : text('banner-title'),
      numbersOld: document.body.dataset.numbers === 'old',
      force: text('force'),
      indentation: text('indentation'),
    });
    window.looks = [look()];
    new MutationObserver(() => window.looks.push(look()))
        .observe(document.body, {attributes: true, subtree: true, childList: true, characterData: true});
  });
}

/** The first time from `from_ms` on at which `holds`, and still holds at the end; undefined: it does not. */
function since(looks, from_ms, holds) {
  const later = looks.filter(({at_ms}) => at_ms >= from_ms);
  const last = later.findLastIndex((look) => !holds(look));
  return later[last + 1]?.at_ms;
}

/** Waits until the path is known, and up to a minute longer until its images are regular. */
async function regularPath(page) {
  const hand = (now) => now.force_N > 0.3 && !now.stale;
  await untilStatus(page, 'the path is known', (now) => now.imageGap_ms !== undefined);
  return untilStatus(page, 'the images are regular', (now) => hand(now) && now.imageGap_ms <= 100, 60_000)
      .catch(() => untilStatus(page, 'the hand presses', hand));
}

/**
 * Stops the server for 2.5 s. Returns, in milliseconds since the stop, when each part of the page says so, and
 * `allowed_ms`: 300 ms where the gaps between images are at most 100 ms, else the gap and 200 ms.
 */
export async function stopServer(page, child) {
  await observe(page);
  const {imageGap_ms} = await regularPath(page);
  const from_ms = Date.now();
  child.kill('SIGSTOP');
  await sleep(2500);
  const looks = await page.evaluate(() => window.looks);
  const shown = await status(page);
  child.kill('SIGCONT');
  const after = (holds) => (since(looks, from_ms, holds) ?? Infinity) - from_ms;
  return {
    imageGap_ms,
    allowed_ms: imageGap_ms <= 100 ? 300 : imageGap_ms + 200,
    light_ms: after(({light}) => light === 'stale'),
    banner_ms: after(({banner}) => banner === 'Stale picture'),
    dimmed_ms: after(({dimmed}) => dimmed),
    numbersMarked_ms: after(({numbersOld, force}) => numbersOld || force === '–'),
    numbersGone_ms: after(({force, indentation}) => force === '–' && indentation === '–'),
    handHidden: shown.handPosition_m === undefined,
  };
}

/** Waits until the page shows the patient again as live. */
export const untilLive = (page) => until('the page is live again', () => page.evaluate(() =>
    document.body.dataset.old === 'false' && document.getElementById('link').dataset.state === 'live' &&
    document.getElementById('force').textContent !== '–'));
