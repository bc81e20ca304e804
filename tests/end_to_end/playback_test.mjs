// node playback_test.mjs BIN_DIR VIEWER_FILES: a session is recorded, played by the server, and recorded again by the real
// programs. npm's @mcap/core reads both files: the compressed images must be the same bytes.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';
import {decoders, readIndexed} from '../npm/mcap_file.mjs';
import {createRequire} from 'node:module';
import {Workplace, until} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const {FoxgloveClient} = borrowed('@foxglove/ws-protocol');
const {WebSocket} = borrowed('ws');
const protobuf = borrowed('protobufjs');
const descriptor = borrowed('protobufjs/ext/descriptor');

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

const station = (port) => place.start(join(binDir, 'telepalp-station'), ['--connect', `127.0.0.1:${port}`]);

/** Hears the messages of one topic, decoded. */
function listen(http_port, wanted) {
  const client = new FoxgloveClient({
    ws: new WebSocket(`ws://127.0.0.1:${http_port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
  });
  const heard = {messages: [], close: () => client.close()};
  let type;
  client.on('advertise', (channels) => {
    for (const {id, topic, schema, schemaName} of channels) {
      if (topic !== wanted) continue;
      const set = descriptor.FileDescriptorSet.decode(Buffer.from(schema, 'base64'));
      type = protobuf.Root.fromDescriptor(set).lookupType(schemaName);
      client.subscribe(id);
    }
  });
  client.on('message', ({data}) => heard.messages.push(type.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength))));
  return heard;
}

before(async () => {
  const live = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--depth-mode', 'temporal']);
  const doctor = station(live.port);
  const states = listen(live.http_port, '/station/state');
  await until('the station publishes', () => states.messages.length > 0);
  states.close();
  await record(live.port, first, 3);
  for (const {child} of [{child: doctor}, live]) {
    child.kill('SIGTERM');
    await child.over;
  }
  played = await place.server(join(binDir, 'telepalp-server'), ['--viewer', viewer, '--source', `session:${first}`]);
  await record(played.port, again, 3);
});
after(() => place.end());

test('the played images are the recorded bytes in the recorded order', async () => {
  const recorded = (await messagesOf(first, '/camera/depth')).map((image) => Buffer.from(image.data).toString('base64'));
  const repeated = (await messagesOf(again, '/camera/depth')).map((image) => Buffer.from(image.data).toString('base64'));
  assert.ok(repeated.length > 20, `${repeated.length} images`);  // of 3 s; a busy machine plays fewer
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

/** A client of the WebSocket's capability "playbackControl". */
async function controller() {
  const socket = new WebSocket(`ws://127.0.0.1:${played.http_port}/`, ['foxglove.sdk.v1']);
  const heard = {info: undefined, states: []};
  socket.on('message', (data, isBinary) => {
    if (!isBinary && heard.info === undefined) heard.info = JSON.parse(data);
    if (isBinary && data[0] === 5)
      heard.states.push({
        status: data[1], time_ns: data.readBigUInt64LE(2), speed: data.readFloatLE(10), didSeek: data[14] === 1,
        id: data.subarray(19).toString(),
      });
  });
  await until('the server introduces itself', () => heard.info !== undefined);
  const ask = (command, speed, seek_ns, id) => {
    const request = Buffer.alloc(19 + id.length);
    request.writeUInt8(3, 0);
    request.writeUInt8(command, 1);
    request.writeFloatLE(speed, 2);
    request.writeUInt8(seek_ns === undefined ? 0 : 1, 6);
    request.writeBigUInt64LE(seek_ns ?? 0n, 7);
    request.writeUInt32LE(id.length, 15);
    request.write(id, 19);
    socket.send(request);
  };
  return {socket, heard, ask};
}

test('the playback control of the WebSocket pauses, seeks and sets the speed', async () => {
  const {socket, heard, ask} = await controller();
  try {
    assert.ok(heard.info.capabilities.includes('playbackControl'));
    const {sec, nsec} = heard.info.dataStartTime;
    const begin_ns = BigInt(sec) * 1_000_000_000n + BigInt(nsec);
    const wanted_ns = begin_ns + 1_250_000_000n;
    ask(1, 0.5, wanted_ns, 'pause-there');
    await until('the request is answered', () => heard.states.some(({id}) => id === 'pause-there'));
    const {id, ...answer} = heard.states.find((one) => one.id === 'pause-there');
    assert.deepEqual(answer, {status: 1, time_ns: wanted_ns, speed: 0.5, didSeek: true});
    await until('it is paused there', async () => {
      const now = await state();
      return !now.playing && Math.abs(now.position_s - 1.25) < 1e-6 && now.speed === 0.5;
    });
    await until('the state is told again each second', () => heard.states.filter((one) => one.id === '').length > 2);
    const before = heard.states.length;
    ask(0, 99, undefined, 'too-fast');
    ask(0, 1, undefined, 'play-on');
    await until('it plays', async () => (await state()).playing);
    await until('the second is answered', () => heard.states.some((one) => one.id === 'play-on'));
    assert.ok(!heard.states.some((one) => one.id === 'too-fast'), 'a wrong speed is refused');
    assert.ok(heard.states.length > before);
  } finally {
    socket.close();
  }
});

test('who comes while the session is paused sees the picture', async () => {
  assert.equal((await ask({play: false, seek_s: 0})).status, 200);
  await until('it is paused', async () => !(await state()).playing);
  const depth = listen(played.http_port, '/camera/depth');
  await until('the picture comes', () => depth.messages.length > 0);
  depth.close();
});

test('the recorded station is felt again, and is withheld while a live one sits on the recording', async () => {
  assert.equal((await ask({play: true, seek_s: 0, speed: 1})).status, 200);
  const states = listen(played.http_port, '/station/state');
  const [{sender: doctor_then}] = await messagesOf(first, '/station/state');
  const of = (isRecorded) => states.messages.filter(({sender}) => (sender === doctor_then + 1000) === isRecorded).length;
  await until('the recorded station is heard', () => of(true) > 10);
  assert.equal(of(false), 0);
  const doctor = station(played.port);
  await until('the live station is heard', () => of(false) > 0);
  states.messages.length = 0;
  await until('it is heard for a while', () => of(false) > 50);
  assert.equal(of(true), 0);
  doctor.kill('SIGTERM');
  await doctor.over;
  await until('the recorded station is back', () => of(true) > 10);
  states.close();
});

test('wrong commands and foreign pages are refused', async () => {
  assert.equal((await ask({speed: 99})).status, 400);
  assert.equal((await ask({faster: true})).status, 400);
  assert.equal((await ask({seek_s: 1e6})).status, 400);
  assert.equal((await ask({play: false}, {origin: 'http://evil.example'})).status, 403);
  assert.match((await ask({speed: 99})).text, /speed is not from 0.1 to 10/);
});
