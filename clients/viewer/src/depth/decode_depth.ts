import {decompress} from 'fzstd';

/** The error at a depth of z metres is at most max(least_m, per_m z²) metres. */
export interface DepthErrorBound {
  least_m: number;
  per_m: number;
}

/** Where a frame is exact [pixels], and its error bounds beside that window and at the frame's border. */
export interface DepthWindow {
  column: number;
  row: number;
  width: number;
  height: number;
  near: DepthErrorBound;
  border: DepthErrorBound;
}

/** Depth along the optical axis: `samples[row * width + column] * unit_m` metres, 0 where nothing was measured. */
export interface DepthFrame {
  width: number;
  height: number;
  unit_m: number;
  samples: Uint16Array;
  window?: DepthWindow;  // undefined: the bound in the frame's message holds for each pixel
}

/** The functions of the compiled decoder; see codec/wasm/depth_decoder_wasm.cpp. */
interface Decoder {
  memory: WebAssembly.Memory;
  _initialize(): void;
  packet(bytes: number): number;
  decode(): number;
  width(): number;
  height(): number;
  unit_m(): number;
  samples(): number;
  window(index: number): number;
  problem(): number;
}

let compiled: WebAssembly.Module | undefined;
let decoder: Decoder | undefined;

/** `module`: the compiled depth_decoder.wasm. Call it before decodeDepth. */
export function setDecoder(module: WebAssembly.Module): void {
  compiled = module;
  decoder = undefined;
}

/** Decodes a packet of any depth mode. Throws on a damaged packet; never returns wrong depth. */
export function decodeDepth(packet: Uint8Array): DepthFrame {
  if (compiled === undefined) throw new Error('depth packet: no decoder loaded: reload the page');
  try {
    return decodeWith((decoder ??= instantiate(compiled)), packet);
  } catch (problem) {
    if (problem instanceof WebAssembly.RuntimeError) decoder = undefined;  // its state is undefined
    throw problem;
  }
}

function decodeWith(wasm: Decoder, packet: Uint8Array): DepthFrame {
  const room = wasm.packet(packet.length);
  new Uint8Array(wasm.memory.buffer, room, packet.length).set(packet);
  if (wasm.decode() === 0) throw new Error(`depth packet: ${text(wasm.memory, wasm.problem())}`);
  const [width, height] = [wasm.width(), wasm.height()];
  const samples = new Uint16Array(wasm.memory.buffer, wasm.samples(), width * height).slice();
  const window = windowOf(wasm);
  return {width, height, unit_m: wasm.unit_m(), samples, ...(window && {window})};
}

function windowOf({window}: Decoder): DepthWindow | undefined {
  if (window(0) < 0) return undefined;
  const [column, row, width, height] = [window(0), window(1), window(2), window(3)];
  return {
    column, row, width, height,
    near: {least_m: window(4), per_m: window(5)},
    border: {least_m: window(6), per_m: window(7)},
  };
}

function instantiate(module: WebAssembly.Module): Decoder {
  const view = (at: number, size: number) => new Uint8Array(wasm.memory.buffer, at, size);
  const noFiles = () => 52;  // ENOSYS: the C library's output functions have no target here
  const instance = new WebAssembly.Instance(module, {
    env: {
      ZSTD_decompress(to: number, room: number, from: number, size: number): number {
        try {
          return decompress(view(from, size), view(to, room)).length;
        } catch {
          return -1;  // the caller treats any length except the declared one as an error
        }
      },
    },
    wasi_snapshot_preview1: {fd_close: noFiles, fd_seek: noFiles, fd_write: noFiles},
  });
  const wasm = instance.exports as unknown as Decoder;
  wasm._initialize();
  return wasm;
}

function text(memory: WebAssembly.Memory, at: number): string {
  const bytes = new Uint8Array(memory.buffer, at);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
}
