// Starts the real programs for tests that look at them from outside, and ends only those.
import {spawn} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

export const sleep = (ms) => new Promise((wake) => setTimeout(wake, ms));

/** Calls `look` until it gives something other than undefined or false; fails with `what` after `timeout_ms`. */
export async function until(what, look, timeout_ms = 60_000) {
  for (const end = Date.now() + timeout_ms; Date.now() < end; await sleep(50)) {
    const found = await look();
    if (found !== undefined && found !== false) return found;
  }
  throw new Error(`${what}: not within ${timeout_ms / 1000} s`);
}

const STEADY = 'timestamp_us,palm_x_mm,palm_y_mm,palm_z_mm\n0,0,-100,0\n1000000,0,-100,0\n3000000,0,0,0\n23000000,0,0,1\n';

/**
 * Writes the scene ribs-ultrasound of the folder `scenes` to `folder`, with a hand that comes down, keeps the probe on
 * the skin for 40 s, goes up and repeats it: a hand that misses the device on a busy machine meets it the next time.
 */
export function sceneOfASteadyProbe(scenes, folder) {
  const shipped = readFileSync(join(scenes, 'ribs-ultrasound.scene.textproto'), 'utf8');
  const file = join(folder, 'steady.scene.textproto');
  writeFileSync(file, shipped.replace(/^hand \{.*\}$/m, 'hand { trace { file: "steady.csv" deepest_m: 0.02 } }'));
  writeFileSync(join(folder, 'steady.csv'), STEADY);
  return file;
}

/** A folder for one test, and the programs that run in it. `end` stops them and removes it. */
export class Workplace {
  constructor(name) {
    this.folder = mkdtempSync(join(tmpdir(), `telepalp_${name}_`));
    this.programs = [];
  }

  start(program, args) {
    const child = spawn(program, args, {stdio: ['pipe', 'pipe', 'pipe']});
    child.heard = '';
    child.over = new Promise((resolve) => child.once('exit', resolve));
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (child.heard += text));
    this.programs.push(child);
    return child;
  }

  /** telepalp-server on free ports, unless `args` name one for browsers; resolves with them when it listens. */
  async server(program, args = []) {
    const ready = join(this.folder, `ready_${this.programs.length}`);
    const child = this.start(program, ['--port', '0', ...(args.includes('--http-port') ? [] : ['--http-port', '0']), '--ready-file', ready, ...args]);
    await until('the server listens', () => {
      if (child.exitCode !== null) throw new Error(`the server left: ${child.heard}`);
      return existsSync(ready);
    });
    const ports = Object.fromEntries(readFileSync(ready, 'utf8').trim().split('\n').map((line) => line.split('=')));
    return {child, port: Number(ports.port), http_port: Number(ports.http_port), health_port: Number(ports.health_port)};
  }

  async end() {
    for (const child of this.programs) child.kill('SIGTERM');
    await Promise.race([Promise.all(this.programs.map((child) => child.over)), sleep(5000)]);
    for (const child of this.programs) if (child.exitCode === null) child.kill('SIGKILL');
    rmSync(this.folder, {recursive: true, force: true});
  }
}
