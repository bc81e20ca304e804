// The web port of a server with keys, as a browser and as a stranger use it: node keys_browser_test.mjs BIN_DIR VIEWER_DIR
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import http from 'node:http';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {frame, KeyedWeb} from './keyed_web.mjs';
import {sleep, until, Workplace} from './running_program.mjs';

const [bin, viewer] = process.argv.slice(2);
const workplace = new Workplace('keys');
const folder = join(workplace.folder, 'keys');
const keys = (...words) => execFileSync(join(bin, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
const tokenOf = (name) => /^token: (.*)$/m.exec(readFileSync(join(folder, `${name}.token`), 'utf8'))[1];
const audit = () => readFileSync(join(folder, 'audit.log'), 'utf8');
const studio = 'https://studio.example';
let server, station, web, origin;

before(async () => {
  keys('authority');
  keys('server', '--host', '127.0.0.1');
  keys('client', '--name', 'anna', '--role', 'doctor');
  for (const [name, role] of [['dora', 'doctor'], ['vera', 'viewer'], ['quinn', 'qa']]) keys('token', '--name', name, '--role', role);
  server = await workplace.server(join(bin, 'telepalp-server'),
    ['--source', 'synthetic', '--viewer', viewer, '--key', join(folder, 'server.key'), '--allow-origin', studio]);
  web = new KeyedWeb(server.http_port, readFileSync(join(folder, 'authority.crt')));
  origin = `https://127.0.0.1:${server.http_port}`;
  // A doctor feels the patient while all this happens; the last tests look whether she was disturbed.
  station = workplace.start(join(bin, 'telepalp-station'), ['--connect', `127.0.0.1:${server.port}`, '--patience', '60',
    '--key', join(folder, 'anna.key'), '--tracker', 'browser', '--control', join(workplace.folder, 'control'), '--state-dir', workplace.folder]);
  await until('the station ticks', () => station.heard.includes('control loop runs at 2 kHz'));
});
after(() => workplace.end());

const ask = (...request) => web.ask(...request);
const upgrade = (...request) => web.upgrade(...request);
const signIn = (token, from = origin, query = '') =>
  ask(`/sign-in${query}`, {method: 'POST', headers: {origin: from, 'content-type': 'application/x-www-form-urlencoded'}, body: `token=${token}`});
const cookieOf = (reply) => reply.headers['set-cookie'][0].split(';')[0];

test('without a token there is a page to sign in, and nothing of the patient', async () => {
  const page = await ask('/');
  assert.equal(page.status, 401);
  assert.match(page.text, /<form method="post" action="\/sign-in">/);
  assert.match(page.headers['content-security-policy'], /default-src 'none'/);
  const asked = await ask('/?view=qa&at_s=12.5');
  assert.equal(asked.status, 401);
  assert.match(asked.text, /action="\/sign-in\?view=qa&amp;at_s=12.5"/, 'a shared address is kept over the sign-in');
  assert.match((await ask('/?view="><script>')).text, /action="\/sign-in">/);
  assert.equal((await ask('/viewer.js')).status, 401);
  assert.equal((await ask('/metrics')).status, 401);
  assert.equal((await upgrade({origin})).status, 401);
});

test('a token signs in, by a cookie that scripts cannot read and other pages cannot use', async () => {
  const reply = await signIn(tokenOf('vera'));
  assert.equal(reply.status, 303);
  assert.equal(reply.headers.location, '/');
  assert.equal((await signIn(tokenOf('quinn'), origin, '?view=qa&at_s=12.5')).headers.location, '/?view=qa&at_s=12.5');
  assert.match(reply.headers['set-cookie'][0], /^__Host-telepalp=[0-9a-f]{64}; Path=\/; Secure; HttpOnly; SameSite=Strict$/);
  const cookie = cookieOf(reply);
  assert.equal((await ask('/', {headers: {cookie}})).status, 200);
  const open = await upgrade({origin, cookie});
  assert.equal(open.status, 101);
  await until('the server greets', () => open.bytes.includes('serverInfo'));
  assert.match(open.bytes.toString(), /"role":"viewer"/);
  open.socket.destroy();
  assert.match(audit(), /event=signed-in who=viewer vera/);
  assert.ok(!audit().includes(tokenOf('vera')) && !server.child.heard.includes(tokenOf('vera')), 'no token is logged');
});

test('a page of an allowed origin brings its token in the address of the stream, and in no other address', async () => {
  const [token, subprotocol] = [tokenOf('vera'), 'foxglove.websocket.v1'];
  const open = await upgrade({origin: studio}, subprotocol, `/?token=${token}`);
  assert.equal(open.status, 101);
  await until('the server greets', () => open.bytes.includes('serverInfo'));
  open.socket.destroy();
  assert.equal((await upgrade({origin: studio}, subprotocol, '/')).status, 401);
  assert.equal((await upgrade({origin: studio}, subprotocol, `/?token=${token}x`)).status, 401);
  assert.equal((await upgrade({origin: 'https://evil.example'}, subprotocol, `/?token=${token}`)).status, 403);
  assert.equal((await ask(`/?token=${token}`)).status, 401, 'the address of a page stays in histories');
  assert.ok(!audit().includes(token) && !server.child.heard.includes(token), 'no token is logged');
});

test('bad input 22: guessed tokens are refused, audited and slowed down', async () => {
  for (let i = 0; i < 8; i++) assert.equal((await signIn(`tp1.guess${i}.guess`)).status, 401);
  assert.match((await signIn('tp1.guess.guess')).text, /too many wrong tokens/);
  assert.match(audit(), /event=refused who=stranger why="this is not a token of/);
  const started = Date.now();
  await until('a right token is taken again', async () => (await signIn(tokenOf('vera'))).status === 303, 30_000);
  assert.ok(Date.now() - started > 500);
});

test('bad input 23: a viewer that sends a haptic command is denied', async () => {
  const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf('vera')))});
  open.socket.write(frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
    {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]}))));
  open.socket.write(frame(2, Buffer.from([1, 1, 0, 0, 0])));
  await until('it is told so', () => open.bytes.includes("lacks the right 'touch'"));
  assert.match(audit(), /event=refused who=viewer vera program=browser why="the role viewer of vera lacks the right 'touch'"/);
  open.socket.destroy();
});

test('bad input 24: after signing out the cookie opens nothing, and open streams end', async () => {
  const cookie = cookieOf(await signIn(tokenOf('dora')));
  const open = await upgrade({origin, cookie});
  assert.equal(open.status, 101);
  assert.equal((await ask('/sign-out', {method: 'POST', headers: {cookie, origin}})).status, 303);
  assert.equal((await ask('/', {headers: {cookie}})).status, 401);
  assert.equal((await upgrade({origin, cookie})).status, 401);
  await until('the stream ends', () => open.closed, 5000);
  assert.match(audit(), /event=signed-out who=doctor dora/);
});

test('bad input 25: no name leads out of the viewer\'s folder', async () => {
  const cookie = cookieOf(await signIn(tokenOf('vera')));
  const secret = readFileSync(join(folder, 'server.key'), 'utf8').split('\n')[1];
  for (const path of ['/../keys/server.key', '/..%2fkeys%2fserver.key', '/%2e%2e/%2e%2e/etc/passwd', '//etc/passwd',
    '/viewer.js/../../../../../../etc/passwd', '/viewer.js%00.html', '/./viewer.js', '/' + 'a'.repeat(4000)]) {
    const reply = await ask(path, {headers: {cookie}});
    assert.ok(reply.status >= 400, `${path}: ${reply.status}`);
    assert.ok(!reply.text.includes('root:') && !reply.text.includes(secret), path);
  }
});

test('bad input 26: a foreign origin neither signs in nor opens the stream', async () => {
  const cookie = cookieOf(await signIn(tokenOf('vera')));
  for (const foreign of ['https://evil.example', 'null', 'https://127.0.0.1']) {
    assert.equal((await signIn(tokenOf('vera'), foreign)).status, 403, foreign);
    assert.equal((await upgrade({origin: foreign, cookie})).status, 403, foreign);
  }
  assert.equal((await signIn(tokenOf('vera'), '')).status, 403, 'a browser names the origin of a form');
  assert.equal((await ask('/', {headers: {cookie, host: 'evil.example'}})).status, 421);
});

test('bad input 27: a message that is too long closes the stream with 1009', async () => {
  const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf('vera')))});
  open.socket.write(Buffer.concat([Buffer.from([0x82, 0xff, 0, 0, 0, 0, 0, 2, 0, 0]), Buffer.alloc(4 + 1024)]));
  await until('1009', () => open.bytes.includes(Buffer.from([0x03, 0xf1])));
  open.socket.destroy();
});

test('bad input 28: without the subprotocol an upgrade is a bad request', async () => {
  const cookie = cookieOf(await signIn(tokenOf('vera')));
  assert.equal((await upgrade({origin, cookie}, '')).status, 400);
});

test('metrics are for technician and QA, health is for everyone', async () => {
  const health = await ask('/health');
  assert.equal(health.status, 200);
  assert.equal(health.text, 'ok\n');
  assert.equal((await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('vera')}`}})).status, 403);
  const metrics = await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('quinn')}`}});
  assert.equal(metrics.status, 200);
  assert.match(metrics.text, /^telepalp_published_messages_total\{topic="\/camera\/depth"\} [1-9]/m);
  assert.match(metrics.text, /^telepalp_refused_total [1-9]/m);
  assert.ok(!/vera|quinn|127\.0\.0\.1/.test(metrics.text), 'no person and no address');
});

test('moving, impairing or noting on a played session is for technician and QA, and is refused where none is played', async () => {
  for (const path of ['/playback', '/playback/network', '/playback/notes']) {
    const change = (name) => ask(path, {method: 'POST', headers: {authorization: `Bearer ${tokenOf(name)}`}});
    assert.equal((await ask(path)).status, 401, path);
    assert.equal((await change('vera')).status, 403, path);
    assert.equal((await change('dora')).status, 403, `${path}: a doctor touches, and does not change what others see`);
    assert.equal((await change('quinn')).status, 404, `${path}: this server captures`);
  }
});

test('bad input 22 to 28: the doctor who feels the patient meanwhile is not disturbed, and the server stays small', async () => {
  const published = async (topic) => {
    const {text} = await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('quinn')}`}});
    return Number(new RegExp(`^telepalp_published_messages_total\\{topic="${topic}"\\} (\\d+)$`, 'm').exec(text)?.[1]);
  };
  const before = {states: await published('/station/state'), surfaces: await published('/station/surface')};
  await until('the station still publishes its state', async () => await published('/station/state') > before.states + 100);
  await until('images still become touchable', async () => await published('/station/surface') > before.surfaces + 20);
  assert.ok(!/link lost|fault:/.test(station.heard), station.heard);
  const peak_kB = Number(/^VmHWM:\s+(\d+)/m.exec(readFileSync(`/proc/${server.child.pid}/status`, 'utf8'))[1]);
  assert.ok(peak_kB < 200 * 1024, `${peak_kB} kB`);
});

/** A message of /viewer/hand on channel 1: `hand_camera` at 0.7 m before the camera. */
function handMessage() {
  const vector = Buffer.alloc(27);
  for (const [at, value] of [[0, 0], [9, 0], [18, 0.7]]) {
    vector[at] = 0x09 + 8 * (at / 9);  // fields 1 to 3, 64 bits each
    vector.writeDoubleLE(value, at + 1);
  }
  return Buffer.concat([Buffer.from([1, 1, 0, 0, 0, 0x1a, vector.length]), vector]);
}

test('only who may touch re-arms the station from a page, and the audit log says who', async () => {
  const advertise = frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
    {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]})));
  const rearm = frame(2, Buffer.from([1, 1, 0, 0, 0, 0x38, 1]));  // field 7: true
  for (const name of ['vera', 'dora']) {
    const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf(name)))});
    open.socket.write(advertise);
    open.socket.write(rearm);
    await until('the request is handled', () => new RegExp(`event=(refused|rearmed) who=\\w+ ${name} program=browser`).test(audit()));
    open.socket.destroy();
  }
  assert.match(audit(), /event=refused who=viewer vera program=browser/);
  assert.match(audit(), /event=rearmed who=doctor dora program=browser viewer=\d+/);
  assert.doesNotMatch(audit(), /event=rearmed who=viewer/);
});

test('a token that is revoked while its doctor holds the hand ends the stream, and the hand is free', async () => {
  const cookie = cookieOf(await signIn(tokenOf('dora')));
  const open = await upgrade({origin, cookie});
  open.socket.write(frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
    {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]}))));
  await until('the station follows the hand', () => {
    open.socket.write(frame(2, handMessage()));
    return station.heard.includes('the station follows the hand of this viewer');
  });
  assert.match(audit(), /event=took-touch who=doctor dora program=browser viewer=\d+/);
  keys('revoke', join(folder, 'dora.token'));
  await until('the stream ends', () => open.closed, 20_000);
  assert.match(audit(), /event=gave-touch who=doctor dora program=browser viewer=\d+ why="the connection ended"/);
  assert.equal((await ask('/', {headers: {cookie}})).status, 401);
  assert.match((await signIn(tokenOf('dora'))).text, /is revoked/);
});

test('plain HTTP is told to begin with https', async () => {
  const text = await new Promise((resolve, reject) => {
    http.get({host: '127.0.0.1', port: server.http_port, agent: false}, (reply) => {
      let heard = '';
      reply.on('data', (part) => (heard += part));
      reply.on('end', () => resolve(heard));
    }).on('error', reject);
  });
  assert.match(text, /this port speaks HTTPS/);
});

test('the audit log of all this is whole', async () => {
  server.child.kill('SIGTERM');
  await server.child.over;
  await sleep(50);
  assert.match(keys('audit-verify', join(folder, 'audit.log')), /none altered/);
});
