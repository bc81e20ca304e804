// What axe finds on a page.
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
