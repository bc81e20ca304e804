// Bundles the viewer into the folder named on the command line: node build.mjs OUT
import {build} from 'esbuild';
import {mkdir, readFile} from 'node:fs/promises';

const out = process.argv[2] ?? 'dist';
await mkdir(out, {recursive: true});
const {metafile} = await build({
  entryPoints: {viewer: 'src/main.ts', link_worker: 'src/link/link_worker.ts',
                depth_worker: 'src/depth/depth_worker.ts'},
  outdir: out,
  bundle: true,
  format: 'esm',
  target: ['es2022'],
  minify: true,
  legalComments: 'eof',
  metafile: true,
  logLevel: 'warning',
});

const listed = await readFile('THIRD_PARTY.md', 'utf8');
const bundled = Object.values(metafile.outputs).flatMap((output) => Object.keys(output.inputs));
const packages = new Set(bundled.map((path) => /.*node_modules\/((@[^/]+\/)?[^/]+)/.exec(path)?.[1]).filter(Boolean));
const unlisted = [...packages].filter((name) => !listed.includes(`| \`${name}\` |`));
if (unlisted.length > 0) {
  console.error(`bundled, but not listed in THIRD_PARTY.md: ${unlisted.join(', ')}`);
  process.exit(1);
}
