import {FoxgloveClient, type Channel, type SubscriptionId} from '@foxglove/ws-protocol';

import type {OwnTopics, Topics} from '../messages/topics';
import {decoderFor, encoderFor, type Decode, type Encode} from './schemas';
import {now_ms} from './session_clock';

const FIRST_RETRY_MS = 500;
const SLOWEST_RETRY_MS = 5000;
/** After this time without any message the connection counts as lost. */
const SILENCE_MS = 10_000;

type Handlers = {[Topic in keyof Topics]?: (message: Topics[Topic], published_ns: bigint, bytes: number) => void};

interface Listeners {
  connected(): void;
  warned(text: string): void;
  withdrawn(topic: string): void;     // the server no longer offers this topic
  heard(published_ns: bigint): void;  // a message of any topic, before it is handled
}

interface TopicUse {
  publishes: readonly (keyof OwnTopics)[];
  onRequest: readonly (keyof Topics)[];  // subscribed only after setExtraTopics; other handled topics always are
}

interface Subscription {
  channel: number;
  topic: keyof Topics;
  decode: Decode;
}

interface Publication {
  channel: number;
  encode: Encode;
}

/**
 * Receives and decodes the server's messages and sends the viewer's. It connects, and reconnects while the page is
 * open.
 */
export class Stream {
  connected = false;
  /** When the next attempt begins, on now_ms(); undefined while connected or connecting. */
  retryAt_ms: number | undefined;
  undecodable = 0;
  /** This viewer's number at the server, as /viewer/hand_holder names it; 0 until the server has sent it. */
  viewer = 0n;
  /** The name of this visitor's role at the server; empty until the server has sent it. */
  role = '';
  /** The paths of the resources that this visitor may change. */
  may: readonly string[] = [];

  private readonly subscriptions = new Map<SubscriptionId, Subscription>();
  private readonly publications = new Map<string, Publication>();
  private readonly channels = new Map<string, Channel>();  // those that the server advertises
  private extra: readonly (keyof Topics)[] = [];
  private client: FoxgloveClient | undefined;
  private retry_ms = FIRST_RETRY_MS;
  private heard_ms = 0;

  constructor(
      private readonly url: string,
      private readonly handlers: Handlers,
      private readonly topics: TopicUse,
      private readonly on: Listeners,
  ) {
    setInterval(() => this.endIfSilent(), 1000);
    this.connect();
  }

  /** Sends `message` if the server accepts it; otherwise drops it, because a newer one follows soon. */
  publish<Topic extends keyof OwnTopics>(topic: Topic, message: OwnTopics[Topic]): void {
    const publication = this.publications.get(topic);
    if (publication !== undefined) this.client?.sendMessage(publication.channel, publication.encode(message));
  }

  /** Subscribes again to request a key frame: the server sends a new subscriber a key frame first. */
  subscribeAgain(topic: keyof Topics): void {
    const {client} = this;
    const held = [...this.subscriptions].find(([, subscription]) => subscription.topic === topic);
    if (client === undefined || held === undefined) return;
    const [id, subscription] = held;
    client.unsubscribe(id);
    this.subscriptions.delete(id);
    this.subscriptions.set(client.subscribe(subscription.channel), subscription);
  }

  /** Of the topics on request, subscribes to `extra` alone. */
  setExtraTopics(extra: readonly (keyof Topics)[]): void {
    this.extra = extra;
    const {client} = this;
    if (client === undefined) return;
    for (const [id, {topic}] of this.subscriptions) {
      if (this.isWanted(topic)) continue;
      client.unsubscribe(id);
      this.subscriptions.delete(id);
    }
    const held = new Set(Array.from(this.subscriptions.values(), ({topic}) => topic as string));
    for (const [topic, channel] of this.channels) if (!held.has(topic)) this.subscribe(client, channel);
  }

  private isWanted(topic: string): boolean {
    return topic in this.handlers && (this.extra.some((one) => one === topic) ||
        !this.topics.onRequest.some((one) => one === topic));
  }

  private connect(): void {
    this.retryAt_ms = undefined;
    this.subscriptions.clear();
    this.channels.clear();
    this.publications.clear();
    this.heard_ms = performance.now();
    const client = new FoxgloveClient({ws: new WebSocket(this.url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL])});
    this.client = client;
    client.on('serverInfo', ({metadata}) => {
      this.viewer = BigInt(metadata?.viewer ?? 0);
      this.role = metadata?.role ?? '';
      this.may = (metadata?.may ?? '').split(',');
      this.connected = true;
      this.retry_ms = FIRST_RETRY_MS;
      this.on.connected();
    });
    client.on('advertise', (channels) => channels.forEach((channel) => {
      this.channels.set(channel.topic, channel);
      this.subscribe(client, channel);
      this.offer(client, channel);
    }));
    client.on('unadvertise', (channels) => channels.forEach((channel) => this.withdraw(client, channel)));
    client.on('message', ({subscriptionId, timestamp, data}) => {
      this.heard_ms = performance.now();
      this.on.heard(timestamp);
      this.deliver(subscriptionId, timestamp, new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    });
    client.on('status', ({message}) => this.on.warned(message));
    client.on('error', (problem) => console.warn('stream:', problem.message));
    client.on('close', () => {
      if (this.client === client) this.retry();
    });
  }

  private subscribe(client: FoxgloveClient, channel: Channel): void {
    if (!this.isWanted(channel.topic) || channel.encoding !== 'protobuf') return;
    try {
      const decode = decoderFor(channel.schemaName, channel.schema);
      const topic = channel.topic as keyof Topics;
      this.subscriptions.set(client.subscribe(channel.id), {channel: channel.id, topic, decode});
    } catch (problem) {
      console.error(`${channel.topic}: ${String(problem)}`);
    }
  }

  private withdraw(client: FoxgloveClient, channel: number): void {
    const gone = [...this.channels.values()].find(({id}) => id === channel);
    if (gone === undefined) return;
    this.channels.delete(gone.topic);
    for (const [id, {topic}] of this.subscriptions) {
      if (topic !== gone.topic) continue;
      client.unsubscribe(id);
      this.subscriptions.delete(id);
    }
    this.on.withdrawn(gone.topic);
  }

  /** The server advertises the schema of each topic, also of those that viewers publish. */
  private offer(client: FoxgloveClient, {topic, encoding, schema, schemaName}: Channel): void {
    if (!this.topics.publishes.some((own) => own === topic) || encoding !== 'protobuf') return;
    const encode = encoderFor(schemaName, schema);
    this.publications.set(topic, {channel: client.advertise({topic, encoding, schemaName}), encode});
  }

  private deliver(id: SubscriptionId, published_ns: bigint, payload: Uint8Array): void {
    const subscription = this.subscriptions.get(id);
    if (subscription === undefined) return;
    try {
      const message = subscription.decode(payload);
      const handle = this.handlers[subscription.topic] as (message: unknown, at: bigint, bytes: number) => void;
      handle(message, published_ns, payload.byteLength);
    } catch (problem) {
      if (this.undecodable++ === 0) console.error(`${subscription.topic}: ${String(problem)}`);
    }
  }

  /** A pulled cable does not end a connection. Without this check, a frozen picture would look live. */
  private endIfSilent(): void {
    const silent = this.client;
    if (silent === undefined || performance.now() - this.heard_ms < SILENCE_MS) return;
    this.retry();
    silent.close();
  }

  private retry(): void {
    this.connected = false;
    this.client = undefined;
    this.publications.clear();
    this.retryAt_ms = now_ms() + this.retry_ms;
    setTimeout(() => this.connect(), this.retry_ms);
    this.retry_ms = Math.min(2 * this.retry_ms, SLOWEST_RETRY_MS);
  }
}
