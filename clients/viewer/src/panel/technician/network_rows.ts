import type {ServerStats} from '../../messages/generated';
import type {Row} from '../../page/rows';
import {megabits} from '../megabits';

const MOST_TOPICS = 6;

/** Rates from one /server/stats to the next, which come once a second. Pure but for the last one, which it keeps. */
export class NetworkRates {
  private before: ServerStats | undefined;
  private rows: Row[] = [{name: 'Not known yet', value: '–'}];

  show(stats: ServerStats | undefined): Row[] {
    if (stats === undefined) return this.rows;
    const {before} = this;
    if (before?.stampNs === stats.stampNs) return this.rows;
    this.before = stats;
    if (before === undefined || stats.stampNs < before.stampNs) return this.rows;
    return (this.rows = rates(before, stats));
  }
}

function rates(before: ServerStats, after: ServerStats): Row[] {
  const seconds = Number(after.stampNs - before.stampNs) / 1e9;
  const old = new Map(before.topics.map((topic) => [topic.topic, topic]));
  const topics = after.topics.map(({topic, published, bytes, dropped}) => ({
    topic,
    per_s: Number(published - (old.get(topic)?.published ?? 0n)) / seconds,
    bytes_per_s: Number(bytes - (old.get(topic)?.bytes ?? 0n)) / seconds,
    dropped: Number(dropped - (old.get(topic)?.dropped ?? 0n)),
  })).filter(({per_s}) => per_s > 0).sort((a, b) => b.bytes_per_s - a.bytes_per_s);
  const all = topics.reduce((sum, {bytes_per_s}) => sum + bytes_per_s, 0);
  const lost = topics.reduce((sum, {dropped}) => sum + dropped, 0);
  return [
    {name: 'Published', value: megabits(all, 2), says: 'All topics, each message counted once. Each subscriber of a topic is sent its own copy.'},
    ...topics.slice(0, MOST_TOPICS).map(({topic, per_s, bytes_per_s}) => ({
      name: topic, part: true, value: megabits(bytes_per_s, 2), says: `${per_s.toFixed(1)} messages/s`,
    })),
    {name: 'Dropped', value: `${(lost / seconds).toFixed(0)} /s`, level: lost > 0 ? 'warn' : 'good',
     says: 'Messages that a newer one replaced before a slow subscriber had them, over all subscribers.'},
  ];
}

/** How each subscriber is served; a second row for one whose line something else uses. */
export function subscriberRows(stats: ServerStats | undefined): Row[] {
  return (stats?.subscribers ?? []).flatMap(({name, address, sent, dropped, byDatagram, shareBPerS}): Row[] => {
    const row: Row = {
      name: name.replace(/^telepalp-/, ''),
      value: `${sent} sent, ${dropped} dropped`,
      says: `Messages since connecting. ${address}, ${byDatagram ? 'images by encrypted UDP datagrams' : 'all messages over one TCP connection'}`,
    };
    return shareBPerS === undefined ? [row] : [row, {
      name: 'its line', part: true, value: `${megabits(shareBPerS)} left`, level: 'warn',
      says: 'Something else uses this line, such as a download. The images share it, and are made smaller where they do not fit.',
    }];
  });
}
