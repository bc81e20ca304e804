// Which coding of colour the page takes, and which frames of video it gives to the browser's decoder: node
// color_video_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {ColorChoice} = await bundled('present/color_choice.ts');
const {ColorVideo, decodesVideo} = await bundled('present/color_video.ts');

const PICTURES = ['/camera/color'];
const VIDEO = ['/camera/color/video'];

test('colour comes as pictures unless the user asks for video and the browser decodes it', () => {
  const choice = new ColorChoice();
  assert.deepEqual(choice.topics, PICTURES);
  assert.equal(choice.said, '');
  choice.asked = 'video';
  assert.deepEqual(choice.topics, PICTURES, 'the browser has not said yet what it decodes');
  choice.offered = true;
  assert.deepEqual(choice.topics, VIDEO);
  assert.match(choice.said, /as video/);
  choice.asked = 'pictures';
  assert.deepEqual(choice.topics, PICTURES);
});

test('a browser without a decoder stays with pictures and the page says why', () => {
  const choice = new ColorChoice();
  choice.asked = 'video';
  choice.offered = false;
  assert.deepEqual(choice.topics, PICTURES);
  assert.match(choice.said, /as pictures: this browser decodes no video/);
});

test('a session without pictures is shown by its video after two seconds', () => {
  const choice = new ColorChoice();
  choice.offered = true;
  for (let image = 0; image < 59; ++image) assert.equal(choice.depthCame(), false);
  assert.deepEqual(choice.topics, PICTURES);
  assert.equal(choice.depthCame(), true);
  assert.deepEqual(choice.topics, [...PICTURES, ...VIDEO]);
  choice.colorCame();
  assert.deepEqual(choice.topics, [...PICTURES, ...VIDEO], 'its video is the colour that came');
  choice.restart();
  assert.deepEqual(choice.topics, PICTURES);
});

test('a session without video is shown by its pictures after two seconds, though the user asks for video', () => {
  const choice = new ColorChoice();
  choice.asked = 'video';
  choice.offered = true;
  for (let image = 0; image < 59; ++image) assert.equal(choice.depthCame(), false);
  assert.deepEqual(choice.topics, VIDEO);
  assert.equal(choice.depthCame(), true);
  assert.deepEqual(choice.topics, [...PICTURES, ...VIDEO]);
  assert.match(choice.said, /No video came/);
  choice.restart();
  assert.deepEqual(choice.topics, VIDEO);
});

test('pictures that come keep the page with pictures', () => {
  const choice = new ColorChoice();
  choice.offered = true;
  for (let image = 0; image < 300; ++image) {
    choice.depthCame();
    if (image % 30 === 0) choice.colorCame();
  }
  assert.deepEqual(choice.topics, PICTURES);
});

const key = (width = 64, height = 48) =>
  Uint8Array.of(0x10, 0, 0, 0x9d, 1, 0x2a, width & 255, width >> 8, height & 255, height >> 8);
const predicted = () => Uint8Array.of(0x11, 0, 0, 5);

/** A browser's decoder that answers when it is told to. */
function browser() {
  const seen = {fed: [], shown: [], keys: 0, closed: 0, decoder: undefined, queue: 0};
  globalThis.VideoDecoder = class {
    constructor(on) {
      Object.assign(this, {on, state: 'configured'});
      seen.decoder = this;
    }
    configure() {}
    get decodeQueueSize() {
      return seen.queue;
    }
    decode(chunk) {
      seen.fed.push(chunk.type);
    }
    close() {
      this.state = 'closed';
    }
  };
  globalThis.EncodedVideoChunk = class {
    constructor(chunk) {
      Object.assign(this, chunk);
    }
  };
  globalThis.createImageBitmap = async () => ({close: () => ++seen.closed});
  const video = new ColorVideo({
    picture: (picture, captured_ns) => seen.shown.push(captured_ns),
    needsKeyFrame: () => ++seen.keys,
  });
  const show = (timestamp) => seen.decoder.on.output({timestamp, close: () => undefined});
  return {seen, video, show};
}

test('a frame comes out with the capture time that it went in with, to the nanosecond', async () => {
  const {seen, video, show} = browser();
  video.came(key(), 1_000_000_123n);
  video.came(predicted(), 1_033_333_456n);
  assert.deepEqual(seen.fed, ['key', 'delta']);
  show(1_000_000);
  show(1_033_333);
  await new Promise(setImmediate);
  assert.deepEqual(seen.shown, [1_000_000_123n, 1_033_333_456n]);
});

test('predicted frames without a key frame are not decoded, but a key frame is asked for', () => {
  const {seen, video} = browser();
  video.came(predicted(), 1n);
  assert.deepEqual(seen.fed, []);
  assert.equal(seen.keys, 1);
});

test('after an error of the decoder the next frame is a key frame', () => {
  const {seen, video} = browser();
  video.came(key(), 1n);
  seen.decoder.on.error(new Error('damaged'));
  video.came(predicted(), 2n);
  assert.deepEqual(seen.fed, ['key']);
  assert.equal(video.undecodable, 1);
  video.came(key(), 3n);
  assert.deepEqual(seen.fed, ['key', 'key']);
});

test('a bomb and frames that are cut short do not reach the decoder', () => {
  const {seen, video} = browser();
  for (const frame of [key(16383, 16383), key(0, 48), new Uint8Array(0), key().slice(0, 9)]) video.came(frame, 1n);
  assert.deepEqual(seen.fed, []);
});

test('a browser that is too slow begins again at a key frame', () => {
  const {seen, video} = browser();
  video.came(key(), 1n);
  seen.queue = 31;
  video.came(predicted(), 2n);
  seen.queue = 0;
  video.came(predicted(), 3n);
  assert.deepEqual(seen.fed, ['key']);
  assert.equal(seen.keys, 2);
});

test('where the browser has no decoder, video is not offered', async () => {
  delete globalThis.VideoDecoder;
  assert.equal(await decodesVideo(), false);
});
