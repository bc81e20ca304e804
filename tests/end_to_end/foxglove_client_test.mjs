// The real server, heard by Foxglove's own client: node foxglove_client_test.mjs SERVER VIEWER_DIR
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import test from 'node:test';

import {until, Workplace} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const {FoxgloveClient} = borrowed('@foxglove/ws-protocol');
const {WebSocket} = borrowed('ws');
const protobuf = borrowed('protobufjs');
const descriptor = borrowed('protobufjs/ext/descriptor');
const [server, viewer] = process.argv.slice(2);

/** The type that a channel's own schema declares. */
function typeOf({schema, schemaName}) {
  const set = descriptor.FileDescriptorSet.decode(Buffer.from(schema, 'base64'));
  return protobuf.Root.fromDescriptor(set).lookupType(schemaName);
}

function connect(port) {
  const client = new FoxgloveClient({
    ws: new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
  });
  const heard = {channels: [], messages: [], info: undefined, problems: []};
  client.on('serverInfo', (info) => (heard.info = info));
  client.on('advertise', (channels) => heard.channels.push(...channels));
  client.on('message', (message) => heard.messages.push(message));
  client.on('error', (problem) => heard.problems.push(problem));
  return {client, heard};
}

test('Foxglove\'s client hears every topic and decodes camera frames with the schemas that come along', async () => {
  const workplace = new Workplace('foxglove');
  try {
    const {http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer]);
    const {client, heard} = connect(http_port);
    await until('the topics are advertised', () => heard.channels.length > 0);
    assert.equal(heard.info.name, 'telepalp-server');
    const names = heard.channels.map((channel) => channel.topic);
    for (const topic of ['/camera/depth', '/camera/color', '/camera/info', '/station/state', '/clock'])
      assert.ok(names.includes(topic), topic);
    for (const channel of heard.channels) assert.equal(typeOf(channel).name, channel.schemaName.split('.').pop());

    const depth = heard.channels.find((channel) => channel.topic === '/camera/depth');
    const subscription = client.subscribe(depth.id);
    await until('frames come', () => heard.messages.length >= 10);
    const type = typeOf(depth);
    let last = -1;
    for (const {subscriptionId, timestamp, data} of heard.messages) {
      assert.equal(subscriptionId, subscription);
      const frame = type.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
      assert.equal(Buffer.from(frame.data.subarray(0, 3)).toString(), 'TPD');
      assert.ok(Number(frame.sequence) > last, 'frames come in order');
      last = Number(frame.sequence);
      assert.ok(timestamp >= BigInt(frame.captured_ns.toString()), 'a frame is published after it was captured');
    }

    client.unsubscribe(subscription);
    await until('the stream stops', async () => {
      const before = heard.messages.length;
      await new Promise((wake) => setTimeout(wake, 500));
      return heard.messages.length === before;
    });
    assert.deepEqual(heard.problems, []);
    client.close();
  } finally {
    await workplace.end();
  }
});

test('an unbuilt viewer and a port in use are said with how to fix them, and the server leaves with 1', async () => {
  const workplace = new Workplace('foxglove_wrong');
  try {
    const {http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer]);
    for (const args of [['--http-port', '0', '--viewer', workplace.folder], ['--http-port', String(http_port), '--viewer', viewer]]) {
      const child = workplace.start(server, ['--port', '0', ...args]);
      assert.equal(await child.over, 1, child.heard);
      assert.match(child.heard, /^error: .*fix: /m);
    }
  } finally {
    await workplace.end();
  }
});
