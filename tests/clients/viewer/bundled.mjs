// A module of the viewer's sources, bundled for Node: node SOME_test.mjs VIEWER_SOURCES VIEWER_WORK
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

/** Bundles modules of the viewer's `sources` with the packages in the build's folder `work`. */
export const bundler = (sources, work) => async (module) => {
  const {buildSync} = await import(pathToFileURL(join(work, 'node_modules/esbuild/lib/main.js')));
  const built = buildSync({
    entryPoints: [join(sources, module)], nodePaths: [join(work, 'node_modules')], bundle: true, format: 'esm',
    write: false,
  });
  return import(`data:text/javascript;base64,${Buffer.from(built.outputFiles[0].text).toString('base64')}`);
};

const [ownSources, ownWork] = process.argv.slice(2);
export const bundled = bundler(ownSources, ownWork);
