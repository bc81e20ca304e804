// Foxglove's client, which hears the station and may hold a hand.
import {createRequire} from 'node:module';

import {until} from './running_program.mjs';

const borrowed = createRequire(new URL('../npm/package.json', import.meta.url));
const {FoxgloveClient} = borrowed('@foxglove/ws-protocol');
const {WebSocket} = borrowed('ws');
const protobuf = borrowed('protobufjs');
const descriptor = borrowed('protobufjs/ext/descriptor');

/** `heard`: what the server has sent so far; `sendHand`, `letGo`: the client's own hand. */
export async function connect(port) {
  const client = new FoxgloveClient({
    ws: new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
  });
  const heard = {channels: [], info: undefined, warnings: [], phase: undefined, states: [], hands: [], holder: undefined};
  client.on('serverInfo', (info) => (heard.info = info));
  client.on('advertise', (channels) => heard.channels.push(...channels));
  client.on('status', ({message}) => heard.warnings.push(message));
  await until('the topics are advertised', () => heard.channels.length > 0);
  const channel = (topic) => heard.channels.find((one) => one.topic === topic);
  const type = (topic) => {
    const {schema, schemaName} = channel(topic);
    const set = descriptor.FileDescriptorSet.decode(Buffer.from(schema, 'base64'));
    return protobuf.Root.fromDescriptor(set).lookupType(schemaName);
  };
  const take = {
    '/station/state': (state) => {
      heard.phase = state.phase;
      heard.states.push(state);
    },
    '/viewer/hand': (hand) => heard.hands.push(hand),
    '/viewer/hand_holder': (holder) => (heard.holder = holder),
  };
  const subscriptions = new Map(Object.keys(take).map((topic) =>
    [client.subscribe(channel(topic).id), {topic, type: type(topic)}]));
  client.on('message', ({subscriptionId, data}) => {
    const {topic, type: message} = subscriptions.get(subscriptionId);
    take[topic](message.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength)));
  });
  const id = client.advertise({topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'});
  const hands = type('/viewer/hand');
  const sendHand = (x, y, z, extra = {}) => client.sendMessage(id, hands.encode(hands.fromObject({
    sampled_us: Math.round(1000 * performance.now()), hand_camera: {x, y, z}, ...extra,
  })).finish());
  const letGo = () => client.sendMessage(id, hands.encode(hands.fromObject({let_go: true})).finish());
  return {client, heard, sendHand, letGo, id, number: Number(heard.info.metadata.viewer)};
}
