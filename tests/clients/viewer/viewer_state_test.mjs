// What the page knows of the picture that it draws: node viewer_state_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {ViewerState} = await bundled('viewer_state.ts');

const CAPTURED_MS = 1000;
const instantAt = (captured_ms) => ({
  picture: {captured_ns: BigInt(captured_ms) * 1_000_000n, summary: {}},
  station: undefined, trail: [],
  times: {captured_ms, published_ms: captured_ms + 5, complete_ms: captured_ms + 10},
});

test('the picture that waits while another is drawn still counts as arrived', () => {
  const state = new ViewerState();
  state.news = {connected: true, offset_ms: 0, heard: {published_ms: 2000, received_ms: 2000}};
  const [first, second] = [instantAt(CAPTURED_MS), instantAt(CAPTURED_MS + 33)];
  state.taken(first);
  state.taken(second);  // decoded while the first is drawn
  state.drawn(first, 1050);
  const {account, pictureInstant_ms} = state.read(1250);
  assert.equal(pictureInstant_ms, CAPTURED_MS);
  assert.equal(account.computer, 1050 - 1010 + 1250 - 1050, 'since the second arrived, this computer is the slow one');
  state.drawn(second, 1260);
  assert.equal(state.read(1260).pictureInstant_ms, CAPTURED_MS + 33);
});
