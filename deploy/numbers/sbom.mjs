// deploy/sbom: a software bill of materials of the Debian packages, as CycloneDX 1.5 JSON. The same packages on the same
// system give the same bytes.
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {fieldsOf, namesIn} from './packages.mjs';

const SOURCES = join(dirname(fileURLToPath(import.meta.url)), '../..');
const HELP = `deploy/sbom: lists what telepalp's Debian packages consist of and need (CycloneDX 1.5 JSON)

usage: deploy/sbom PACKAGE.deb... [--out FILE]

It names the packages with their SHA-256; each package of this Debian that they need, directly or through others, with
the version that is installed here; the packages of headers that are compiled in; and the npm packages in the web page.
The time is SOURCE_DATE_EPOCH, or that of the commit.

  --out FILE  write the list to FILE; default: stdout

example: deploy/sbom build/telepalp*.deb --out build/telepalp.cdx.json
`;

const read = (command, ...words) => execFileSync(command, words, {encoding: 'utf8', maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe']});
const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');
const byRef = (one, other) => (one['bom-ref'] ?? one.ref) < (other['bom-ref'] ?? other.ref) ? -1 : 1;
const purlVersion = (version) => encodeURIComponent(version);

/** What dpkg has installed, by name; a name that another package provides leads to that package. */
export function installedIn(status) {
  const installed = new Map();
  const paragraphs = status.split(/\n\n+/).map(fieldsOf).filter(({Package}) => Package !== undefined);
  for (const fields of paragraphs) if (/ installed$/.test(fields.Status ?? '')) installed.set(fields.Package, fields);
  for (const fields of [...installed.values()])
    for (const name of namesIn(fields.Provides)) if (!installed.has(name)) installed.set(name, fields);
  return installed;
}

/** The names of installed packages that `depends` asks for: of alternatives, the first one that is installed. */
export const neededOf = (depends = '', installed) => [...new Set(depends.split(',').map((choice) => choice.trim()).filter((choice) => choice !== '')
  .map((choice) => namesIn(choice).find((name) => installed.has(name)))
  .filter((name) => name !== undefined).map((name) => installed.get(name).Package))];

const debianRef = ({Package, Version, Architecture}) =>
  `pkg:deb/debian/${Package}@${purlVersion(Version)}?arch=${Architecture}`;

const debianComponent = (fields, properties) => {
  const ref = debianRef(fields);
  return {type: 'library', 'bom-ref': ref, name: fields.Package, version: fields.Version, purl: ref, ...properties};
};

/** Debian's package of headers that are compiled in. What it needs is for compiling alone, and is not listed. */
const headerComponent = (fields) => debianComponent(fields, {properties: [{name: 'telepalp:role', value: 'headers, compiled in'}]});

/** A component for each package in `names` and each one that these need, and the components' dependencies. */
export function debianParts(names, installed) {
  const components = new Map(), open = [...names];
  const dependencies = [];
  while (open.length > 0) {
    const fields = installed.get(open.pop());
    if (fields === undefined || components.has(fields.Package)) continue;
    const needed = neededOf([fields['Pre-Depends'], fields.Depends].filter((text) => text !== undefined).join(','), installed);
    components.set(fields.Package, debianComponent(fields));
    dependencies.push({ref: debianRef(fields), dependsOn: needed.map((name) => debianRef(installed.get(name))).sort()});
    open.push(...needed);
  }
  return {components: [...components.values()], dependencies};
}

/** SHA-512 of an npm package as its lock file states it, in hexadecimal digits. */
const npmHash = (integrity) => [{alg: 'SHA-512', content: Buffer.from(integrity.replace(/^sha512-/, ''), 'base64').toString('hex')}];

/** The npm packages of a lock file that are not only for development. */
export function npmParts(lock) {
  const used = Object.entries(lock.packages).filter(([path, {dev, devOptional, optional}]) => path !== '' && !dev && !devOptional && !optional);
  const nameOf = (path) => path.replace(/^.*node_modules\//, '');
  const refOf = ([path, {version}]) => `pkg:npm/${nameOf(path).replace('@', '%40')}@${version}`;
  const refs = new Map(used.map((entry) => [nameOf(entry[0]), refOf(entry)]));
  const refsOf = (names = {}) => Object.keys(names).filter((name) => refs.has(name)).map((name) => refs.get(name)).sort();
  return {
    components: used.map((entry) => ({
      type: 'library', 'bom-ref': refOf(entry), name: nameOf(entry[0]), version: entry[1].version, purl: refOf(entry),
      hashes: npmHash(entry[1].integrity), licenses: [{expression: entry[1].license}],
    })),
    dependencies: used.map((entry) => ({ref: refOf(entry), dependsOn: refsOf(entry[1].dependencies)})),
    direct: refsOf(lock.packages[''].dependencies),
  };
}

/** One of telepalp's own packages: its component, and the names of the packages that it needs. */
function ownPackage(file) {
  const fields = fieldsOf(read('dpkg-deb', '-f', file));
  const ref = `pkg:deb/telepalp/${fields.Package}@${purlVersion(fields.Version)}?arch=${fields.Architecture}`;
  return {
    depends: fields.Depends ?? '', name: fields.Package, version: fields.Version,
    component: {
      type: 'application', 'bom-ref': ref, name: fields.Package, version: fields.Version, purl: ref,
      hashes: [{alg: 'SHA-256', content: sha256(readFileSync(file))}], licenses: [{license: {id: 'Apache-2.0'}}],
      properties: [{name: 'telepalp:file', value: basename(file)}],
    },
  };
}

/** The whole list. `own`: telepalp's packages; `headers`: names of Debian's packages that are compiled in. */
export function bomOf({own, installed, headers, lock, time}) {
  const refs = new Map(own.map(({name, component}) => [name, component['bom-ref']]));
  const npm = npmParts(lock);
  const compiledIn = headers.filter((name) => installed.has(name)).map((name) => installed.get(name));
  const ofOthers = own.flatMap(({depends}) => neededOf(depends, installed)).filter((name) => !refs.has(name));
  const debian = debianParts(ofOthers, installed);
  const needs = ({name, depends}) => [
    ...namesIn(depends).filter((needed) => refs.has(needed)).map((needed) => refs.get(needed)),
    ...neededOf(depends, installed).filter((needed) => !refs.has(needed)).map((needed) => debianRef(installed.get(needed))),
    ...(name === 'telepalp-server' ? npm.direct : []),
  ];
  const whole = `telepalp@${own[0].version}`;
  const bom = {
    bomFormat: 'CycloneDX', specVersion: '1.5', version: 1,
    metadata: {timestamp: time, component: {type: 'application', 'bom-ref': whole, name: 'telepalp', version: own[0].version}},
    components: [...own.map(({component}) => component), ...debian.components, ...compiledIn.map(headerComponent), ...npm.components].sort(byRef),
    dependencies: [
      {ref: whole, dependsOn: [...refs.values(), ...compiledIn.map(debianRef)].sort()},
      ...own.map((one) => ({ref: refs.get(one.name), dependsOn: [...new Set(needs(one))].sort()})),
      ...debian.dependencies, ...npm.dependencies,
    ].sort(byRef),
  };
  const hash = sha256(JSON.stringify(bom));
  const uuid = `${hash.slice(0, 8)}-${hash.slice(8, 12)}-5${hash.slice(13, 16)}-a${hash.slice(17, 20)}-${hash.slice(20, 32)}`;
  return {bomFormat: bom.bomFormat, specVersion: bom.specVersion, serialNumber: `urn:uuid:${uuid}`, ...bom};
}

function timeOfSources() {
  const seconds = process.env.SOURCE_DATE_EPOCH ?? read('git', '-C', SOURCES, 'log', '-1', '--format=%ct').trim();
  return new Date(Number(seconds) * 1000).toISOString().replace('.000Z', 'Z');
}

function asked(words) {
  const at = words.indexOf('--out');
  const out = at < 0 ? undefined : words[at + 1];
  const files = at < 0 ? words : words.filter((_, place) => place !== at && place !== at + 1);
  const wrong = files.find((file) => file.startsWith('-'));
  if (wrong !== undefined || files.length === 0 || (at >= 0 && out === undefined))
    throw Object.assign(new Error(wrong === undefined ? 'no package, or no file after --out, is named' : `'${wrong}' is not an option`), {code: 2});
  return {files, out};
}

function main(words) {
  if (words.includes('--help') || words.includes('-h')) return process.stdout.write(HELP);
  const {files, out} = asked(words);
  const headers = readFileSync(join(SOURCES, 'deploy/packages/build.txt'), 'utf8').split('\n').filter((name) => name.endsWith('-dev'));
  const bom = bomOf({
    own: files.map(ownPackage), installed: installedIn(readFileSync('/var/lib/dpkg/status', 'utf8')), headers,
    lock: JSON.parse(readFileSync(join(SOURCES, 'clients/viewer/package-lock.json'), 'utf8')), time: timeOfSources(),
  });
  const text = `${JSON.stringify(bom, null, 1)}\n`;
  return out === undefined ? process.stdout.write(text) : writeFileSync(out, text);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    main(process.argv.slice(2));
  } catch (problem) {
    const why = String(problem.stderr || problem.message).trim().split('\n')[0];
    process.stderr.write(`error: deploy/sbom: ${why}. fix: deploy/sbom PACKAGE.deb... [--out FILE]; deploy/package makes the packages\n`);
    process.exitCode = problem.code === 2 ? 2 : 1;
  }
}
