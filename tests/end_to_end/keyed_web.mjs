// The web port of a server with keys, as any program reaches it.
import {randomBytes} from 'node:crypto';
import https from 'node:https';

export class KeyedWeb {
  /** `ca`: the certificate of the authority that signed the server's key. */
  constructor(port, ca) {
    Object.assign(this, {port, ca});
  }

  /** One request over HTTPS, without a redirect followed. */
  ask(path, {method = 'GET', headers = {}, body = ''} = {}) {
    return new Promise((resolve, reject) => {
      const request = https.request({host: '127.0.0.1', port: this.port, path, method, ca: this.ca, headers, agent: false,
        ...(headers.host ? {checkServerIdentity: () => undefined} : {})}, (reply) => {
        let text = '';
        reply.on('data', (part) => (text += part));
        reply.on('end', () => resolve({status: reply.statusCode, headers: reply.headers, text}));
      });
      request.on('error', reject);
      request.end(body);
    });
  }

  /** Opens a WebSocket; resolves with its status and, if it is open, the socket. */
  upgrade(headers, subprotocol = 'foxglove.websocket.v1', path = '/stream') {
    return new Promise((resolve, reject) => {
      const request = https.request({
        host: '127.0.0.1', port: this.port, path, ca: this.ca, agent: false,
        headers: {connection: 'Upgrade', upgrade: 'websocket', 'sec-websocket-version': '13',
          'sec-websocket-key': randomBytes(16).toString('base64'),
          ...(subprotocol ? {'sec-websocket-protocol': subprotocol} : {}), ...headers},
      }, (reply) => resolve({status: reply.statusCode}));
      request.on('upgrade', (reply, socket, head) => {
        const heard = {status: 101, socket, bytes: head, closed: false};
        socket.on('data', (part) => (heard.bytes = Buffer.concat([heard.bytes, part])));
        socket.on('close', () => (heard.closed = true));
        socket.on('error', () => (heard.closed = true));
        resolve(heard);
      });
      request.on('error', reject);
      request.end();
    });
  }
}

/** A client's frame of at most 65535 bytes, masked as the protocol demands. */
export function frame(opcode, payload) {
  const head = payload.length < 126 ? [0x80 | opcode, 0x80 | payload.length] : [0x80 | opcode, 0xfe, payload.length >> 8, payload.length & 255];
  return Buffer.concat([Buffer.from(head), Buffer.alloc(4), payload]);
}
