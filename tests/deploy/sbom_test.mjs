// deploy/sbom lists what small packages with known needs need, and its list is CycloneDX by the standard's own schema:
// node sbom_test.mjs SOURCE_DIR
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {cyclonedxErrors} from './cyclonedx.mjs';

const sourceDir = process.argv[2];
const {installedIn, neededOf, debianParts, npmParts, bomOf} = await import(join(sourceDir, 'deploy/numbers/sbom.mjs'));
const work = mkdtempSync(join(tmpdir(), 'sbom-test-'));
after(() => rmSync(work, {recursive: true, force: true}));

const paragraph = (name, version, more = '') =>
  `Package: ${name}\nStatus: install ok installed\nArchitecture: amd64\nVersion: ${version}\n${more}`;
const STATUS = [
  paragraph('liba1', '1:2.0+deb12u1', 'Pre-Depends: libc6 (>= 2.34)\nDepends: libb2 | libbb2, gone, libv (>= 1)\n'),
  paragraph('libbb2', '3', 'Depends: liba1\n'), paragraph('libc6', '2.36'), paragraph('real-v', '7', 'Provides: libv (= 7), w\n'),
  paragraph('libhead-dev', '5', 'Depends: compiler\n'), paragraph('compiler', '12'),
  'Package: gone\nStatus: deinstall ok config-files\nArchitecture: amd64\nVersion: 1\n',
].join('\n');

test('of alternatives and provided names, the installed package counts, and a removed one does not', () => {
  const installed = installedIn(STATUS);
  assert.deepEqual(neededOf('libb2 (>= 1) | libbb2, gone, libv, w, libc6:any (>= 2)', installed), ['libbb2', 'real-v', 'libc6']);
  assert.deepEqual(neededOf(undefined, installed), []);
});

test('packages that need each other are each listed once, with all that they need', () => {
  const {components, dependencies} = debianParts(['liba1'], installedIn(STATUS));
  assert.deepEqual(components.map(({name}) => name).sort(), ['liba1', 'libbb2', 'libc6', 'real-v']);
  assert.equal(components.find(({name}) => name === 'liba1').purl, 'pkg:deb/debian/liba1@1%3A2.0%2Bdeb12u1?arch=amd64');
  assert.equal(dependencies.find(({ref}) => ref.includes('/liba1@')).dependsOn.length, 3);
});

const LOCK = {packages: {
  '': {dependencies: {'@own/page': '^1', plain: '1'}},
  'node_modules/@own/page': {version: '1.2.3', integrity: `sha512-${Buffer.alloc(64, 7).toString('base64')}`, license: 'MIT', dependencies: {plain: '*'}},
  'node_modules/plain': {version: '4.5.6', integrity: `sha512-${Buffer.alloc(64, 9).toString('base64')}`, license: '(Apache-2.0 AND BSD-3-Clause)'},
  'node_modules/tool': {version: '1.0.0', dev: true, license: 'MIT'},
}};

test('of npm, only what is bundled is listed, with its hash', () => {
  const {components, dependencies, direct} = npmParts(LOCK);
  assert.deepEqual(components.map(({purl}) => purl), ['pkg:npm/%40own/page@1.2.3', 'pkg:npm/plain@4.5.6']);
  assert.equal(components[1].hashes[0].content, '09'.repeat(64));
  assert.deepEqual(direct, ['pkg:npm/%40own/page@1.2.3', 'pkg:npm/plain@4.5.6']);
  assert.deepEqual(dependencies[0].dependsOn, ['pkg:npm/plain@4.5.6']);
});

const own = (name, depends) => ({name, depends, version: '9.0', component: {type: 'application', 'bom-ref': `own:${name}`, name, version: '9.0'}});

test('the list names each part once, refers to nothing that it does not name, and is valid', () => {
  const bom = bomOf({own: [own('telepalp-server', 'liba1, telepalp-data (= 9.0)'), own('telepalp-data', '')],
    installed: installedIn(STATUS), headers: ['libhead-dev', 'absent-dev'], lock: LOCK, time: '2026-11-27T12:00:00Z'});
  assert.deepEqual(cyclonedxErrors(bom), []);
  const refs = new Set([bom.metadata.component, ...bom.components].map((one) => one['bom-ref']));
  assert.equal(refs.size, bom.components.length + 1);
  for (const {ref, dependsOn} of bom.dependencies) for (const one of [ref, ...dependsOn]) assert.ok(refs.has(one), one);
  assert.deepEqual(bom.components.map(({name}) => name).sort(),
    ['@own/page', 'liba1', 'libbb2', 'libc6', 'libhead-dev', 'plain', 'real-v', 'telepalp-data', 'telepalp-server']);
  assert.deepEqual(bom.dependencies.find(({ref}) => ref === 'own:telepalp-server').dependsOn.length, 4);
});

test('a list that is not valid is found', () => {
  const bom = bomOf({own: [own('a', '')], installed: new Map(), headers: [], lock: {packages: {'': {}}}, time: '2026-11-27T12:00:00Z'});
  assert.deepEqual(cyclonedxErrors(bom), []);
  assert.notDeepEqual(cyclonedxErrors({...bom, serialNumber: 'urn:uuid:none'}), []);
  assert.notDeepEqual(cyclonedxErrors({...bom, components: [{type: 'thing', name: 'a'}]}), []);
});

test('the program lists a package file with its hash, the same in each run', () => {
  mkdirSync(join(work, 'made/DEBIAN'), {recursive: true});
  writeFileSync(join(work, 'made/DEBIAN/control'),
    'Package: telepalp-tools\nVersion: 9.0\nArchitecture: amd64\nMaintainer: a <a@b>\nDepends: libc6\nDescription: a\n');
  execFileSync('dpkg-deb', ['--root-owner-group', '-b', join(work, 'made'), join(work, 'a.deb')]);
  const run = (...words) => spawnSync(join(sourceDir, 'deploy/sbom'), words, {encoding: 'utf8', env: {...process.env, SOURCE_DATE_EPOCH: '86400'}});
  const first = run(join(work, 'a.deb'));
  assert.equal(first.status, 0, first.stderr);
  const bom = JSON.parse(first.stdout);
  assert.deepEqual(cyclonedxErrors(bom), []);
  assert.equal(bom.metadata.timestamp, '1970-01-02T00:00:00Z');
  const hash = execFileSync('sha256sum', [join(work, 'a.deb')], {encoding: 'utf8'}).slice(0, 64);
  assert.equal(bom.components.find(({name}) => name === 'telepalp-tools').hashes[0].content, hash);
  assert.equal(run(join(work, 'a.deb'), '--out', join(work, 'out')).status, 0);
  assert.equal(readFileSync(join(work, 'out'), 'utf8'), first.stdout);
  for (const [words, status] of [[[], 2], [['--what'], 2], [['a.deb', '--out'], 2], [[join(work, 'none.deb')], 1]]) {
    const wrong = run(...words);
    assert.equal(wrong.status, status, words.join(' '));
    assert.match(wrong.stderr, /^error: deploy\/sbom: .+\. fix: /);
  }
});
