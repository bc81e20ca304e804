// A device with six degrees of freedom for tests: it speaks version 2 of the UDP protocol (UDP_DEVICE.md), holds the pose
// that the test gives it, and keeps the last wrench that it was commanded.
import {createSocket} from 'node:dgram';

const POSE_BYTES = 152;
const COMMAND_BYTES = 132;
const PEAK_N = 10;
const PEAK_N_M = 0.5;

function adler32(bytes) {
  let [a, b] = [1, 0];
  for (const byte of bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return (b * 65536 + a) >>> 0;
}

export class NeedleDevice {
  /** Listens on a port of its own on loopback: `port`. */
  static async open() {
    const device = new NeedleDevice();
    device.socket = createSocket('udp4');
    device.socket.on('message', (bytes, from) => device.answer(bytes, from));
    await new Promise((bound) => device.socket.bind(0, '127.0.0.1', bound));
    device.port = device.socket.address().port;
    return device;
  }

  pose = {at_m: [0, 0.1, 0], attitude_xyzw: [0, 0, 0, 1]};
  wrench = {force_N: [0, 0, 0], torque_N_m: [0, 0, 0]};
  session = 1 + Math.floor(Math.random() * 1e9);
  sequence = 0;
  moved = {at_ms: performance.now(), at_m: [0, 0.1, 0]};

  answer(bytes, from) {
    if (bytes.toString('latin1', 0, 4) !== 'TTPD') return;
    const three = (at) => [0, 8, 16].map((offset) => bytes.readDoubleLE(at + offset));
    if (bytes.length === COMMAND_BYTES) this.wrench = {force_N: three(80), torque_N_m: three(104)};
    this.socket.send(this.poseBytes(bytes.readUInt32LE(12)), from.port, from.address);
  }

  poseBytes(newest) {
    const out = Buffer.alloc(POSE_BYTES);
    out.write('TTPU', 0, 'latin1');
    out.writeUInt16LE(2, 4);
    out.writeUInt16LE(2, 6);  // the attitude is measured
    out.writeUInt32LE(this.session, 8);
    out.writeUInt32LE(++this.sequence, 12);
    out.writeBigUInt64LE(BigInt(Math.floor(1000 * performance.now())), 16);
    out.writeUInt32LE(newest, 24);
    const put = (at, numbers) => numbers.forEach((number, i) => out.writeDoubleLE(number, at + 8 * i));
    const now_ms = performance.now();
    const dt_s = Math.max(1e-4, (now_ms - this.moved.at_ms) / 1000);
    const velocity = this.pose.at_m.map((at, i) => (at - this.moved.at_m[i]) / dt_s);
    this.moved = {at_ms: now_ms, at_m: [...this.pose.at_m]};
    put(28, this.pose.at_m);
    put(52, velocity.map((v) => Math.min(1, Math.max(-1, v))));
    put(76, this.pose.attitude_xyzw);
    put(108, [0, 0, 0]);
    put(132, [PEAK_N, PEAK_N_M]);
    out.writeUInt32LE(adler32(out.subarray(0, 148)), 148);
    return out;
  }

  /** Moves in a straight line, at 40 mm/s or less. */
  async move(at_m, speed_m_per_s = 0.04) {
    const from = [...this.pose.at_m];
    const length_m = Math.hypot(...at_m.map((to, i) => to - from[i]));
    const begun = performance.now();
    for (let share = 0; share < 1;) {
      await new Promise((wake) => setTimeout(wake, 1));
      share = Math.min(1, (speed_m_per_s * (performance.now() - begun)) / 1000 / Math.max(1e-6, length_m));
      this.pose.at_m = from.map((start, i) => start + share * (at_m[i] - start));
    }
  }

  close() {
    this.socket.close();
  }
}
