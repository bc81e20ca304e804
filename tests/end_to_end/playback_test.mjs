// node playback_test.mjs BIN_DIR VIEWER_FILES: a session is recorded, played by the server, and recorded again by the real
// programs. npm's @mcap/core reads both files: the compressed images must be the same bytes.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';
import {decoders, readIndexed} from '../npm/mcap_file.mjs';
import {Workplace, until} from './running_program.mjs';

const [binDir, viewer] = process.argv.slice(2);
const place = new Workplace('playback');
const first = join(place.folder, 'first.mcap');
const again = join(place.folder, 'again.mcap');
let played;  // the server that plays

const run = promisify(execFile);
const record = (port, file, seconds) =>
  run(join(binDir, 'telepalp-record'), ['--connect', `127.0.0.1:${port}`, '--out', file, '--seconds', String(seconds)]);

/** The decoded messages of one topic. */
async function messagesOf(file, topic) {
  const {reader, messages} = await readIndexed(file);
  const decode = decoders(reader.schemasById);
  return messages
    .filter((message) => reader.channelsById.get(message.channelId).topic === topic)
    .map((message) => decode.get(reader.channelsById.get(message.channelId).schemaId)(message.data));
}

const ask = async (body, headers = {}) => {
  const options = body === undefined ? {headers} : {method: 'POST', body: JSON.stringify(body), headers};
  const reply = await fetch(`http://127.0.0.1:${played.http_port}/playback`, options);
  return {status: reply.status, text: await reply.text()};
};
const state = async () => JSON.parse((await ask()).text);

before(async () => {
  const live = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--depth-mode', 'temporal']);
  await record(live.port, first, 3);
  live.child.kill('SIGTERM');
  await live.child.over;
  played = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--source', `session:${first}`]);
  await record(played.port, again, 3);
});
after(() => place.end());

test('the played images are the recorded bytes in the recorded order', async () => {
  const recorded = (await messagesOf(first, '/camera/depth')).map((image) => Buffer.from(image.data).toString('base64'));
  const repeated = (await messagesOf(again, '/camera/depth')).map((image) => Buffer.from(image.data).toString('base64'));
  assert.ok(repeated.length > 40, `${repeated.length} images`);
  const start = recorded.indexOf(repeated[0]);
  assert.ok(start >= 0, 'the first played image was recorded');
  repeated.forEach((image, number) => assert.ok(image === recorded[(start + number) % recorded.length], `image ${number}`));
});

test('the instants of an image are mapped together, so that its ages are kept', async () => {
  const recorded = new Map((await messagesOf(first, '/camera/depth')).map((image) => [String(image.sequence), image]));
  for (const image of await messagesOf(again, '/camera/depth')) {
    const before = recorded.get(String(image.sequence));
    const age = ({captured_ns, encoded_ns}) => BigInt(encoded_ns.toString()) - BigInt(captured_ns.toString());
    assert.equal(age(image), age(before));
    assert.ok(BigInt(image.captured_ns.toString()) > BigInt(before.captured_ns.toString()), 'it is of now');
  }
});

test('a command pauses, seeks, changes the speed and goes on', async () => {
  assert.equal((await ask({play: false, seek_s: 1.5})).status, 200);
  await until('it is paused at 1.5 s', async () => !(await state()).playing && (await state()).position_s === 1.5);
  assert.equal((await ask({play: true, speed: 10, loop: true})).status, 200);
  await until('it plays on', async () => (await state()).playing && (await state()).position_s !== 1.5);
  assert.equal((await state()).speed, 10);
});

test('wrong commands and foreign pages are refused', async () => {
  assert.equal((await ask({speed: 99})).status, 400);
  assert.equal((await ask({faster: true})).status, 400);
  assert.equal((await ask({seek_s: 1e6})).status, 400);
  assert.equal((await ask({play: false}, {origin: 'http://evil.example'})).status, 403);
  assert.match((await ask({speed: 99})).text, /speed is not from 0.1 to 10/);
});
