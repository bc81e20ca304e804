// Debian's Chromium, headless, and what a test sees through it.
import {existsSync, mkdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

import {until} from './running_program.mjs';

const {chromium} = createRequire(new URL('../npm/package.json', import.meta.url))('playwright-core');

const FLAGS = [
  '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];

/** A page in a new browser; `problems` collects the errors on the page's console. `options`: more of playwright's. */
export async function openBrowser(folder, viewport = {width: 900, height: 640}, options = {}) {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) throw new Error(`no ${executablePath}: install chromium, or name it in CHROMIUM`);
  const profile = join(folder, 'profile');
  mkdirSync(profile);
  const context = await chromium.launchPersistentContext(
      profile, {executablePath, headless: true, args: FLAGS, viewport, timeout: 120_000, ...options});
  const page = context.pages()[0] ?? (await context.newPage());
  page.setDefaultTimeout(120_000);
  const problems = [];
  page.on('pageerror', (problem) => problems.push(String(problem)));
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  return {context, page, problems};
}

/** Saves a picture of the page as `folder`/`name`.png, unless no folder was given. */
export async function savePicture(page, folder, name, options = {}) {
  if (!folder) return;
  mkdirSync(folder, {recursive: true});
  await page.screenshot({path: join(folder, `${name}.png`), ...options});
}

export const status = (page) => page.evaluate(() => window.telepalp);

/** The playback of the page's own session; without values until the page has opened it. */
export const ownPlayback = (page) => page.evaluate(async () => {
  if (!window.telepalp?.connected) return {};  // the server does not know the session yet, and a 404 is a problem of the page
  const reply = await fetch(`playback${globalThis.telepalpOwnQuery}`);
  return reply.ok ? reply.json() : {};
});

/** Waits until `holds(status)` is true. */
export const untilStatus = (page, what, holds, timeout_ms = 120_000) =>
    until(what, async () => {
      const now = await status(page);
      return now !== undefined && holds(now) ? now : undefined;
    }, timeout_ms).catch(async (problem) => {
      throw new Error(`${problem.message}; the page says ${JSON.stringify(await status(page))}`);
    });

/**
 * For the middle of the picture: the share that differs from the empty background, the number of colours, and the number
 * of pixels that are nearly of the colour `sought`.
 */
export async function lookAtMiddle(context, png, sought = [0, 0, 0]) {
  const page = await context.newPage();
  try {
    return await page.evaluate(async ([base64, sought]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes], {type: 'image/png'}));
      const canvas = new OffscreenCanvas(picture.width, picture.height);
      const context = canvas.getContext('2d');
      context.drawImage(picture, 0, 0);
      const [width, height] = [Math.floor(picture.width / 3), Math.floor(picture.height / 3)];
      const {data} = context.getImageData(width, height, width, height);
      const colors = new Set();
      let drawn = 0;
      let alike = 0;
      for (let at = 0; at < data.length; at += 4) {
        const [red, green, blue] = data.subarray(at, at + 3);
        if (Math.abs(red - 7) + Math.abs(green - 11) + Math.abs(blue - 16) > 24) ++drawn;
        if (Math.max(Math.abs(red - sought[0]), Math.abs(green - sought[1]), Math.abs(blue - sought[2])) < 24) ++alike;
        colors.add((red << 16) | (green << 8) | blue);
      }
      return {drawn: drawn / (width * height), colors: colors.size, alike};
    }, [png.toString('base64'), sought]);
  } finally {
    await page.close();
  }
}
