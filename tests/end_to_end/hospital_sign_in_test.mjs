// People sign in at a hospital's own provider, in a browser: node hospital_sign_in_test.mjs BIN_DIR VIEWER_DIR [PICTURES]
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {chmodSync, readFileSync, writeFileSync} from 'node:fs';
import https from 'node:https';
import net from 'node:net';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {openBrowser, savePicture, untilStatus} from './browser.mjs';
import {newKey, startProvider} from './hospital_provider.mjs';
import {KeyedWeb} from './keyed_web.mjs';
import {until, Workplace} from './running_program.mjs';

const [bin, viewer, pictures] = process.argv.slice(2);
const place = new Workplace('hospital_sign_in');
const site = join(place.folder, 'keys'), hospital = join(place.folder, 'hospital');
const keys = (folder, ...words) => execFileSync(join(bin, 'telepalp-keys'), [...words, '--dir', folder], {encoding: 'utf8'});
const audit = () => readFileSync(join(site, 'audit.log'), 'utf8');
const settings = join(place.folder, 'hospital.sign_in.textproto');
const secret = 's3cret/+ %of: the client';
const firstKey = newKey('first');
let provider, providers, server, browser, origin, began_ms;

const freePort = () => new Promise((found) => {
  const one = net.createServer().listen(0, '127.0.0.1', () => {
    const {port} = one.address();
    one.close(() => found(port));
  });
});

function writeSettings(issuer, more = 'authority_file: "hospital/authority.crt"') {
  writeFileSync(join(place.folder, 'secret'), `${secret}\n`);
  chmodSync(join(place.folder, 'secret'), 0o600);
  writeFileSync(settings, `issuer: "${issuer}"\nclient_id: "telepalp"\nclient_secret_file: "secret"\npage: "${origin}"\nscope: "groups"\n${more}
rule { claim: "groups" value: "palpation-doctors" role: "doctor" }\nrule { claim: "groups" value: "palpation-it" role: "technician" }\n`);
}

before(async () => {
  keys(site, 'authority', '--host', '127.0.0.1');
  keys(site, 'server', '--host', '127.0.0.1');
  keys(site, 'token', '--name', 'vera', '--role', 'viewer');
  keys(hospital, 'authority', '--name', 'hospital', '--host', '127.0.0.1');
  keys(hospital, 'server', '--name', 'provider', '--host', '127.0.0.1');
  const text = readFileSync(join(hospital, 'provider.key'), 'utf8');
  const tls = {cert: /-----BEGIN CERTIFICATE-----[^]*?-----END CERTIFICATE-----/.exec(text)[0], key: /-----BEGIN PRIVATE KEY-----[^]*?-----END PRIVATE KEY-----/.exec(text)[0]};
  const [web, login] = [await freePort(), await freePort()];
  origin = `https://127.0.0.1:${web}`;
  const client = {client_id: 'telepalp', client_secret: secret, redirect_uris: [`${origin}/sign-in/back`]};
  providers = {port: login, tls, client, keys: [firstKey]};
  provider = await startProvider(providers);
  writeSettings(`https://127.0.0.1:${login}`);
  server = await place.server(join(bin, 'telepalp-server'), ['--source', 'synthetic', '--viewer', viewer, '--key', join(site, 'server.key'),
    '--http-port', `${web}`, '--sign-in', settings]);
  browser = await openBrowser(place.folder, {width: 1000, height: 760}, {ignoreHTTPSErrors: true});
});
after(async () => {
  await browser?.context.close();
  await provider?.stop();
  await place.end();
});

/** A request without a browser, from a stranger's address. */
const ask = (path, options = {}, body = '') => new Promise((resolve, reject) => {
  https.request(`${origin}${path}`, {rejectUnauthorized: false, localAddress: '127.0.0.2', agent: options.agent ?? false, ...options}, (reply) => {
    let heard = '';
    reply.on('data', (part) => (heard += part));
    reply.on('end', () => resolve({status: reply.statusCode, headers: reply.headers, text: heard}));
  }).on('error', reject).end(body);
});

/** Goes from the server's page through the provider's log-in of `login`, until the server's page is there again. */
async function signIn(login, query = '') {
  const {page, context} = browser;
  await context.clearCookies();
  await page.goto(`${origin}/${query}`);
  await page.check('form[action^="/sign-in/hospital"] input[name=consent]');
  await page.getByRole('button', {name: 'Sign in with your hospital\'s account'}).click();
  await page.locator('input[name=login]').waitFor();
  await savePicture(page, pictures, 'provider');
  await page.fill('input[name=login]', login);
  await page.fill('input[name=password]', 'any');
  await page.click('button[type=submit]');
  await page.getByRole('button', {name: 'Continue'}).click();
  await until('the page is led on, or says why not', async () => {
    const {origin: at, pathname} = new URL(page.url());
    return at === origin && (pathname === '/' || await page.locator('[role=alert]').count().catch(() => 0) > 0);
  });
}
const alertOf = (page) => page.locator('[role=alert]').textContent();

test('the page offers the hospital\'s account beside the token, and asks for the patient\'s consent', async () => {
  const {page} = browser;
  await page.goto(`${origin}/?view=doctor`);
  await savePicture(page, pictures, 'sign_in');
  assert.equal(await page.getAttribute('form >> nth=0', 'action'), '/sign-in/hospital?view=doctor');
  assert.equal(await page.locator('input[name=token]').isVisible(), false);
  await page.click('summary');
  assert.equal(await page.locator('input[name=token]').isVisible(), true);
  await savePicture(page, pictures, 'sign_in_token');
  const headers = {origin, 'content-type': 'application/x-www-form-urlencoded'};
  assert.match((await ask('/sign-in/hospital', {method: 'POST', headers})).text, /Ask the patient, then check the box/);
  assert.equal((await ask('/sign-in/hospital', {method: 'POST', headers: {...headers, origin: 'https://evil.example'}}, 'consent=yes')).status, 403);
});

test('a doctor comes through the provider\'s log-in to the live patient, with the rights of her group, and the audit log names her', async () => {
  const {page, problems, context} = browser;
  problems.length = 0;
  began_ms = Date.now();
  await signIn('u-1', '?view=doctor');
  await untilStatus(page, 'the live patient is drawn', (now) => now.connected && now.meshVertices > 200);
  await savePicture(page, pictures, 'live');
  assert.equal(page.url(), `${origin}/?view=doctor`);
  assert.match(audit(), /event=signed-in who=doctor anna\.meier consent=stated name="Dr\. Anna 'Äpfel' Meier" issuer="https:\/\/127\.0\.0\.1:\d+" sub="u-1" program=browser from=127\.0\.0\.1 key=[0-9a-f]{40}$/m);
  assert.match(audit(), /event=joined who=doctor anna\.meier program="browser" .* by=cookie/);
  const cookies = await context.cookies(origin);
  const [own] = cookies.filter(({name}) => name === '__Host-telepalp');
  assert.deepEqual([own.httpOnly, own.secure, own.sameSite], [true, true, 'Strict']);
  const hours = (own.expires - Date.now() / 1000) / 3600;
  assert.ok(hours > 7.9 && hours <= 8, `${hours} h`);
  assert.equal(cookies.some(({name}) => name === '__Host-telepalp-log-in'), false, 'the cookie of the log-in is gone');
  assert.deepEqual(await page.evaluate(async () => [(await fetch('/people')).status, (await fetch('/sign-out')).status]), [403, 200], 'a doctor is no technician');
  assert.ok(!server.child.heard.includes(secret) && !audit().includes(secret), 'no secret is logged');
});

test('signing out ends it', async () => {
  const {page} = browser;
  await page.goto(`${origin}/sign-out`);
  await savePicture(page, pictures, 'sign_out');
  await page.getByRole('button', {name: 'Sign out'}).click();
  await page.getByRole('button', {name: 'Sign in with your hospital\'s account'}).waitFor();
  assert.match(audit(), /event=signed-out who=doctor anna\.meier/);
});

test('what comes back from the provider is taken once, and from the browser that began', async () => {
  const {page} = browser;
  let back, sent;
  const listen = async (request) => {
    if (!request.url().startsWith(`${origin}/sign-in/back`)) return;
    back = request.url();
    sent = (await request.allHeaders()).cookie;
  };
  page.on('request', listen);
  await signIn('u-1');
  page.off('request', listen);
  const path = back.slice(origin.length);
  const other = await ask(path);
  assert.equal(other.status, 401);
  assert.match(other.text, /this browser did not begin this log-in/);
  assert.equal(other.headers['set-cookie'], undefined);
  const replayed = await ask(path, {headers: {cookie: sent}});
  assert.match(replayed.text, /has ended it already/, 'also with the cookie of the browser');
  await page.goto(back);
  assert.match(await alertOf(page), /this browser did not begin this log-in, has ended it already/);
  await savePicture(page, pictures, 'replayed');
  assert.match(audit(), /event=refused who=stranger why="this browser did not begin this log-in/);
});

test('a person of no group stays outside, and a page says so', async () => {
  const {page} = browser;
  await signIn('u-3');
  assert.match(await alertOf(page), /^your hospital's account \(person-[0-9a-f]{6}\) has no role here\. ask the technician/i);
  await savePicture(page, pictures, 'no_role');
  assert.match(audit(), /event=refused who=stranger why="your hospital's account \(person-[0-9a-f]{6}\) has no role here"/);
  assert.equal((await page.request.get(`${origin}/viewer.js`)).status(), 401);
});

test('a technician of the hospital sends the doctor out, who signs in again only when she is let in', async () => {
  const {page, context} = browser;
  await signIn('u-1');
  const cookie = (await context.cookies(origin)).map(({name, value}) => `${name}=${value}`).join('; ');
  const web = new KeyedWeb(Number(new URL(origin).port), readFileSync(join(site, 'authority.crt')));
  const open = await web.upgrade({origin, cookie});
  assert.equal(open.status, 101);
  await until('the server greets her', () => open.bytes.includes('"role":"doctor"'));
  const command = (what) => page.evaluate(async (body) => (await fetch('/people', {method: 'POST', body})).status, JSON.stringify(what));
  await signIn('u-2');
  const {people} = await page.evaluate(async () => (await fetch('/people')).json());
  const {key} = people.find(({name}) => name === 'anna.meier');
  assert.equal(await command({send_out: key}), 200);
  await until('her stream ends', () => open.closed, 5000);
  await signIn('u-1');
  assert.match(await alertOf(page), /^the technician has sent doctor anna\.meier out/);
  await signIn('u-2');
  assert.equal(await command({let_in: key}), 200);
  await signIn('u-1');
  await untilStatus(page, 'she sees the patient again', (now) => now.connected && now.meshVertices > 200);
});

test('within a minute, a key that the server does not know is not asked for again', async () => {
  const {page} = browser;
  await provider.stop();
  provider = await startProvider({...providers, keys: [newKey('second')]});
  await signIn('u-1');
  assert.match(await alertOf(page), /signed with none of the provider's keys/);
  assert.ok(Date.now() < began_ms + 60_000, 'else this test says nothing');
  assert.equal(provider.asked['/jwks'], undefined);
  await provider.stop();
  provider = await startProvider(providers);
});

test('ten thousand log-ins that a stranger begins, and as many that come back, keep nobody out', async () => {
  const agent = new https.Agent({keepAlive: true, maxSockets: 24, localAddress: '127.0.0.2'});
  const peak_kB = () => Number(/^VmHWM:\s+(\d+)/m.exec(readFileSync(`/proc/${server.child.pid}/status`, 'utf8'))[1]);
  const [before_kB, lines] = [peak_kB(), audit().split('\n').length];
  const headers = {origin, 'content-type': 'application/x-www-form-urlencoded'};
  let left = 10_000;
  const counts = {};
  const stranger = async () => {
    while (left-- > 0) {
      const begun = await ask('/sign-in/hospital', {agent, method: 'POST', headers}, 'consent=yes');
      const back = await ask(`/sign-in/back?state=${'0'.repeat(64)}${left}&code=x`, {agent});
      for (const status of [`begun ${begun.status}`, `back ${back.status}`]) counts[status] = (counts[status] ?? 0) + 1;
    }
  };
  const flood = Promise.all(Array.from({length: 20}, stranger));
  const began = Date.now();
  await signIn('u-1');
  const {page} = browser;
  await untilStatus(page, 'a doctor comes in meanwhile', (now) => now.connected && now.meshVertices > 200);
  const meanwhile_s = (Date.now() - began) / 1000;
  const wasOn = left > 0;
  await flood;
  console.log(`${JSON.stringify(counts)}; the doctor was in after ${meanwhile_s.toFixed(1)} s; the server grew by ${peak_kB() - before_kB} kB`);
  assert.ok(wasOn, 'the stranger was still there');
  assert.equal(counts['back 401'], 10_000);
  assert.equal(provider.asked['/token'], 1, 'the provider is asked about the doctor alone');
  assert.ok(audit().split('\n').length - lines < 100, 'the audit log stays short');
  assert.ok(peak_kB() - before_kB < 40 * 1024, `${peak_kB() - before_kB} kB`);
  agent.destroy();
});

test('a new key of the provider is fetched', async () => {
  const {page} = browser;
  await provider.stop();
  provider = await startProvider({...providers, keys: [newKey('second', 'ec')], algorithm: 'ES256'});
  await until('a minute has passed', () => Date.now() > began_ms + 61_000, 61_000);
  await signIn('u-1');
  await untilStatus(page, 'the live patient is drawn', (now) => now.connected && now.meshVertices > 200);
  assert.equal(provider.asked['/jwks'], 1);
});

test('when the provider does not answer, the page says so, and tokens still sign in', async () => {
  const {page, context} = browser;
  await provider.stop();
  await context.clearCookies();
  await page.goto(origin);
  const began = Date.now();
  // The provider's addresses are known: the browser itself finds nobody there. What comes back fails at the server.
  const begun = await ask('/sign-in/hospital', {method: 'POST', headers: {origin, 'content-type': 'application/x-www-form-urlencoded'}}, 'consent=yes');
  const cookie = begun.headers['set-cookie'][0].split(';')[0];
  const state = /[?&]state=([0-9a-f]+)/.exec(begun.text.replaceAll('&amp;', '&'))[1];
  const back = await ask(`/sign-in/back?state=${state}&code=x`, {headers: {cookie}});
  assert.equal(back.status, 401);
  assert.match(back.text, /the hospital's log-in does not work now: .*connect.*Tell the technician/);
  assert.ok(Date.now() - began < 6000);
  await until('the server names the address', () => /a log-in at the hospital failed: https:\/\/127\.0\.0\.1:\d+\/token: /.test(server.child.heard), 5000);
  await page.click('summary');
  await page.fill('input[name=token]', /^token: (.*)$/m.exec(readFileSync(join(site, 'vera.token'), 'utf8'))[1]);
  await page.check('details input[name=consent]');
  await page.getByRole('button', {name: 'Sign in', exact: true}).click();
  await untilStatus(page, 'the live patient is drawn', (now) => now.connected && now.meshVertices > 200);
});

test('a server that has not reached the provider says so on the page; --check says it before', async () => {
  const port = await freePort();
  const own = origin;
  origin = `https://127.0.0.1:${port}`;
  writeSettings(`https://127.0.0.1:${providers.port}`);
  const words = ['--source', 'synthetic', '--viewer', viewer, '--key', join(site, 'server.key'), '--audit', join(place.folder, 'audit.log'), '--sign-in', settings];
  const check = place.start(join(bin, 'telepalp-server'), [...words, '--http-port', `${port}`, '--check']);
  await check.over;
  assert.match(check.heard, /hospital's log-in.*(refused|connect)/i);
  await place.server(join(bin, 'telepalp-server'), [...words, '--http-port', `${port}`]);
  const {page, context} = browser;
  await context.clearCookies();
  await page.goto(origin);
  await page.check('input[name=consent] >> nth=0');
  await page.getByRole('button', {name: 'Sign in with your hospital\'s account'}).click();
  assert.match(await alertOf(page), /^the hospital's log-in does not work now: .*connect.*Tell the technician, or sign in with a token$/);
  await savePicture(page, pictures, 'provider_gone');
  // With the provider back, but certified by nobody whom this computer trusts:
  provider = await startProvider({...providers, client: {...providers.client, redirect_uris: [`${origin}/sign-in/back`]}});
  writeSettings(`https://127.0.0.1:${providers.port}`, '');
  const distrusts = place.start(join(bin, 'telepalp-server'), [...words, '--http-port', '0', '--check']);
  await distrusts.over;
  assert.match(distrusts.heard, /hospital's log-in.*certificate/i);
  writeSettings(`https://127.0.0.1:${providers.port}/other`);
  const misnamed = place.start(join(bin, 'telepalp-server'), [...words, '--http-port', '0', '--check']);
  await misnamed.over;
  assert.match(misnamed.heard, /hospital's log-in/);
  assert.ok(!misnamed.heard.includes('answers; it must know'));
  origin = own;
});
