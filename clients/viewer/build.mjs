// Bundles the viewer into the folder named on the command line, each file also compressed by Brotli as NAME.br:
// node build.mjs OUT
import {build, transform} from 'esbuild';
import {mkdir, readFile, writeFile} from 'node:fs/promises';
import {basename, join} from 'node:path';
import {brotliCompressSync} from 'node:zlib';

import {withoutUnusedParts} from './unused_parts.mjs';

const out = process.argv[2] ?? 'dist';
await mkdir(out, {recursive: true});
const {metafile} = await build({
  entryPoints: {start: 'src/start.ts', viewer: 'src/main.ts', link_worker: 'src/site/link_worker.ts',
                depth_worker: 'src/depth/depth_worker.ts', mixed: 'src/mixed/headset_anchor.ts',
                voice_lanes: 'src/playback/voice_lanes.ts',
                later_cards: 'src/panel/technician/later_cards.ts', voice: 'src/voice/voice.ts', voice_worker: 'src/voice/voice_worker.ts', voice_worklet: 'src/voice/voice_worklet.ts'},
  outdir: out,
  bundle: true,
  format: 'esm',
  target: ['es2022'],
  minify: true,
  legalComments: 'eof',
  metafile: true,
  plugins: [withoutUnusedParts],
  logLevel: 'warning',
});

const listed = await readFile('THIRD_PARTY.md', 'utf8');
const bundled = Object.values(metafile.outputs).flatMap((output) => Object.keys(output.inputs));
const packages = new Set(bundled.map((path) => /.*node_modules\/((@[^/]+\/)?[^/]+)/.exec(path)?.[1]).filter(Boolean));
const unlisted = [...packages].filter((name) => !listed.includes(`| \`${name}\` |`));
if (unlisted.length > 0) {
  console.error(`bundled packages that THIRD_PARTY.md does not list: ${unlisted.join(', ')}. fix: add a row for each`);
  process.exit(1);
}

const styles = ['viewer.css', 'views.css', 'inside.css', 'said.css'];
for (const name of styles) {
  const {code} = await transform(await readFile(join('src', name), 'utf8'), {loader: 'css', minify: true});
  await writeFile(join(out, name), code);
}
const page = [...styles.map((name) => join(out, name)), 'src/index.html', 'src/depth/depth_decoder.wasm'];
for (const file of [...Object.keys(metafile.outputs), ...page])
  await writeFile(join(out, `${basename(file)}.br`), brotliCompressSync(await readFile(file)));
