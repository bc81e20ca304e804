// node decode_golden.mjs DEPTH_DECODER.wasm GOLDEN_FOLDER FZSTD.mjs: whether the browser's decoder gives the golden
// frames as their readable twins have them, and refuses them damaged.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [moduleFile, folder, fzstd] = process.argv.slice(2);
const {decompress} = await import(pathToFileURL(fzstd));
const compiled = new WebAssembly.Module(readFileSync(moduleFile));

/** A fresh decoder, with the imports that clients/viewer/src/depth/decode_depth.ts gives it. */
function decoder() {
  const view = (at, size) => new Uint8Array(wasm.memory.buffer, at, size);
  const nothing = () => 52;
  const wasm = new WebAssembly.Instance(compiled, {
    env: {
      ZSTD_decompress: (to, room, from, size) => {
        try {
          return decompress(view(from, size), view(to, room)).length;
        } catch {
          return -1;
        }
      },
    },
    wasi_snapshot_preview1: {fd_close: nothing, fd_seek: nothing, fd_write: nothing},
  }).exports;
  wasm._initialize();
  return (packet) => {
    view(wasm.packet(packet.length), packet.length).set(packet);
    if (wasm.decode() === 0) return undefined;
    const samples = [...new Uint16Array(wasm.memory.buffer, wasm.samples(), wasm.width() * wasm.height())];
    const window = Array.from({length: 8}, (_, index) => wasm.window(index));
    return {samples, window: window[0] === -1 ? undefined : window};
  };
}

let frames = 0;
for (const mode of ['fast', 'intra', 'temporal', 'bounded', 'window_intra', 'window_temporal']) {
  const decode = decoder();
  for (let i = 0; i < 3; ++i) {
    const stem = join(folder, `${mode}_${i}`);
    const packet = readFileSync(`${stem}.tpd`);
    const [, comment, , , ...rows] = readFileSync(`${stem}.pgm`, 'utf8').split('\n');
    const stated = /exact (.*), near (.*), border (.*)/.exec(comment)?.slice(1).join(' ').split(' ').map(Number);
    const expected = {samples: rows.join(' ').trim().split(/\s+/).map(Number), window: stated};
    const damaged = Uint8Array.from(packet);
    damaged[packet.length >> 1] ^= 0x10;
    assert.equal(decode(damaged), undefined, `${stem} damaged`);
    assert.deepEqual(decode(packet), expected, stem);
    ++frames;
  }
}
console.log(`${frames} golden frames decode in WebAssembly as their twins say`);
