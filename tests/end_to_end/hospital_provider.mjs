// An OpenID Connect provider as a hospital has it (npm's oidc-provider), and the people whom it knows.
import {generateKeyPairSync} from 'node:crypto';
import https from 'node:https';

import Provider from '../npm/node_modules/oidc-provider/lib/index.js';

/** Whoever is not here has no group. The provider's log-in page takes any password. */
const PEOPLE = {
  'u-1': {preferred_username: 'anna.meier', name: 'Dr. Anna "Äpfel" Meier', groups: ['staff', 'palpation-doctors']},
  'u-2': {preferred_username: 'tina', name: 'Tina Tech', groups: ['palpation-it']},
};

/** A new key, as providers change it now and then. `kind`: rsa or ec. */
export function newKey(kid, kind = 'rsa') {
  const {privateKey} = kind === 'rsa' ? generateKeyPairSync('rsa', {modulusLength: 2048}) : generateKeyPairSync('ec', {namedCurve: 'P-256'});
  return {...privateKey.export({format: 'jwk'}), kid, use: 'sig', alg: kind === 'rsa' ? 'RS256' : 'ES256'};
}

/**
 * Listens at `port` by TLS. `asked` counts the requests for each path. The claims are told by the provider's userinfo
 * alone, as oidc-provider does by default.
 */
export async function startProvider({port, tls, client, keys, algorithm = 'RS256'}) {
  const provider = new Provider(`https://127.0.0.1:${port}`, {
    clients: [{...client, grant_types: ['authorization_code'], response_types: ['code'], id_token_signed_response_alg: algorithm}],
    claims: {openid: ['sub'], profile: ['name', 'preferred_username'], groups: ['groups']},
    findAccount: (_, id) => ({accountId: id, claims: () => ({sub: id, ...PEOPLE[id]})}),
    pkce: {required: () => true},
    jwks: {keys},
    cookies: {keys: ['only a test']},
  });
  const asked = {};
  const answer = provider.callback();
  const server = https.createServer(tls, (request, reply) => {
    const path = request.url.split('?')[0];
    asked[path] = (asked[path] ?? 0) + 1;
    answer(request, reply);
  });
  await new Promise((listens, fails) => server.once('error', fails).listen(port, '127.0.0.1', listens));
  const stop = () => new Promise((stopped) => {
    server.close(stopped);
    server.closeAllConnections();
  });
  return {asked, stop};
}
