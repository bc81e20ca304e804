// A device with six degrees of freedom for tests: it speaks version 2 of the UDP protocol (UDP_DEVICE.md), and keeps the
// last wrench that it was commanded. Its positions follow the commands, not the clock, so that a slow machine sees no
// jumps. It does not tell which command it has heard, because beside a browser it answers late, and the station would
// make the patient too soft to be felt.
import {createSocket} from 'node:dgram';

import {poseOf, stepTowards} from './udp_pose.mjs';

const COMMAND_BYTES = [108, 132];  // of version 1, which a station sends first, and of version 2
const ATTITUDE_MEASURED = 2;
const PRESSED = 4;
const STEP_M = 0.00002;  // from command to command: 0.04 m/s
const PEAK_N = 10;
const PEAK_N_M = 0.5;

export class NeedleDevice {
  attitude_xyzw = [0, 0, 0, 1];
  pressed = false;  // its button
  wrench = {force_N: [0, 0, 0], torque_N_m: [0, 0, 0]};
  #at_m = [0, 0.1, 0];
  #to_m = [0, 0.1, 0];
  #arrived = () => {};
  #sequence = 0;
  #socket = createSocket('udp4');

  /** Listens on `port`, a port of its own on loopback. */
  static async open() {
    const device = new NeedleDevice();
    device.#socket.on('message', (command, from) => device.#answer(command, from));
    await new Promise((bound) => device.#socket.bind(0, '127.0.0.1', bound));
    device.port = device.#socket.address().port;
    return device;
  }

  /** Moves there in a straight line. */
  move(to_m) {
    this.#to_m = to_m;
    return new Promise((arrived) => (this.#arrived = arrived));
  }

  get at_m() {
    return this.#at_m;
  }

  close() {
    this.#socket.close();
  }

  #answer(command, from) {
    if (!COMMAND_BYTES.includes(command.length)) return;
    const three = (at) => [0, 8, 16].map((offset) => command.readDoubleLE(at + offset));
    if (command.length === COMMAND_BYTES[1]) this.wrench = {force_N: three(80), torque_N_m: three(104)};
    const {at, arrives} = stepTowards(this.#at_m, this.#to_m, STEP_M);
    this.#at_m = at;
    if (arrives) this.#arrived();
    const pose = poseOf({version: 2, flags: ATTITUDE_MEASURED | (this.pressed ? PRESSED : 0), sequence: ++this.#sequence, command, heard: 0},
                        [...at, 0, 0, 0, ...this.attitude_xyzw, 0, 0, 0, PEAK_N, PEAK_N_M]);
    this.#socket.send(pose, from.port, from.address);
  }
}
