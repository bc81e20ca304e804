// An esbuild plugin that empties three.js's shaders for what the viewer never draws: physical, toon, lambert and matcap
// materials, environment maps, shadows, sprites, points, morphing. WebGLRenderer names them all, so no bundler can
// leave them out. A build fails when three.js has none of a group any more.
import {readFile} from 'node:fs/promises';

const UNUSED = [
  /^lights_(physical|toon|lambert)/, /^mesh(physical|toon|lambert|matcap|normal)_/, /^(transmission|iridescence|clearcoat)/,
  /^(envmap|cube_uv)/, /^shadow/, /^(sprite|points|distanceRGBA|equirect|cube|background|backgroundCube)_/,
  /^(morph|skin|batching|alphahash|bumpmap|tonemapping_pars|gradientmap|lightmap|aomap|metalnessmap|roughnessmap)/,
];

export const withoutUnusedShaders = {
  name: 'without-unused-shaders',
  setup(build) {
    build.onLoad({filter: /three\/build\/three\.module\.js$/}, async ({path}) => {
      const source = await readFile(path, 'utf8');
      const chunks = /const ShaderChunk = \{[^}]*\};/.exec(source)?.[0] ?? '';
      const nameOf = new Map([...chunks.matchAll(/(\w+): ([\w$]+)/g)].map(([, name, variable]) => [variable, name]));
      const emptied = new Set();
      const contents = source.replace(/^(var|const) ([\w$]+) = "(?:[^"\\]|\\.)*";/gm, (text, kind, variable) => {
        const group = UNUSED.find((pattern) => pattern.test(nameOf.get(variable) ?? ''));
        if (group === undefined) return text;
        emptied.add(group);
        return `${kind} ${variable} = "";`;
      });
      const errors = UNUSED.filter((group) => !emptied.has(group)).map((group) => ({text: `three.js has no shader whose name matches ${group}. fix: remove this pattern from unused_shaders.mjs`}));
      return {contents, loader: 'js', errors};
    });
  },
};
