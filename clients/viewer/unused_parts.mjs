// An esbuild plugin that leaves out of three.js what the viewer never draws, and no bundler can leave out, because
// WebGLRenderer names it: shaders of physical, toon, lambert and matcap materials, environment maps, shadows, sprites,
// points, morphing; the classes that serve them; animations. A build fails when three.js has none of a group any more.
import {readFile} from 'node:fs/promises';

const SHADERS = [
  /^lights_(physical|toon|lambert)/, /^mesh(physical|toon|lambert|matcap|normal)_/, /^(transmission|iridescence|clearcoat)/,
  /^(envmap|cube_uv)/, /^shadow/, /^(sprite|points|distanceRGBA|equirect|cube|background|backgroundCube)_/,
  /^(morph|skin|batching|alphahash|bumpmap|tonemapping_pars|gradientmap|lightmap|aomap|metalnessmap|roughnessmap)/,
];

/** For each unused function of the renderer: what it returns instead, which does what the whole does without work. */
const FUNCTIONS = {
  WebGLCubeMaps: '{get: (texture) => texture, dispose() {}}',
  WebGLCubeUVMaps: '{get: (texture) => texture, dispose() {}}',
  WebGLMorphtargets: '{update() {}}',
  WebGLShadowMap: '{enabled: false, render() {}}',
  WebGLUniformsGroups: '{bind() {}, update() {}, dispose() {}}',
};

/** Statements that keep animations and loaders in the bundle, though nothing else names these. */
const SIDE_EFFECTS = [/^PropertyBinding\.[^;]*;$/gm, /^\w*KeyframeTrack\.[^;]*;$/gm, /^Loader\.[^;]*;$/gm];

const gone = (what) => ({text: `three.js has no ${what}. fix: remove it from unused_parts.mjs`});

function withoutShaders(source, errors) {
  const chunks = /const ShaderChunk = \{[^}]*\};/.exec(source)?.[0] ?? '';
  const nameOf = new Map([...chunks.matchAll(/(\w+): ([\w$]+)/g)].map(([, name, variable]) => [variable, name]));
  const emptied = new Set();
  const contents = source.replace(/^(var|const) ([\w$]+) = "(?:[^"\\]|\\.)*";/gm, (text, kind, variable) => {
    const group = SHADERS.find((pattern) => pattern.test(nameOf.get(variable) ?? ''));
    if (group === undefined) return text;
    emptied.add(group);
    return `${kind} ${variable} = "";`;
  });
  errors.push(...SHADERS.filter((group) => !emptied.has(group)).map((group) => gone(`shader whose name matches ${group}`)));
  return contents;
}

function withoutFunctions(source, errors) {
  return Object.entries(FUNCTIONS).reduce((text, [name, instead]) => {
    const whole = new RegExp(`^function ${name}\\([^]*?^}`, 'm');
    if (!whole.test(text)) errors.push(gone(`function ${name}`));
    return text.replace(whole, `function ${name}() { return ${instead}; }`);
  }, source);
}

function withoutSideEffects(source, errors) {
  return SIDE_EFFECTS.reduce((text, statements) => {
    if (text.search(statements) < 0) errors.push(gone(`statement that matches ${statements}`));
    return text.replace(statements, '');
  }, source);
}

export const withoutUnusedParts = {
  name: 'without-unused-parts',
  setup(build) {
    const cut = (filter, ...cuts) => build.onLoad({filter}, async ({path}) => {
      const errors = [];
      const contents = cuts.reduce((source, one) => one(source, errors), await readFile(path, 'utf8'));
      return {contents, loader: 'js', errors};
    });
    cut(/three\/build\/three\.module\.js$/, withoutShaders, withoutFunctions);
    cut(/three\/build\/three\.core\.js$/, withoutSideEffects);
  },
};
