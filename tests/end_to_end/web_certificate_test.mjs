// A server with a hospital's ordinary certificate for browsers: node web_certificate_test.mjs BIN_DIR VIEWER_DIR
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {chmodSync, readFileSync, writeFileSync} from 'node:fs';
import https from 'node:https';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {until, Workplace} from './running_program.mjs';

const [bin, viewer] = process.argv.slice(2);
const workplace = new Workplace('web_certificate');
const site = join(workplace.folder, 'keys'), hospital = join(workplace.folder, 'hospital');
const keys = (folder, ...words) => execFileSync(join(bin, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
const web = {cert: join(workplace.folder, 'web.crt'), key: join(workplace.folder, 'web.key')};
const host = 'tele.hospital.example';
let server;

/** The hospital's authority is one that telepalp did not make: its server key only lends the certificate. */
function issue(name, days) {
  keys(hospital, 'server', '--name', name, '--host', host, '--days', `${days}`);
  const text = readFileSync(join(hospital, `${name}.key`), 'utf8');
  const [leaf, above] = text.match(/-----BEGIN CERTIFICATE-----[^]*?-----END CERTIFICATE-----\n/g);
  return {chain: leaf + above, secret: /-----BEGIN PRIVATE KEY-----[^]*?-----END PRIVATE KEY-----\n/.exec(text)[0]};
}
function install({chain, secret}) {
  writeFileSync(web.key, secret);
  chmodSync(web.key, 0o600);
  writeFileSync(web.cert, chain);
}

/** The page's status and the serial number of the certificate that the browser sees, or the error's code. */
function visit(ca, name = host) {
  return new Promise((resolve) => {
    const request = https.request({host: '127.0.0.1', port: server.http_port, path: '/health', ca, servername: name, agent: false,
      headers: {host: name}}, (reply) => {
      const {serialNumber, valid_to} = reply.socket.getPeerCertificate();
      reply.resume().on('end', () => resolve({status: reply.statusCode, serial: serialNumber, until: valid_to}));
    });
    request.on('error', (failed) => resolve({failed: failed.code}));
    request.end();
  });
}
const of = (folder) => readFileSync(join(folder, 'authority.crt'));

before(async () => {
  keys(site, 'authority', '--host', '127.0.0.1');
  keys(site, 'server', '--host', '127.0.0.1');
  keys(site, 'client', '--name', 'rita', '--role', 'technician');
  keys(hospital, 'authority', '--name', 'hospital', '--host', host);
  install(issue('first', 20));
  server = await workplace.server(join(bin, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer,
    '--key', join(site, 'server.key'), '--web-cert', web.cert, '--web-key', web.key]);
});
after(() => workplace.end());

test('a browser that trusts the hospital needs no authority of ours', async () => {
  const seen = await visit(of(hospital));
  assert.equal(seen.status, 200, JSON.stringify(seen));
  assert.match(server.child.heard, /browsers see the certificate of tele\.hospital\.example, valid until/);
  assert.ok((await visit(of(site))).failed, 'our authority did not make this certificate');
});

test('stations and recorders still check the key of the server', async () => {
  const file = join(workplace.folder, 'session.mcap');
  const recorder = workplace.start(join(bin, 'telepalp-record'), ['--connect', `127.0.0.1:${server.port}`, '--key', join(site, 'rita.key'),
    '--consent', 'none: a test', '--out', file, '--seconds', '1', '--patience', '20']);
  assert.equal(await recorder.over, 0, recorder.heard);
});

test('a renewed certificate is seen without a restart, and a damaged one is not taken', async () => {
  const {serial} = await visit(of(hospital));
  writeFileSync(web.cert, 'damaged');
  await until('the server says so', () => /the old web certificate stays: .*no certificate/.test(server.child.heard), 10_000);
  assert.equal((await visit(of(hospital))).serial, serial, 'the old one stays');
  install(issue('second', 40));
  await until('browsers see the new one', async () => (await visit(of(hospital))).serial !== serial, 10_000);
  assert.equal((await visit(of(hospital))).status, 200);
});

test('a server does not start with half of a certificate, another one’s key or an open key', async () => {
  const start = async (...words) => {
    const child = workplace.start(join(bin, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer, '--port', '0', '--http-port', '0', ...words]);
    return {code: await child.over, heard: child.heard};
  };
  const key = ['--key', join(site, 'server.key')];
  const half = await start(...key, '--web-cert', web.cert);
  assert.equal(half.code, 2);
  assert.match(half.heard, /--web-cert: this option has no effect without --web-key/);
  assert.equal((await start('--web-cert', web.cert, '--web-key', web.key)).code, 2, 'without keys there is no TLS');
  const other = join(workplace.folder, 'other.key');
  writeFileSync(other, issue('third', 20).secret);
  chmodSync(other, 0o600);
  assert.match((await start(...key, '--web-cert', web.cert, '--web-key', other)).heard, /is not that of the certificate/);
  chmodSync(other, 0o644);
  assert.match((await start(...key, '--web-cert', web.cert, '--web-key', other)).heard, /users other than its owner have access/);
});
