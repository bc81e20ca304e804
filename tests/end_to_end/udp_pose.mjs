// The datagrams of a UDP device (haptic_station/device/protocol/UDP_DEVICE.md), for devices that tests move.
const FIRST_NUMBER_AT = 28;
const NUMBER_BYTES = 8;
const CHECKSUM_BYTES = 4;

function adler32(bytes) {
  let [a, b] = [1, 0];
  for (const byte of bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return ((b << 16) | a) >>> 0;
}

/**
 * A pose with these numbers from the end-effector's place on, in answer to `command`. `heard`: the number of the newest
 * command that the device has received; 0: the device does not tell, and its loop's delay is not measured.
 */
export function poseOf({version = 1, flags = 0, sequence, command, heard = command.readUInt32LE(12)}, numbers) {
  const pose = Buffer.alloc(FIRST_NUMBER_AT + NUMBER_BYTES * numbers.length + CHECKSUM_BYTES);
  pose.write('TTPU');
  pose.writeUInt16LE(version, 4);
  pose.writeUInt16LE(flags, 6);
  pose.writeUInt32LE(4711, 8);
  pose.writeUInt32LE(sequence, 12);
  pose.writeBigUInt64LE(process.hrtime.bigint() / 1000n, 16);
  pose.writeUInt32LE(heard, 24);
  numbers.forEach((number, i) => pose.writeDoubleLE(number, FIRST_NUMBER_AT + NUMBER_BYTES * i));
  pose.writeUInt32LE(adler32(pose.subarray(0, pose.length - CHECKSUM_BYTES)), pose.length - CHECKSUM_BYTES);
  return pose;
}

/** The place after one step of at most `most_m` from `at` towards `to`, and whether it is there. */
export function stepTowards(at, to, most_m) {
  const way = to.map((value, axis) => value - at[axis]);
  const far_m = Math.hypot(...way);
  const share = far_m > most_m ? most_m / far_m : 1;
  return {at: at.map((value, axis) => value + share * way[axis]), arrives: far_m > 0 && share === 1};
}
