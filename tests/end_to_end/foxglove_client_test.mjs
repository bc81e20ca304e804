// The real server, heard by Foxglove's own client: node foxglove_client_test.mjs SERVER VIEWER_DIR
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import test from 'node:test';
import {fileURLToPath} from 'node:url';

import {fieldOf, layout, pathsOfLayout} from '../npm/lichtblick_layout.mjs';
import {until, Workplace} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const {FoxgloveClient} = borrowed('@foxglove/ws-protocol');
const {WebSocket} = borrowed('ws');
const protobuf = borrowed('protobufjs');
const descriptor = borrowed('protobufjs/ext/descriptor');
const [server, station, viewer] = process.argv.slice(2);

/** The type that a channel's own schema declares. */
function typeOf({schema, schemaName}) {
  const set = descriptor.FileDescriptorSet.decode(Buffer.from(schema, 'base64'));
  return protobuf.Root.fromDescriptor(set).lookupType(schemaName);
}

function connect(port, origin) {
  return listen(new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL], {origin}));
}

function listen(ws) {
  const client = new FoxgloveClient({ws});
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

/** The HTTP status of an upgrade request from a page of `origin`; 101 if it is accepted. */
const upgradeStatus = (port, origin) => new Promise((resolve) => {
  const socket = new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL], {origin});
  socket.once('unexpected-response', (_, {statusCode}) => resolve(statusCode));
  socket.once('open', () => (resolve(101), socket.close()));
  socket.on('error', () => undefined);
});

/** The newest message of each topic in `topics`, decoded by its own schema. */
function follow({client, heard}, topics) {
  const newest = {};
  const count = {};
  const byId = new Map(topics.map((topic) => {
    const channel = heard.channels.find((one) => one.topic === topic);
    assert.ok(channel, topic);
    return [client.subscribe(channel.id), {topic, type: typeOf(channel)}];
  }));
  client.on('message', ({subscriptionId, data}) => {
    const {topic, type} = byId.get(subscriptionId) ?? {};
    if (topic === undefined) return;
    newest[topic] = type.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    count[topic] = (count[topic] ?? 0) + 1;
  });
  return {newest, count, unsubscribe: () => [...byId.keys()].forEach((id) => client.unsubscribe(id))};
}

const viewsAtWork = ({subscribers}) => subscribers.some(({name}) => name === 'views for Foxglove');

test('the layout for Lichtblick names topics and fields that the server has, and panels that it places', async () => {
  const workplace = new Workplace('foxglove_layout');
  try {
    const {http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer]);
    const {client, heard} = connect(http_port);
    await until('the topics are advertised', () => heard.channels.length > 0);
    const paths = pathsOfLayout();
    assert.ok(paths.length > 10, `${paths.length} paths`);
    for (const path of paths) {
      const [topic, ...fields] = path.split('.');
      const channel = heard.channels.find((one) => one.topic === topic);
      assert.ok(channel, `${topic} is advertised`);
      fieldOf(typeOf(channel), fields);
    }
    const placed = JSON.stringify(layout.layout);
    for (const panel of Object.keys(layout.configById)) assert.ok(placed.includes(JSON.stringify(panel)), panel);
    client.close();
  } finally {
    await workplace.end();
  }
});

test('a page of an allowed origin sees patient and hand by Foxglove\'s own types, made only while it looks', async () => {
  const workplace = new Workplace('foxglove_views');
  try {
    const allowed = 'https://studio.example';
    const {port, http_port} = await workplace.server(server, [
      '--source', 'synthetic', '--viewer', viewer, '--allow-origin', 'http://localhost:3000', '--allow-origin', allowed]);
    assert.equal(await upgradeStatus(http_port, 'https://evil.example'), 403);
    assert.equal(await upgradeStatus(http_port, allowed), 101);
    const child = workplace.start(station, ['--connect', `127.0.0.1:${port}`]);
    const page = connect(http_port, allowed);
    await until('the topics are advertised', () => page.heard.channels.length > 0);
    const stats = follow(page, ['/server/stats']);
    await until('the statistics come', () => stats.newest['/server/stats'] !== undefined);
    assert.ok(!viewsAtWork(stats.newest['/server/stats']), 'nobody looks, nothing is made');

    const types = {
      '/camera/color': 'CompressedImage', '/camera/depth/image': 'RawImage', '/camera/points': 'PointCloud',
      '/transforms': 'FrameTransforms', '/station/scene': 'SceneUpdate', '/camera/info': 'CameraCalibration',
      '/camera/color/info': 'CameraCalibration', '/station/hand': 'PoseInFrame', '/station/phase': 'KeyValuePair',
    };
    for (const [topic, type] of Object.entries(types))
      assert.equal(page.heard.channels.find((one) => one.topic === topic)?.schemaName, `foxglove.${type}`, topic);
    const seen = follow(page, Object.keys(types));
    await until('each type comes', () => Object.keys(types).every((topic) => (seen.count[topic] ?? 0) >= 2));
    await until('the hand is drawn', () => seen.newest['/station/scene'].entities.some(({id}) => id === 'hand'));

    const {newest} = seen;
    assert.equal(newest['/camera/color'].format, 'jpeg');
    assert.deepEqual([...newest['/camera/color'].data.subarray(0, 2)], [0xff, 0xd8]);
    for (const topic of ['/camera/info', '/camera/color/info']) {
      assert.equal(newest[topic].K.length, 9, topic);
      assert.ok(newest[topic].K[0] > 100 && newest[topic].width > 0, topic);
    }
    assert.equal(newest['/camera/color/info'].frame_id, newest['/camera/color'].frame_id);

    const image = newest['/camera/depth/image'];
    assert.deepEqual([image.encoding, image.step, image.data.length],
        ['16UC1', 2 * image.width, 2 * image.width * image.height]);
    const depths_mm = Array.from({length: image.width * image.height},
        (_, pixel) => image.data[2 * pixel] + 256 * image.data[2 * pixel + 1]).filter((depth) => depth > 0);
    assert.ok(depths_mm.length > 1000);
    const middle_mm = depths_mm.sort((a, b) => a - b)[depths_mm.length >> 1];
    assert.ok(middle_mm > 300 && middle_mm < 3000, `depth of ${middle_mm} mm`);

    const cloud = newest['/camera/points'];
    assert.deepEqual(cloud.fields.map(({name}) => name), ['x', 'y', 'z', 'red', 'green', 'blue', 'alpha']);
    assert.equal(cloud.data.length % cloud.point_stride, 0);
    assert.ok(Math.abs(cloud.data.length / cloud.point_stride - depths_mm.length) < 0.1 * depths_mm.length);
    const bytes = new DataView(cloud.data.buffer, cloud.data.byteOffset, cloud.data.byteLength);
    const zs = Array.from({length: cloud.data.length / cloud.point_stride},
        (_, point) => bytes.getFloat32(point * cloud.point_stride + 8, true)).sort((a, b) => a - b);
    const colors = new Set(Array.from({length: cloud.data.length / cloud.point_stride}, (_, point) =>
        cloud.data.subarray(point * cloud.point_stride + 12, point * cloud.point_stride + 16).join()));
    assert.ok(colors.size > 100, `a cloud of ${colors.size} colours`);
    assert.ok([...colors].every((rgba) => rgba.endsWith(',255')), 'each point is opaque');
    assert.ok(Math.abs(1000 * zs[zs.length >> 1] - middle_mm) < 20, 'image and cloud are of one patient');

    const frames = newest['/transforms'].transforms.map(({parent_frame_id, child_frame_id}) => [parent_frame_id, child_frame_id]);
    assert.ok(frames.some(([parent, child]) => parent === 'patient_site' && child === cloud.frame_id));
    const {entities} = newest['/station/scene'];
    assert.ok(entities.every(({frame_id}) => frame_id === cloud.frame_id));
    const hand = entities.find(({id}) => id === 'hand').spheres[0].pose.position;
    assert.ok(hand.z > 0.2 && hand.z < 3, 'the hand is before the camera');
    const {frame_id, pose} = newest['/station/hand'];
    assert.equal(frame_id, cloud.frame_id);
    assert.ok(Math.hypot(pose.position.x - hand.x, pose.position.y - hand.y, pose.position.z - hand.z) < 0.1, 'one hand');
    const {x, y, z, w} = pose.orientation;
    assert.ok(Math.abs(Math.hypot(x, y, z, w) - 1) < 1e-6);
    await until('the force is an arrow', () =>
      newest['/station/scene'].entities.some(({id, arrows}) => id === 'force' && arrows[0].shaft_length > 0));

    await until('the views are counted', () => viewsAtWork(stats.newest['/server/stats']));
    seen.unsubscribe();
    await until('nothing is made any more', () => !viewsAtWork(stats.newest['/server/stats']));
    assert.deepEqual(page.heard.problems, []);
    assert.equal(child.exitCode, null, child.heard);
    page.client.close();
  } finally {
    await workplace.end();
  }
});

/** A scene with an ultrasound probe and layers below the skin. */
const RIBS = fileURLToPath(new URL('../../haptic_station/scenes/ribs-ultrasound.scene.textproto', import.meta.url));

/** Topics with messages only on occasions: while a viewer holds or asks for the hand, at events of the station, and when somebody marks a moment. */
const ON_OCCASION = ['/viewer/hand', '/viewer/hand_holder', '/station/events', '/session/notes', '/station/window',
  '/camera/depth/window', '/patient/voice', '/doctor/voice'];

test('each advertised topic is received by a page of an allowed origin, and decoded by the schema that comes along', async () => {
  const workplace = new Workplace('foxglove_topics');
  try {
    const origin = 'https://studio.example';
    const {port, http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer, '--allow-origin', origin]);
    workplace.start(station, ['--connect', `127.0.0.1:${port}`, '--scene', RIBS]);  // a scene for each topic
    const page = connect(http_port, origin);
    await until('the topics are advertised', () => page.heard.channels.length > 0);
    const topics = page.heard.channels.map(({topic}) => topic);
    const seen = follow(page, topics);
    const missing = () => topics.filter((topic) => !ON_OCCASION.includes(topic) && seen.newest[topic] === undefined);
    await until('each topic comes', () => missing().length === 0, 120_000)
        .catch((problem) => { throw new Error(`${problem.message}: ${missing().join(', ')}`); });
    for (const [topic, message] of Object.entries(seen.newest)) {
      const type = typeOf(page.heard.channels.find((one) => one.topic === topic));
      assert.equal(type.verify(message), null, topic);
      if (topic !== '/marks') assert.ok(Object.keys(type.toObject(message)).length > 0, `${topic} is empty`);  // no mark yet
    }
    assert.deepEqual(page.heard.problems, []);
    page.client.close();
  } finally {
    await workplace.end();
  }
});

test('the ribs are triangles in frames that move with them, also for a client that comes later', async () => {
  const workplace = new Workplace('foxglove_inside');
  try {
    const origin = 'https://studio.example';
    const {port, http_port} = await workplace.server(server, ['--source', 'synthetic', '--viewer', viewer, '--allow-origin', origin]);
    workplace.start(station, ['--connect', `127.0.0.1:${port}`, '--scene', RIBS]);
    const looks = async () => {
      const page = connect(http_port, origin);
      await until('the topics are advertised', () => page.heard.channels.length > 0);
      assert.equal(page.heard.channels.find(({topic}) => topic === '/station/inside/scene')?.schemaName, 'foxglove.SceneUpdate');
      const {newest} = follow(page, ['/station/inside/scene', '/transforms']);
      await until('the layers come', () => newest['/station/inside/scene']?.entities.length > 0, 120_000);
      const {entities} = newest['/station/inside/scene'];
      const frame = entities.find(({id}) => id.includes('rib'))?.frame_id;
      assert.ok(frame, entities.map(({id}) => id).join());
      await until('the layer has its place', () =>
        newest['/transforms']?.transforms.some(({child_frame_id}) => child_frame_id === frame));
      for (const {triangles, frame_locked} of entities) {
        assert.ok(frame_locked);
        const [{points, indices}] = triangles;
        assert.ok(points.length > 100 && indices.length % 3 === 0);
        assert.ok(indices.every((index) => index < points.length));
        const width_m = Math.max(...points.map(({x}) => x)) - Math.min(...points.map(({x}) => x));
        assert.ok(width_m > 0.005 && width_m < 1, `a layer of ${width_m} m`);
      }
      assert.deepEqual(page.heard.problems, []);
      page.client.close();
    };
    await looks();
    await looks();
  } finally {
    await workplace.end();
  }
});

test('at a server with keys, Foxglove\'s client comes over TLS from an allowed origin, with its token in the address', async () => {
  const workplace = new Workplace('foxglove_keys');
  try {
    const dir = join(workplace.folder, 'keys');
    const keys = (...words) => execFileSync(join(dirname(server), 'telepalp-keys'), [...words, '--dir', dir]);
    keys('authority', '--host', '127.0.0.1');
    keys('server', '--host', '127.0.0.1');
    keys('token', '--name', 'vera', '--role', 'viewer');
    const token = /^token: (.*)$/m.exec(readFileSync(join(dir, 'vera.token'), 'utf8'))[1];
    const origin = 'https://studio.example';
    const {http_port} = await workplace.server(server,
      ['--source', 'synthetic', '--viewer', viewer, '--key', join(dir, 'server.key'), '--allow-origin', origin]);
    const ca = readFileSync(join(dir, 'authority.crt'));
    const open = (query) => new WebSocket(`wss://127.0.0.1:${http_port}/${query}`,
      [FoxgloveClient.SUPPORTED_SUBPROTOCOL], {origin, ca});
    const status = (socket) => new Promise((resolve) => {
      socket.once('unexpected-response', (_, {statusCode}) => resolve(statusCode));
      socket.on('error', () => undefined);
    });
    assert.equal(await status(open('')), 401);
    assert.equal(await status(open('?token=tp1.guess.guess')), 401);
    const page = listen(open(`?token=${token}`));
    await until('the topics are advertised', () => page.heard.channels.length > 0);
    const seen = follow(page, ['/camera/color', '/camera/points', '/camera/depth/image']);
    await until('the patient is seen', () => (seen.count['/camera/points'] ?? 0) >= 3 && (seen.count['/camera/color'] ?? 0) >= 3);
    assert.deepEqual([...seen.newest['/camera/color'].data.subarray(0, 2)], [0xff, 0xd8]);
    assert.deepEqual(page.heard.problems, []);
    page.client.close();
  } finally {
    await workplace.end();
  }
});

test('an origin that is no exact one is refused with how to fix it', async () => {
  const workplace = new Workplace('foxglove_origin');
  try {
    for (const origin of ['*', 'null', 'https://a.example/', 'a.example']) {
      const child = workplace.start(server, ['--port', '0', '--http-port', '0', '--viewer', viewer, '--allow-origin', origin]);
      assert.equal(await child.over, 2, child.heard);
      assert.match(child.heard, /^error: .*--allow-origin.*fix: /m);
    }
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
