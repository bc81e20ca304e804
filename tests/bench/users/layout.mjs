// node layout.mjs BIN_DIR VIEWER_FILES: what the page leaves to the patient, as rows of telepalp-bench users.
import {openBrowser, untilStatus} from '../../end_to_end/browser.mjs';
import {patientShares, playRecording} from '../../end_to_end/played_site.mjs';
import {Workplace} from '../../end_to_end/running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('layout_bench');
let browser;

const row = (name, share, bound, budget) =>
    console.log([name, (100 * share).toFixed(1), '% of the page', bound, budget].join('\t'));

async function measure(page, name) {
  const {uncovered, rectangle} = await patientShares(page);
  row(`${name}: patient`, uncovered, 'at_least', 70);
  row(`${name}: largest rectangle without a card`, rectangle, 'none', 0);
}

try {
  const address = await playRecording(place, binDir, viewer, 6);
  browser = await openBrowser(place.folder, {width: 1400, height: 900});
  const {page} = browser;
  for (const view of ['doctor', 'technician', 'qa']) {
    await page.goto(`${address}?view=${view}`);
    await untilStatus(page, 'the mesh is drawn', (now) => now.connected && now.meshVertices > 200);
    if (view === 'qa') {
      await page.selectOption('#comparison-with', 'other.mcap');
      await page.waitForSelector('#comparison', {state: 'visible'});
    }
    const open = await patientShares(page);
    row(`${view}, nothing folded: patient`, open.uncovered, 'none', 0);
    await page.click('#fold-all');
    await measure(page, `${view}${view === 'qa' ? ' with Compare' : ''}, cards folded`);
  }
} finally {
  await browser?.context.close();
  await place.end();
}
