// The types that message_types.mjs writes are those of the values that the decoder gives:
// node message_types_test.mjs VIEWER_WORK PROTOC
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {pathToFileURL} from 'node:url';

const [work, protoc] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), 'message-types-'));
after(() => rmSync(scratch, {recursive: true, force: true}));
const library = (file) => import(pathToFileURL(join(work, 'node_modules/@bufbuild/protobuf/dist/esm', file)));

function generate(...bodies) {
  const files = bodies.map((body, at) => {
    const name = `fixture${at}.proto`;
    writeFileSync(join(scratch, name), `syntax = "proto3";\npackage telepalp.fixture${at};\n${body}`);
    return name;
  });
  const [set, out] = [join(scratch, 'set.binpb'), join(scratch, 'types.ts')];
  execFileSync(protoc, ['-I', scratch, '--include_imports', `--descriptor_set_out=${set}`, ...files]);
  const {status, stderr} = spawnSync('node', [join(work, 'message_types.mjs'), set, out], {encoding: 'utf8'});
  return {status, stderr, set, text: status === 0 ? readFileSync(out, 'utf8') : ''};
}

const BODY = `
enum Colour { COLOUR_NONE = 0; COLOUR_DARK_RED = 7; }
message Outer {
  message Inner { sint64 at = 1; }
  double force_N = 1;
  fixed64 stamp_ns = 2;
  bytes jpeg = 3;
  Inner inner = 4;
  repeated Inner many = 5;
  optional uint32 maybe = 6;
  Colour colour = 7;
  repeated double K = 8;
  bool by_datagram = 9;
  string name = 10;
}`;

test('each kind of field gets the type of its decoded value', async () => {
  const {set, text, stderr} = generate(BODY);
  const fields = Object.fromEntries([...text.matchAll(/^  (\w+\??): (.*);$/gm)].map(([, name, type]) => [name, type]));
  assert.deepEqual(fields, {
    'at': 'bigint', 'forceN': 'number', 'stampNs': 'bigint', 'jpeg': 'Uint8Array', 'inner?': 'Outer_Inner', 'many': 'Outer_Inner[]',
    'maybe?': 'number', 'colour': 'Colour', 'K': 'number[]', 'byDatagram': 'boolean', 'name': 'string',
  }, stderr);
  assert.match(text, /export enum Colour \{\n  NONE = 0,\n  DARK_RED = 7,\n\}/);

  const {createFileRegistry, fromBinary, create} = await library('index.js');
  const {FileDescriptorSetSchema} = await library('wkt/index.js');
  const message = create(createFileRegistry(fromBinary(FileDescriptorSetSchema, readFileSync(set))).getMessage('telepalp.fixture0.Outer'));
  for (const [name, type] of Object.entries(fields).filter(([one]) => one !== 'at')) {
    const value = message[name.replace('?', '')];
    const kind = Array.isArray(value) ? 'array' : value instanceof Uint8Array ? 'Uint8Array' : typeof value;
    const expected = name.endsWith('?') ? 'undefined' : type.endsWith('[]') ? 'array' : type === 'Colour' ? 'number' : type;
    assert.equal(kind, expected, name);
  }
});

test('what the types could not express is refused', () => {
  assert.match(generate('message A { oneof kind { bool b = 1; bool c = 2; } }').stderr, /telepalp\.fixture0\.A\.b: .* oneof/);
  assert.match(generate('message A { map<string, bool> m = 1; }').stderr, /neither a oneof nor a map/);
  assert.match(generate('message A { bool a = 1; }', 'message A { bool a = 1; }').stderr, /two messages are called A/);
});

test('a renamed field of a message fails the type check of the page', () => {
  const copy = join(scratch, 'page');
  mkdirSync(copy);
  for (const part of ['src', 'tsconfig.json']) execFileSync('cp', ['-r', join(work, part), copy]);
  execFileSync('ln', ['-s', join(work, 'node_modules'), copy]);
  const types = join(copy, 'src/messages/generated.ts');
  writeFileSync(types, readFileSync(types, 'utf8').replace('  indentationM: number;', '  depthM: number;'));
  const {status, stdout} = spawnSync('node', [join(copy, 'node_modules/typescript/bin/tsc'), '--noEmit'], {cwd: copy, encoding: 'utf8'});
  assert.notEqual(status, 0);
  assert.match(stdout, /Property 'indentationM' does not exist on type 'StationState'/);
});
