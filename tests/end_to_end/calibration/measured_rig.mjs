// node measured_rig.mjs: a haptic device (haptic_station/device/protocol/UDP_DEVICE.md) and a Leap Motion service, with
// a hand that lies on the end-effector. The tracker stands at HAPTIC_FROM_TRACKER_M with the axes of S1 eq. (4). Prints
// `udp=PORT leap=PORT`. On stdin: `go X Y Z` carries hand and end-effector there [m] and prints `there`; `slip on` moves
// the hand to and fro on the end-effector, `slip off` ends it. Positions follow the messages that are sent, not the
// clock, so that a slow machine sees no jumps.
import {createSocket} from 'node:dgram';
import {createRequire} from 'node:module';
import {createInterface} from 'node:readline';
import {pathToFileURL} from 'node:url';

export const HAPTIC_FROM_TRACKER_M = [0.03, 0.31, -0.02];
const POSE_BYTES = 80;
const COMMAND_BYTES = 108;
const COMMANDS_FOR_A_POSE = 4;  // 500 poses a second
const STEP_M = 0.0002;          // from pose to pose: 0.1 m/s
const NOISE_M = 0.0003;
const SLIP_M = 0.012;

function adler32(bytes) {
  let [a, b] = [1, 0];
  for (const byte of bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return ((b << 16) | a) >>> 0;
}

function poseOf(sequence, command, at) {
  const pose = Buffer.alloc(POSE_BYTES);
  pose.write('TTPU');
  pose.writeUInt16LE(1, 4);
  pose.writeUInt32LE(4711, 8);
  pose.writeUInt32LE(sequence, 12);
  pose.writeBigUInt64LE(process.hrtime.bigint() / 1000n, 16);
  pose.writeUInt32LE(command.readUInt32LE(12), 24);
  at.forEach((value, axis) => pose.writeDoubleLE(value, 28 + 8 * axis));
  pose.writeUInt32LE(adler32(pose.subarray(0, POSE_BYTES - 4)), POSE_BYTES - 4);
  return pose;
}

function run() {
  const {WebSocketServer} = createRequire(new URL('../../npm/package.json', import.meta.url))('ws');
  let [at, to, slips, commands, frames] = [[0, 0.05, 0], [0, 0.05, 0], false, 0, 0];

  const device = createSocket('udp4');
  device.on('message', (command, from) => {
    if (command.length !== COMMAND_BYTES || ++commands % COMMANDS_FOR_A_POSE !== 0) return;
    const way = to.map((value, axis) => value - at[axis]);
    const far_m = Math.hypot(...way);
    const share = far_m > STEP_M ? STEP_M / far_m : 1;
    at = at.map((value, axis) => value + share * way[axis]);
    if (far_m > 0 && share === 1) console.log('there');
    device.send(poseOf(commands, command, at), from.port, from.address);
  });

  /** The palm in the tracker's frame [mm], with the noise of a tracker. */
  function palm() {
    const noise = NOISE_M * Math.sin(2.4 * frames);
    const slip = slips ? SLIP_M * Math.sin(0.25 * frames) : 0;
    const [x, y, z] = at.map((value, axis) => value - HAPTIC_FROM_TRACKER_M[axis]);
    return [x + slip, -y + noise, -z].map((value) => 1000 * value);
  }
  const leap = new WebSocketServer({host: '127.0.0.1', port: 0}, () =>
    device.bind(0, '127.0.0.1', () => console.log(`udp=${device.address().port} leap=${leap.address().port}`)));
  leap.on('connection', (station) => {
    station.send(JSON.stringify({version: 6, serviceVersion: '2.3.1'}));
    const beat = setInterval(() => {
      ++frames;
      const hand = {id: 1, palmPosition: palm(), palmVelocity: [0, 0, 0], confidence: 1, palmNormal: [0, -1, 0], direction: [0, 0, -1]};
      station.send(JSON.stringify({timestamp: Number(process.hrtime.bigint() / 1000n), hands: [hand]}));
    }, 10);
    station.on('close', () => clearInterval(beat));
  });

  createInterface(process.stdin).on('line', (line) => {
    const [word, ...rest] = line.split(' ');
    if (word === 'go') to = rest.map(Number);
    if (word === 'slip') slips = rest[0] === 'on';
  });
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) run();
