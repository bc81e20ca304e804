// What the page knows of a resource of the server: node resource_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {Resource} = await bundled('link/resource.ts');
const {ServerResources} = await bundled('link/server_resources.ts');
const {PLAYBACK} = await bundled('playback/playback_state.ts');

const ok = (published_ns = 0n) => ({status: 200, text: '', published_ns});
const at = (published_ns, message) => ({message, published_ns});

/** A resource whose server answers only when told to. Its state is the message. */
function slow(traits = {}) {
  const asked = [];
  const answers = [];
  const resource = new Resource((command) => {
    asked.push(command);
    return new Promise((answer) => answers.push(answer));
  }, {read: (message) => message, ...traits});
  const answer = async (reply) => {
    answers.shift()(reply);
    await new Promise((wake) => setTimeout(wake));
  };
  return {resource, asked, answer};
}

test('a state is shown as it comes, and nothing is asked for', () => {
  const {resource, asked} = slow();
  let told = 0;
  resource.onChange(() => ++told);
  resource.take(at(1n, 'one'));
  resource.take(at(2n, 'two'));
  assert.equal(resource.state, 'two');
  assert.equal(told, 2);
  resource.take(undefined);
  assert.equal(resource.state, undefined, 'the server has no such resource any more');
  assert.deepEqual(asked, []);
});

test('a state from before the last command is not shown after it, whichever comes first', async () => {
  const {resource, answer} = slow();
  resource.take(at(1n, 'before'));
  void resource.command({delay: 1});
  resource.take(at(5n, 'old'));
  assert.equal(resource.state, 'before');
  await answer(ok(9n));
  assert.equal(resource.state, 'before');
  resource.take(at(6n, 'old'));
  assert.equal(resource.state, 'before');
  resource.take(at(9n, 'after'));
  assert.equal(resource.state, 'after');
  void resource.command({delay: 2});
  resource.take(at(12n, 'faster than the answer'));
  await answer(ok(12n));
  assert.equal(resource.state, 'faster than the answer');
});

test('a control is not told to show the state from before its command once the command is answered', async () => {
  const {resource, answer} = slow();
  resource.take(at(1n, 'before'));
  let told = 0;
  resource.onChange(() => ++told);
  void resource.command({delay: 600});
  await answer(ok(9n));
  assert.deepEqual([told, resource.state], [0, 'before']);
  resource.take(at(9n, 'after'));
  assert.deepEqual([told, resource.state], [1, 'after']);
});

test('while a command is on its way, later ones become one', async () => {
  const {resource, asked, answer} = slow({join: (first, then) => ({...first, ...then})});
  const first = resource.command({delay: 1});
  void resource.command({delay: 2});
  void resource.command({delay: 3, loss: 1});
  assert.deepEqual(asked, [{delay: 1}]);
  await answer(ok());
  assert.deepEqual(asked, [{delay: 1}, {delay: 3, loss: 1}]);
  await answer(ok());
  assert.equal(await first, true);
});

test('commands that cannot be joined are sent one after the other, and each is told its own answer', async () => {
  const {resource, asked, answer} = slow();
  const answers = [1, 2, 3].map((remove) => resource.command({remove}));
  assert.deepEqual(asked, [{remove: 1}]);
  await answer(ok());
  await answer({status: 400, text: 'there is no note 2'});
  await answer(ok());
  assert.deepEqual(asked, [{remove: 1}, {remove: 2}, {remove: 3}]);
  assert.deepEqual(await Promise.all(answers), [true, false, true]);
});

test('a held key does not pile commands up', async () => {
  const {resource, asked, answer} = slow({mostWaiting: 4});
  for (let s = 1; s <= 20; ++s) void resource.command({seek_s: s});
  for (let s = 1; s <= 5; ++s) await answer(ok());
  assert.deepEqual(asked.map(({seek_s}) => seek_s), [1, 2, 3, 4, 5]);
});

test('the reason of a refused command is told until one is accepted, and its effect is taken back', async () => {
  const {resource, answer} = slow({after: (state, {play}) => ({...state, play})});
  resource.take(at(1n, {play: true}));
  void resource.command({play: false});
  assert.equal(resource.state.play, false, 'the effect is shown at once');
  await answer({status: 403, text: 'not for you'});
  assert.equal(resource.problem, 'The server refused: not for you.');
  assert.equal(resource.state.play, true);
  resource.take(at(2n, {play: true}));
  assert.notEqual(resource.problem, '');
  void resource.command({play: false});
  await answer(ok(3n));
  assert.equal(resource.problem, '');
});

test('a server that is away is told, the state stays, and its return ends the sentence; a refusal stays', async () => {
  const {resource, answer} = slow();
  resource.take(at(1n, 'one'));
  resource.connected(false);
  assert.match(resource.problem, /does not answer/);
  assert.equal(resource.state, 'one');
  resource.connected(true);
  assert.equal(resource.problem, '');
  void resource.command({});
  await answer(undefined);
  assert.match(resource.problem, /does not answer/);
  void resource.command({});
  await answer({status: 400, text: 'too long'});
  resource.connected(true);
  assert.match(resource.problem, /too long/);
});

test('a seek is shown at once, and the position from before it is not shown while the player carries it out', async () => {
  const message = (position, pending = false) => ({
    file: 'a.mcap', positionS: position, durationS: 20, speed: 1, loop: true, playing: true, damaged: 0n, beginNs: 17n,
    shownNs: 0n, shownS: 0, shownSpeed: 0, pending,
  });
  const {resource, answer} = slow(PLAYBACK);
  resource.take(at(1n, message(1)));
  void resource.command({seek_s: 9});
  assert.equal(resource.state.position_s, 9);
  await answer(ok(5n));
  resource.take(at(5n, message(1.2, true)));
  assert.equal(resource.state.position_s, 9);
  resource.take(at(6n, message(9.1)));
  assert.equal(resource.state.position_s, 9.1);
});

test('a visitor who may not change a resource has no state of it, but sees what is only read', () => {
  const resources = new ServerResources();
  const notes = resources.at('/playback/notes', {read: (message) => message});
  let listed;
  resources.on('/sessions', (newest) => (listed = newest));
  resources.changed({'/playback/notes': at(1n, 'notes'), '/sessions': at(1n, 'list')}, ['/recording']);
  assert.equal(notes.state, undefined);
  assert.equal(listed.message, 'list');
  resources.changed({'/playback/notes': at(1n, 'notes')}, ['/playback/notes']);
  assert.equal(notes.state, 'notes');
  resources.changed({}, ['/playback/notes']);
  assert.equal(notes.state, 'notes', 'no news is no change');
});
