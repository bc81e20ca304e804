// Rows of telepalp-bench site, section strangers: node strangers_rows.mjs PROGRAMS VIEWER
// Measures a real server on loopback: while strangers open connections, when keys are revoked, and which lines its
// audit log then has. Each address 127.0.N.1 stands for another network (/24) of the attacker.
import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync} from 'node:fs';
import http from 'node:http';
import net from 'node:net';
import {join} from 'node:path';

import {KeyedWeb} from '../../end_to_end/keyed_web.mjs';
import {sleep, until, Workplace} from '../../end_to_end/running_program.mjs';

const [programs, viewer] = process.argv.slice(2);
const CONNECTS_PER_S = 800;
const EVERY_MS = 10;
const HEALTH_ASKED = 32;
const WAIT_MS = 15_000;

const row = (...cells) => console.log(cells.join('\t'));
const place = new Workplace('strangers');
const folder = join(place.folder, 'keys');
const keys = (...words) => execFileSync(join(programs, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
const tokenOf = (name) => /^token: (.*)$/m.exec(readFileSync(join(folder, `${name}.token`), 'utf8'))[1];
const audit = () => readFileSync(join(folder, 'audit.log'), 'utf8');

/** Seconds until `happened` is true; infinite after WAIT_MS. */
async function secondsUntil(happened) {
  const began = performance.now();
  while (!happened() && performance.now() - began < WAIT_MS) await sleep(5);
  return happened() ? (performance.now() - began) / 1000 : Infinity;
}

/** Connections that send nothing, from `addresses` in turn, until end() is called. */
class SilentConnects {
  sockets = new Set();
  made = 0;

  constructor(port, addresses) {
    Object.assign(this, {port, addresses});
  }
  connect() {
    const localAddress = this.addresses[this.made++ % this.addresses.length];
    const socket = net.connect({host: '127.0.0.1', port: this.port, localAddress});
    this.sockets.add(socket);
    for (const over of ['error', 'close']) socket.on(over, () => this.sockets.delete(socket));
    socket.on('end', () => socket.destroy());
  }
  flood() {
    const began = performance.now();
    this.timer = setInterval(() => {
      const due = Math.floor(CONNECTS_PER_S * (performance.now() - began) / 1000);
      for (let burst = 0; this.made < due && burst < 100; ++burst) this.connect();
    }, EVERY_MS);
  }
  end() {
    clearInterval(this.timer);
    for (const socket of this.sockets) socket.destroy();
  }
}

const askHealth = (port) => new Promise((answered) => {
  const request = http.get({host: '127.0.0.1', port, path: '/health', agent: false, timeout: 2000}, (reply) => {
    reply.resume();
    answered(reply.statusCode === 200);
  });
  request.on('timeout', () => request.destroy());
  request.on('error', () => answered(false));
});

async function healthAnswered(port) {
  let answered = 0;
  for (let asked = 0; asked < HEALTH_ASKED; ++asked) answered += await askHealth(port) ? 1 : 0;
  return answered;
}

let recordings = 0;
/** Starts a recorder with the key `name`.key. Returns it, and the seconds until it has joined. */
async function join_s(server, name) {
  const ready = join(place.folder, `joined_${++recordings}`);
  const recorder = place.start(join(programs, 'telepalp-record'), ['--connect', `127.0.0.1:${server.port}`, '--key', join(folder, `${name}.key`),
    '--consent', 'none: a test', '--topics', '/clock', '--out', `${ready}.mcap`, '--ready-file', ready]);
  const joined_s = await secondsUntil(() => existsSync(ready));
  return {recorder, joined_s};
}

async function besideStrangers(server, what, reach_s, attack) {
  const floods = [server.port, server.http_port, server.health_port].map((port) => attack(port));
  await sleep(1000);
  const {recorder, joined_s} = await join_s(server, 'tom');
  row(`strangers: ${what}: a valid key joins`, joined_s, 's', 'at_most', reach_s);
  row(`strangers: ${what}: /health answered, of ${HEALTH_ASKED}`, await healthAnswered(server.health_port), '', 'at_least', HEALTH_ASKED);
  recorder.kill('SIGTERM');
  for (const flood of floods) flood.end();
  await recorder.over;
  await sleep(500);
}

async function strangers(server) {
  const {recorder, joined_s} = await join_s(server, 'tom');
  row('strangers: nobody: a valid key joins', joined_s, 's', 'none', 0);
  recorder.kill('SIGTERM');
  await recorder.over;
  const networks = Array.from({length: 64}, (_, n) => `127.0.${n + 1}.1`);
  await besideStrangers(server, '64 silent sockets', 1, (port) => {
    const silent = new SilentConnects(port, ['127.0.9.9']);
    for (let n = 0; n < 64; ++n) silent.connect();
    return silent;
  });
  for (const [what, addresses, reach_s] of [['one address', ['127.0.9.9'], 1], ['64 networks', networks, 3]])
    await besideStrangers(server, `${CONNECTS_PER_S} connects a second from ${what}`, reach_s, (port) => {
      const flood = new SilentConnects(port, addresses);
      flood.flood();
      return flood;
    });
}

async function signedIn(server, web, name) {
  const origin = `https://127.0.0.1:${server.http_port}`;
  const headers = {origin, 'content-type': 'application/x-www-form-urlencoded'};
  const reply = await web.ask('/sign-in', {method: 'POST', headers, body: `token=${tokenOf(name)}&consent=yes`});
  return web.upgrade({origin, cookie: reply.headers['set-cookie'][0].split(';')[0]});
}

/** Streams by key file, by token file, by cookie and by a token in a header: each has its lines in the audit log. */
async function streams(server, web) {
  const {recorder} = await join_s(server, 'rita');
  const cookie = await signedIn(server, web, 'cora');
  const address = await web.upgrade({authorization: `Bearer ${tokenOf('adam')}`});
  const view = place.start(join(programs, 'telepalp-view'), ['--connect', `127.0.0.1:${server.port}`, '--key', join(folder, 'theo.token'),
    '--consent', 'none: a test', '--snapshot', join(place.folder, 'view.png')]);
  await view.over;
  recorder.kill('SIGTERM');
  for (const {socket} of [cookie, address]) socket?.destroy();
  await recorder.over;
  await sleep(1000);
  const log = audit();
  const missing = ['rita', 'cora', 'adam', 'theo'].filter((name) => ['joined', 'left'].some((event) =>
    !new RegExp(`event=${event} who=\\w+ ${name} program=`).test(log)));
  if (missing.length > 0) console.error(`no lines of ${missing}: ${log}`);
  row('audit: streams without their lines, of 4', missing.length, '', 'at_most', 0);
  const verified = execFileSync(join(programs, 'telepalp-keys'), ['audit-verify', join(folder, 'audit.log'), '--anchors', join(folder, 'audit.log.anchors')], {encoding: 'utf8'});
  row('audit: anchors that match', Number(/(\d+) anchors? of the server match/.exec(verified)?.[1] ?? 0), '', 'at_least', 1);
}

async function revoked(server, web) {
  const {recorder} = await join_s(server, 'ruth');
  const address = await web.upgrade({authorization: `Bearer ${tokenOf('abel')}`});
  let over = false;
  recorder.once('exit', () => (over = true));
  keys('revoke', join(folder, 'ruth.key'));
  row('revoked: a key is still served after', await secondsUntil(() => over), 's', 'at_most', 2);
  keys('revoke', join(folder, 'abel.token'));
  row('revoked: a token is still served after', await secondsUntil(() => address.closed), 's', 'at_most', 2);
  const named = ['ruth', 'abel'].filter((name) => new RegExp(`who=\\w+ ${name} .*key=[0-9a-f]{20}`).test(audit()));
  row('revoked: named with its serial in the audit log, of 2', named.length, '', 'at_least', 2);
  const last = await signedIn(server, web, 'olga');
  keys('revoke', join(folder, 'server.key'));
  row('revoked: a server still serves after', await secondsUntil(() => last.closed), 's', 'at_most', 2);
  await until('the server ends', () => server.child.exitCode !== null, 10_000);
  const again = place.start(join(programs, 'telepalp-server'), ['--key', join(folder, 'server.key'), '--port', '0']);
  await again.over;
  row('revoked: a server starts again', again.exitCode === 0 ? 1 : 0, '', 'at_most', 0);
}

try {
  keys('authority', '--host', '127.0.0.1');
  keys('server', '--host', '127.0.0.1');
  for (const name of ['tom', 'rita', 'ruth']) keys('client', '--name', name, '--role', 'technician');
  for (const name of ['cora', 'adam', 'theo', 'abel', 'olga']) keys('token', '--name', name, '--role', 'viewer');
  const server = await place.server(join(programs, 'telepalp-server'),
    ['--source', 'synthetic', '--viewer', viewer, '--key', join(folder, 'server.key'), '--health-port', '0']);
  const web = new KeyedWeb(server.http_port, readFileSync(join(folder, 'authority.crt')));
  await strangers(server);
  await streams(server, web);
  await revoked(server, web);
} finally {
  await place.end();
}
