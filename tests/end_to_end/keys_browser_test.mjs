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
  keys('authority', '--host', '127.0.0.1');
  keys('server', '--host', '127.0.0.1');
  keys('client', '--name', 'anna', '--role', 'doctor');
  for (const [name, role] of [['dora', 'doctor'], ['vera', 'viewer'], ['quinn', 'qa'], ['studio', 'viewer'], ['walt', 'viewer'], ['meter', 'qa'],
    ['anna', 'doctor'], ['tina', 'technician']]) keys('token', '--name', name, '--role', role);
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
/** The cookie that each token got when it signed in. A browser sends its cookie when it signs in again. */
const cookies = new Map();
const cookieOf = (reply) => reply.headers['set-cookie'][0].split(';')[0];
async function signIn(token, from = origin, query = '', cookie = cookies.get(token)) {
  const headers = {origin: from, 'content-type': 'application/x-www-form-urlencoded', ...(cookie ? {cookie} : {})};
  const reply = await ask(`/sign-in${query}`, {method: 'POST', headers, body: `token=${token}&consent=yes`});
  if (reply.status === 303) cookies.set(token, cookieOf(reply));
  return reply;
}

test('without a token there is a page to sign in, and nothing of the patient', async () => {
  const page = await ask('/');
  assert.equal(page.status, 401);
  assert.match(page.text, /<form method="post" action="\/sign-in">/);
  assert.match(page.headers['content-security-policy'], /default-src 'none'/);
  for (const path of ['/', '/viewer.js', '/metrics'])
    assert.match((await ask(path)).headers['strict-transport-security'], /^max-age=31536000$/, `${path}: a browser comes back by HTTPS alone`);
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
  assert.match(reply.headers['set-cookie'][0], /^__Host-telepalp=[0-9a-f]{64}; Path=\/; Secure; HttpOnly; SameSite=Strict; Max-Age=\d+$/);
  const cookie = cookieOf(reply);
  assert.equal((await ask('/', {headers: {cookie}})).status, 200);
  const open = await upgrade({origin, cookie});
  assert.equal(open.status, 101);
  await until('the server greets', () => open.bytes.includes('serverInfo'));
  assert.match(open.bytes.toString(), /"role":"viewer"/);
  open.socket.destroy();
  assert.match(audit(), /event=signed-in who=viewer vera consent=stated/);
  assert.match(audit(), /event=joined who=viewer vera program="browser" from=127.0.0.1:\d+ viewer=\d+ by=cookie/);
  await until('the end of the stream is in the log', () => /event=left who=viewer vera program="browser"/.test(audit()));
  assert.ok(!audit().includes(tokenOf('vera')) && !server.child.heard.includes(tokenOf('vera')), 'no token is logged');
});

test('a page of an allowed origin brings its token in the address of the stream, and in no other address', async () => {
  const [token, subprotocol] = [tokenOf('studio'), 'foxglove.websocket.v1'];
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

test('nobody signs in to watch without stating that the patient has agreed', async () => {
  const headers = {origin, 'content-type': 'application/x-www-form-urlencoded'};
  const reply = await ask('/sign-in', {method: 'POST', headers, body: `token=${tokenOf('walt')}`});
  assert.equal(reply.status, 401);
  assert.match(reply.text, /Ask the patient, then check the box/);
});

test('the first browser that signs in with a token keeps it: whoever copies the token signs in nowhere else', async () => {
  const token = tokenOf('walt');
  assert.equal((await upgrade({origin: studio}, undefined, `/?token=${token}`)).status, 101, 'a program may use it until then');
  assert.equal((await signIn(token)).status, 303);
  const thief = await signIn(token, origin, '', '__Host-telepalp=0123456789abcdef');
  assert.equal(thief.status, 401);
  assert.match(thief.text, /another browser has signed in with the token of viewer walt/);
  assert.match(audit(), /event=refused who=viewer walt why="another browser has signed in with this token" from=127.0.0.1 key=\w+/);
  assert.equal((await upgrade({origin: studio}, undefined, `/?token=${token}`)).status, 401, 'a program is no browser');
  assert.equal((await signIn(token)).status, 303, 'the same browser signs in again');
});

test('bad input 22: guessed tokens are refused, audited and slowed down', async () => {
  for (let i = 0; i < 8; i++) assert.equal((await signIn('tp1.guess.guess')).status, 401);
  assert.match((await signIn('tp1.guess.guess')).text, /this token was wrong too often/);
  assert.match(audit(), /event=refused who=stranger why="this is not a token of/);
  assert.equal((await signIn(tokenOf('vera'))).status, 303, 'a colleague at the same address signs in meanwhile');
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
  assert.equal((await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('studio')}`}})).status, 403);
  const metrics = await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('meter')}`}});
  assert.equal(metrics.status, 200);
  assert.match(metrics.text, /^telepalp_published_messages_total\{topic="\/camera\/depth"\} [1-9]/m);
  assert.match(metrics.text, /^telepalp_refused_total [1-9]/m);
  assert.ok(!/vera|quinn|127\.0\.0\.1/.test(metrics.text), 'no person and no address');
});

test('moving, impairing or noting on a played session is for technician and QA, and is refused where none is played', async () => {
  for (const path of ['/playback', '/playback/network', '/playback/notes']) {
    const change = async (name) => ask(path, {method: 'POST', headers: {cookie: cookieOf(await signIn(tokenOf(name))), origin}});
    assert.equal((await ask(path)).status, 401, path);
    assert.equal((await change('vera')).status, 403, path);
    assert.equal((await change('dora')).status, 403, `${path}: a doctor touches, and does not change what others see`);
    assert.equal((await change('quinn')).status, 404, `${path}: this server captures`);
  }
});

test('bad input 22 to 28: the doctor who feels the patient meanwhile is not disturbed, and the server stays small', async () => {
  const published = async (topic) => {
    const {text} = await ask('/metrics', {headers: {authorization: `Bearer ${tokenOf('meter')}`}});
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

for (const [does, field, event] of [['re-arms the station', 0x38, 'rearmed'], ['accepts an object as skin', 0x40, 'accepted-object']])
  test(`only who may touch ${does} from a page, and the audit log says who`, () => commandIsAudited(field, event));

/** `field`: the tag of the command's field in ViewerHand. */
async function commandIsAudited(field, event) {
  const advertise = frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
    {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]})));
  const command = frame(2, Buffer.from([1, 1, 0, 0, 0, field, 1]));  // true
  const before = audit().length;
  const news = () => audit().slice(before);
  for (const name of ['vera', 'dora', 'anna']) {
    const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf(name)))});
    open.socket.write(advertise);
    open.socket.write(command);
    await until('the request is handled', () => open.bytes.includes('another doctor') || open.bytes.includes('another viewer holds') ||
        new RegExp(`event=(refused|${event}) who=\\w+ ${name} program=browser`).test(news()));
    open.socket.destroy();
  }
  assert.match(news(), /event=refused who=viewer vera program=browser/);
  assert.match(news(), new RegExp(`event=${event} who=doctor anna program=browser viewer=\\d+`));
  assert.doesNotMatch(news(), new RegExp(`event=${event} who=(viewer|doctor dora)`));
}

const advertiseHand = frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
  {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]})));

test("a second doctor's token does not move the first doctor's station", async () => {
  const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf('dora')))});
  open.socket.write(advertiseHand);
  open.socket.write(frame(2, handMessage()));
  await until('dora is told so', () => open.bytes.includes("the station is another doctor's"));
  open.socket.destroy();
  assert.doesNotMatch(audit(), /event=took-touch who=doctor dora program=browser/);
});

test('a technician sees who watches, sends a person out and lets the person in again', async () => {
  const tina = {cookie: cookieOf(await signIn(tokenOf('tina'))), origin};
  const people = async () => JSON.parse((await ask('/people', {headers: tina})).text);
  const command = (what) => ask('/people', {method: 'POST', headers: tina, body: JSON.stringify(what)});
  const open = await upgrade({origin, cookie: cookieOf(await signIn(tokenOf('walt')))});
  await until('the technician sees the watcher', async () => (await people()).people.some(({name}) => name === 'walt'));
  const walt = (await people()).people.find(({name}) => name === 'walt');
  assert.equal(walt.program, 'browser');
  assert.equal((await people()).holds_touch, 'anna');
  assert.match((await people()).anchor, /^anchor time=.* lines=\d+ hash=[0-9a-f]{64} signature=[0-9a-f]+$/);
  const vera = {cookie: cookieOf(await signIn(tokenOf('vera'))), origin};
  assert.equal((await ask('/people', {headers: vera})).status, 403, 'only technicians see who watches');
  assert.equal((await ask('/people', {method: 'POST', headers: vera, body: JSON.stringify({send_out: walt.key})})).status, 403);
  assert.equal((await command({send_out: walt.key})).status, 200);
  await until('the stream ends', () => open.closed, 2500);
  assert.match((await signIn(tokenOf('walt'))).text, /the technician has sent viewer walt out/);
  assert.match(audit(), /event=sent-out who=viewer walt by="technician tina"/);
  assert.deepEqual((await people()).sent_out.map(({name}) => name), ['walt']);
  assert.equal((await command({let_in: walt.key})).status, 200);
  assert.equal((await signIn(tokenOf('walt'))).status, 303);
});

test('a token that is revoked while its doctor holds the hand ends the stream, and the hand is free', async () => {
  const cookie = cookieOf(await signIn(tokenOf('anna')));
  const open = await upgrade({origin, cookie});
  open.socket.write(frame(1, Buffer.from(JSON.stringify({op: 'advertise', channels: [
    {id: 1, topic: '/viewer/hand', encoding: 'protobuf', schemaName: 'telepalp.msg.ViewerHand'}]}))));
  await until('the station follows the hand', () => {
    open.socket.write(frame(2, handMessage()));
    return station.heard.includes('the station follows the hand of this viewer');
  });
  assert.match(audit(), /event=took-touch who=doctor anna program=browser viewer=\d+/);
  keys('revoke', join(folder, 'anna.token'));
  await until('the stream ends', () => open.closed, 20_000);
  assert.match(audit(), /event=gave-touch who=doctor anna program=browser viewer=\d+ .*why="the connection ended"/);
  assert.equal((await ask('/', {headers: {cookie}})).status, 401);
  assert.match((await signIn(tokenOf('anna'))).text, /is revoked/);
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
