// Who may open a recorded session for a page alone, and what that changes for others: node own_session_rights_test.mjs BIN_DIR VIEWER_DIR
import assert from 'node:assert/strict';
import {execFile, execFileSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {promisify} from 'node:util';

import {frame, KeyedWeb} from './keyed_web.mjs';
import {until, Workplace} from './running_program.mjs';

const [bin, viewer] = process.argv.slice(2);
const place = new Workplace('own_session_rights');
const folder = join(place.folder, 'keys');
const recordings = join(place.folder, 'recordings');
const keys = (...words) => execFileSync(join(bin, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
const bearer = (name) =>
  ({authorization: `Bearer ${/^token: (.*)$/m.exec(readFileSync(join(folder, `${name}.token`), 'utf8'))[1]}`});
const id = (digit) => digit.repeat(32);
let web;

before(async () => {
  mkdirSync(recordings);
  const file = join(place.folder, 'played.mcap');
  const live = await place.server(join(bin, 'telepalp-server'), ['--viewer', viewer]);
  await promisify(execFile)(join(bin, 'telepalp-record'), ['--connect', `127.0.0.1:${live.port}`, '--out', file, '--seconds', '5']);
  live.child.kill('SIGTERM');
  copyFileSync(file, join(recordings, 'earlier.mcap'));
  keys('authority', '--host', '127.0.0.1');
  keys('server', '--host', '127.0.0.1');
  keys('client', '--name', 'recorder', '--role', 'technician');
  for (const [name, role] of [['dora', 'doctor'], ['vera', 'viewer'], ['quinn', 'qa']]) keys('token', '--name', name, '--role', role);
  const server = await place.server(join(bin, 'telepalp-server'), ['--source', `session:${file}`, '--viewer', viewer,
    '--key', join(folder, 'server.key'), '--record-dir', recordings, '--record-key', join(folder, 'recorder.key')]);
  web = new KeyedWeb(server.http_port, readFileSync(join(folder, 'authority.crt')));
});
after(() => place.end());

const playback = async (name, query = '') => JSON.parse((await web.ask(`/playback${query}`, {headers: bearer(name)})).text);
const move = (name, query, command) =>
  web.ask(`/playback${query}`, {method: 'POST', headers: bearer(name), body: JSON.stringify(command)});

/** Opens a stream and subscribes to all camera topics and the station's state. */
async function watch(name, query) {
  const open = await web.upgrade(bearer(name), undefined, `/stream${query}`);
  assert.equal(open.status, 101);
  await until('the server advertises', () => open.bytes.includes('/camera/depth'));
  const subscriptions = Array.from({length: 12}, (_, at) => ({id: at + 1, channelId: at + 1}));
  open.socket.write(frame(1, Buffer.from(JSON.stringify({op: 'subscribe', subscriptions}))));
  return open;
}

test('a guest opens a moment of the played session, moves it, and moves nobody else', async () => {
  const query = `?reading=${id('a')}&at_s=2.5`;
  const mine = await watch('vera', query);
  const size = mine.bytes.length;
  await until('the picture of the moment comes', () => mine.bytes.length > size + 20_000);
  await until('it stands at its moment', async () => (await playback('vera', query)).position_s === 2.5);
  assert.equal((await playback('vera', query)).playing, false);
  assert.equal((await playback('quinn')).playing, true, 'the session goes on for all');
  assert.equal((await move('vera', query, {seek_s: 1})).status, 200);
  await until('it is moved', async () => (await playback('vera', query)).position_s === 1);
  assert.equal((await move('vera', '', {seek_s: 1})).status, 403, 'what all see is for technicians and QA');
  assert.equal((await playback('quinn')).playing, true);
  const note = {method: 'POST', headers: bearer('vera'), body: JSON.stringify({at_s: 1, text: 'mine'})};
  assert.equal((await web.ask(`/playback/notes${query}`, note)).status, 403, 'notes are kept for all');
  mine.socket.destroy();
  await until('it ends with the page', async () => (await web.ask(`/playback${query}`, {headers: bearer('vera')})).status === 404);
});

test('a recording of the folder is for who may record: it is listed, opened, and noted in the audit log', async () => {
  const list = await web.ask('/sessions', {headers: bearer('dora')});
  assert.deepEqual(JSON.parse(list.text).sessions.map(({name}) => name), ['earlier.mcap']);
  assert.equal((await web.ask('/sessions', {headers: bearer('vera')})).status, 403);
  const query = (digit, name = 'earlier.mcap') => `?reading=${id(digit)}&session=${name}`;
  const denied = await watch('vera', query('b'));
  await until('a guest is told', () => denied.bytes.includes("the recorded session is not opened: the role viewer of vera lacks the right 'record'"));
  const open = await watch('dora', query('c'));
  await until('it plays', async () => (await playback('dora', query('c'))).position_s > 0.2);
  assert.match(readFileSync(join(folder, 'audit.log'), 'utf8'), /event=opened-session who=doctor dora session="earlier.mcap" program=browser/);
  const lost = await watch('dora', query('d', '..'));
  await until('a name that is not listed opens nothing', () => lost.bytes.includes('this server has no recorded session of this name'));
  for (const one of [denied, open, lost]) one.socket.destroy();
});

test('a topic is offered to those alone who may read the state', async () => {
  const [guest, doctor] = [await watch('vera', ''), await watch('dora', '')];
  const offers = (one, topic) => one.bytes.includes(`"topic":"${topic}"`);
  await until('the session is offered to both', () => offers(guest, '/playback/notes') && offers(doctor, '/playback/notes'));
  await until('the list is offered to the doctor', () => offers(doctor, '/sessions'));
  assert.equal(offers(guest, '/sessions'), false);
  const channel = /"id":(\d+),"topic":"\/sessions"/.exec(doctor.bytes.toString('latin1'))[1];
  const subscribe = frame(1, Buffer.from(`{"op":"subscribe","subscriptions":[{"id":99,"channelId":${channel}}]}`));
  for (const one of [guest, doctor]) one.socket.write(subscribe);
  await until('a guest who asks all the same is told', () => guest.bytes.includes(`there is no channel ${channel}`));
  await until('the doctor gets the list', () => doctor.bytes.includes('earlier.mcap'));
  assert.equal(guest.bytes.includes('earlier.mcap'), false);
  for (const one of [guest, doctor]) one.socket.destroy();
});

test('only who may record brings a session file, and only as whole parts in their order', async () => {
  const bytes = readFileSync(join(recordings, 'earlier.mcap'));
  const send = (name, part) => web.ask('/sessions', {method: 'POST', headers: bearer(name), body: JSON.stringify(part)});
  const part = (from, to, more) => ({name: 'new.mcap', from, data: bytes.subarray(from, to).toString('base64'), ...more});
  assert.equal((await send('vera', part(0, 10))).status, 403);
  assert.equal((await send('vera', part(0, 2000))).status, 413, 'a guest cannot send a long body');
  assert.equal((await send('dora', part(0, 700_000))).status, 200);
  assert.match((await send('dora', part(800_000, 900_000))).text, /does not follow the part that came last/);
  for (let from = 700_000; from < bytes.length; from += 700_000) {
    const to = Math.min(from + 700_000, bytes.length);
    assert.equal((await send('dora', part(from, to, {complete: to === bytes.length}))).status, 200);
  }
  assert.deepEqual(readFileSync(join(recordings, 'new.mcap')), bytes);
  const audit = () => readFileSync(join(folder, 'audit.log'), 'utf8');
  assert.match(audit(), new RegExp(`event=brought-session who=doctor dora session="new.mcap" bytes=${bytes.length} program=browser`));
  assert.match((await send('dora', part(0, 10))).text, /has a session of this name already/);
  const none = {name: 'none.mcap', from: 0, data: Buffer.from('no session').toString('base64'), complete: true};
  assert.match((await send('dora', none)).text, /this is no session file/);
  assert.match(audit(), /event=brought-session who=doctor dora session="none.mcap" refused="this is no session file/);
  for (const name of ['../x.mcap', '.x.mcap', 'x.txt', 'x y.mcap'])
    assert.match((await send('dora', {name, from: 0, data: 'AAAA'})).text, /this is no name of a session/, name);
});

test('at most eight sessions are open at a time, and the ninth reader is told', async () => {
  const open = [];
  for (let at = 0; at < 8; ++at) open.push(await watch('vera', `?reading=${id(String(at))}&at_s=1`));
  const ninth = await watch('vera', `?reading=${id('9')}&at_s=1`);
  await until('it is told', () => ninth.bytes.includes('8 recorded sessions are open'));
  for (const one of [...open, ninth]) one.socket.destroy();
  await until('a place is free again', async () => {
    const again = await watch('vera', `?reading=${id('e')}&at_s=1`);
    const isOpen = (await web.ask(`/playback?reading=${id('e')}`, {headers: bearer('vera')})).status === 200;
    again.socket.destroy();
    return isOpen;
  });
});
