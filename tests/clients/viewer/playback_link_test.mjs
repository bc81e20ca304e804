// When the page asks the server about a played session: node playback_link_test.mjs VIEWER_SOURCES VIEWER_WORK
import assert from 'node:assert/strict';
import test from 'node:test';

import {bundled} from './bundled.mjs';

const {PlaybackLink} = await bundled('playback/playback_link.ts');

const STATE = {position_s: 1, duration_s: 20, speed: 1, loop: true, playing: true, shown: undefined, begin_ms: 0.000017, session: 'a.mcap 17'};
const ok = (state = {}) => ({status: 200, text: JSON.stringify({...STATE, file: 'a.mcap', begin_ns: '17', ...state})});
const SESSION = {connected: true, playsSession: true};
const LIVE = {connected: true, playsSession: false};
const AWAY = {connected: false, playsSession: true};

/** A link to a server whose answers are those of `reply`; `asked` collects the requests, undefined for a GET. */
function linkTo(reply) {
  const asked = [];
  const link = new PlaybackLink(async (command) => {
    asked.push(command);
    return reply(command);
  });
  const look = async (site, times = 1) => {
    for (; times > 0; --times) await link.look(site);
  };
  return {link, asked, look};
}

test('a live server is never asked', async () => {
  const {link, asked, look} = linkTo(() => ok());
  await look(LIVE, 20);
  assert.deepEqual(asked, []);
  assert.equal(link.state, undefined);
});

test('the right is found out by an empty command, then the state is read on each look', async () => {
  const {link, asked, look} = linkTo((command) => ok({position_s: command ? 1 : 2}));
  await look(SESSION, 3);
  assert.deepEqual(asked, [{}, undefined, undefined]);
  assert.equal(link.state.position_s, 2);
});

for (const status of [403, 404])
  test(`after a ${status} nothing is shown, and it is asked again only on another connection`, async () => {
    const {link, asked, look} = linkTo(() => ({status, text: 'no'}));
    await look(SESSION, 20);
    assert.deepEqual(asked, [{}]);
    assert.equal(link.state, undefined);
    assert.equal(link.problem, '', 'a watcher has asked for nothing');
    await look(AWAY);
    await look(SESSION, 20);
    assert.equal(asked.length, 2);
  });

test('the reason of a refused command is shown until one is accepted', async () => {
  let status = 200;
  const {link, look} = linkTo((command) => (command?.play === undefined ? ok() : {...ok(), status, text: 'not for you'}));
  await look(SESSION);
  status = 403;
  await link.command({play: false});
  assert.equal(link.problem, 'The server refused: not for you.');
  await look(SESSION);
  assert.equal(link.state.playing, true, 'the server\'s state is shown again');
  assert.notEqual(link.problem, '');
  status = 200;
  await link.command({play: false});
  assert.equal(link.problem, '');
});

test('a server that does not answer is reported and asked seldom; its return is noticed', async () => {
  let there = true;
  let absence;
  const {link, asked, look} = linkTo(() => (there ? ok() : absence));
  await look(SESSION);
  there = false;
  await look(SESSION, 21);
  assert.match(link.problem, /does not answer/);
  assert.equal(asked.length, 1 + 3);
  there = true;
  await look(SESSION, 10);
  assert.equal(link.problem, '');
  absence = {status: 503, text: 'busy'};
  there = false;
  await look(SESSION);
  assert.match(link.problem, /does not answer/, 'a busy server is asked again, too');
  assert.deepEqual(link.state, STATE);
});

test('without a connection the last state stays with a sentence, and no request is made', async () => {
  const {link, asked, look} = linkTo(() => ok());
  await look(SESSION);
  await look(AWAY, 5);
  await link.command({play: false});
  assert.equal(asked.length, 1);
  assert.deepEqual(link.state, STATE);
  assert.match(link.problem, /does not answer/);
  await look(LIVE);
  assert.equal(link.state, undefined, 'another server captures now');
});

test('a command shows its effect at once, and an older reply does not undo it', async () => {
  let answerGet;
  const {link, look} = linkTo((command) => command ? ok() : new Promise((resolve) => (answerGet = () => resolve(ok()))));
  await look(SESSION);
  const reading = look(SESSION);
  const sent = link.command({play: false, seek_s: 9});
  assert.deepEqual(link.state, {...STATE, playing: false, position_s: 9});
  answerGet();
  await Promise.all([reading, sent]);
  assert.equal(link.state.position_s, 9);
});

test('after a seek, the position is not read while the server still carries it out', async () => {
  const {link, asked, look} = linkTo(() => ok());
  await look(SESSION);
  await link.command({seek_s: 9});
  await look(SESSION, 2);
  assert.equal(asked.length, 2);
  assert.equal(link.state.position_s, 9);
  await look(SESSION);
  assert.equal(asked.length, 3);
});

test('commands are sent one after the other, and a held key does not pile them up', async () => {
  const waiting = [];
  const {link, asked, look} = linkTo((command) => command?.seek_s ? new Promise((go) => waiting.push(() => go(ok()))) : ok());
  await look(SESSION);
  const sent = [];
  for (let s = 1; s <= 20; ++s) sent.push(link.command({seek_s: s}));
  assert.equal(asked.length, 2, 'the second command waits for the reply to the first');
  while (waiting.length > 0) {
    waiting.shift()();
    await new Promise((wake) => setTimeout(wake));
  }
  await Promise.all(sent);
  assert.deepEqual(asked.slice(1).map(({seek_s}) => seek_s), [1, 2, 3, 4, 5]);
});
