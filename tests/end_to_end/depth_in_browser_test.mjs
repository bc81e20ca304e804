// node depth_in_browser_test.mjs SOURCE_DIR BIN_DIR VIEWER_FILES: a real recording, coded by every mode, decoded by the
// viewer's own worker in Chromium. Every frame must be given back; how long that takes is printed, not judged.
import assert from 'node:assert/strict';
import {execFile} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {decoders, readIndexed} from '../npm/mcap_file.mjs';
import {openBrowser} from './browser.mjs';

const [sourceDir, binDir, viewerFiles] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'telepalp-depth-'));
const ROUNDS = 5;
let browser;

before(async () => {
  browser = await openBrowser(folder);
});
after(async () => {
  await browser?.context.close();
  rmSync(folder, {recursive: true});
});

async function packetsOf(mode) {
  const file = join(folder, `${mode}.mcap`);
  const recording = join(sourceDir, 'deploy/demo_data/oni/3dj_test.oni');
  await promisify(execFile)(join(binDir, 'telepalp-codec'), ['encode', '--mode', mode, recording, file]);
  const {reader, messages} = await readIndexed(file);
  const decode = decoders(reader.schemasById);
  return messages.map((message) => {
    const channel = reader.channelsById.get(message.channelId);
    return Buffer.from(decode.get(channel.schemaId)(message.data).data).toString('base64');
  });
}

/** Runs in the page; returns the worker's answer to each packet, in order. */
async function decodeAll({script, decoder, packets, rounds}) {
  const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;
  const worker = new Worker(URL.createObjectURL(new Blob([script], {type: 'text/javascript'})));
  const failed = new Promise((_, reject) => { worker.onerror = ({message}) => reject(new Error(message)); });
  worker.postMessage({module: await WebAssembly.compile(bytesOf(decoder))});
  const answers = [];
  for (let round = 0; round < rounds; ++round) {
    for (const base64 of packets) {
      const packet = bytesOf(base64);
      const answer = new Promise((resolve) => { worker.onmessage = ({data}) => resolve(data); });
      worker.postMessage({packet}, [packet]);
      const {problem, frame, decode_ms} = await Promise.race([answer, failed]);
      answers.push({problem, decode_ms, pixels: frame?.samples.length});
    }
  }
  worker.terminate();
  return answers;
}

for (const mode of ['fast', 'intra', 'temporal', 'bounded']) {
  test(`Chromium decodes ${mode}`, async () => {
    const packets = await packetsOf(mode);
    const script = readFileSync(join(viewerFiles, 'depth_worker.js'), 'utf8');
    const decoder = readFileSync(join(viewerFiles, 'depth_decoder.wasm'), 'base64');
    const answers = await browser.page.evaluate(decodeAll, {script, decoder, packets, rounds: ROUNDS});
    assert.equal(answers.length, ROUNDS * packets.length);
    for (const {problem, pixels} of answers) {
      assert.equal(problem, undefined);
      assert.equal(pixels, 640 * 480);
    }
    const times = answers.slice(packets.length).map(({decode_ms}) => decode_ms).sort((a, b) => a - b);
    const at = (share) => times[Math.floor(share * (times.length - 1))].toFixed(1);
    console.log(`${mode}: decoded in ${at(0.5)} ms (p50), ${at(0.99)} ms (p99)`);
  });
}
