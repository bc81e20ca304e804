// node view_test.mjs VIEWER_SOURCES VIEWER_WORK: the view that address, role and keys choose.
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {addressOf, viewForKey, viewForRole, viewInAddress, VIEWS} = await bundled('views/view.ts');

test('each view has an address, and the address gives the view back', () => {
  for (const view of VIEWS) assert.equal(viewInAddress(addressOf(view, '')), view);
});

test('an address without a view, or with an unknown one, chooses none', () => {
  for (const search of ['', '?', '?view=', '?view=surgeon', '?at_s=3']) assert.equal(viewInAddress(search), undefined, search);
});

test('the rest of the address stays when the view changes', () => {
  assert.equal(new URLSearchParams(addressOf('qa', '?at_s=12.5&view=doctor')).get('at_s'), '12.5');
});

test('technician and QA begin in their own view, everybody else in the doctor\'s', () => {
  assert.equal(viewForRole('technician'), 'technician');
  assert.equal(viewForRole('qa'), 'qa');
  for (const role of ['doctor', 'viewer', 'local', '', 'unheard of']) assert.equal(viewForRole(role), 'doctor', role);
});

test('the keys 1 to 3 choose the views in their order, other keys none', () => {
  assert.deepEqual(['1', '2', '3'].map(viewForKey), [...VIEWS]);
  for (const key of ['0', '4', '12', 'v', 'ArrowLeft']) assert.equal(viewForKey(key), undefined, key);
});
