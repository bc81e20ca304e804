// node measured_rig.mjs: a haptic device (haptic_station/device/protocol/UDP_DEVICE.md) and a Leap Motion service, with
// a hand that lies on the end-effector. The tracker stands at HAPTIC_FROM_TRACKER_M with the axes of S1 eq. (4). Prints
// `udp=PORT leap=PORT`. On stdin: `go X Y Z` carries hand and end-effector there [m] and prints `there`; `slip on` moves
// the hand to and fro on the end-effector, `slip off` ends it. Positions follow the messages that are sent, not the
// clock, so that a slow machine sees no jumps.
import {createSocket} from 'node:dgram';
import {createRequire} from 'node:module';
import {createInterface} from 'node:readline';
import {pathToFileURL} from 'node:url';

import {poseOf, stepTowards} from '../udp_pose.mjs';

export const HAPTIC_FROM_TRACKER_M = [0.03, 0.31, -0.02];
const COMMAND_BYTES = 108;
const COMMANDS_FOR_A_POSE = 4;  // 500 poses a second
const STEP_M = 0.0002;          // from pose to pose: 0.1 m/s
const NOISE_M = 0.0003;
const SLIP_M = 0.012;

function run() {
  const {WebSocketServer} = createRequire(new URL('../../npm/package.json', import.meta.url))('ws');
  let [at, to, slips, commands, frames] = [[0, 0.05, 0], [0, 0.05, 0], false, 0, 0];

  const device = createSocket('udp4');
  device.on('message', (command, from) => {
    if (command.length !== COMMAND_BYTES || ++commands % COMMANDS_FOR_A_POSE !== 0) return;
    const step = stepTowards(at, to, STEP_M);
    at = step.at;
    if (step.arrives) console.log('there');
    device.send(poseOf({sequence: commands, command}, [...at, 0, 0, 0]), from.port, from.address);
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
