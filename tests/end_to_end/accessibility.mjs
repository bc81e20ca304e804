// What axe finds on a page.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const AXE = readFileSync(createRequire(new URL('../npm/package.json', import.meta.url)).resolve('axe-core/axe.min.js'), 'utf8');

/** Violations of WCAG 2 A and AA within `selector`, one line for each element. */
export async function violations(page, selector = 'html') {
  await page.evaluate(AXE);
  const {violations: found} = await page.evaluate((within) => globalThis.axe.run(within, {
    runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'], resultTypes: ['violations'],
  }), selector);
  return found.flatMap(({id, nodes}) => nodes.map(({target, failureSummary}) => `${id}: ${target}: ${failureSummary}`));
}

/**
 * Turns a page with a button #theme to its light theme and 800 pixels of width, and back. Nothing may be cut off, and axe
 * must find nothing. `picture(name, options)` takes a picture meanwhile.
 */
export async function checkNarrowInLight(page, picture) {
  await page.click('#theme');
  await page.setViewportSize({width: 800, height: 900});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 800), 'nothing is cut off');
  assert.deepEqual(await violations(page), []);
  await picture('light', {fullPage: true});
  await page.click('#theme');
  await page.setViewportSize({width: 1280, height: 800});
}
