import type {Row} from '../page/rows';
import type {Presence} from '../state/presence';

const BROWSER = 'viewer';       // the server's name for each browser
const VIEWS_MAKER = 'views for Foxglove';

/** Who is connected, and what they do: the stations first, then recorders and browsers. */
export function presenceRows({stats, touching, holder, me, playsSession}: Presence): Row[] {
  if (stats === undefined) return [{name: 'Not known yet', value: '–'}];
  const people = stats.subscribers.filter(({name}) => name !== VIEWS_MAKER);
  const browsers = people.filter(({name}) => name === BROWSER);
  const others = people.filter(({name}) => name !== BROWSER);
  const rows: Row[] = others.map(({name, address, sender}) => {
    const touches = touching !== 0 && sender === touching;
    return {name: programName(name), value: touches ? 'holds the touch' : 'connected', says: address,
            level: touches ? 'good' : undefined};
  });
  if (playsSession && touching !== 0 && !others.some(({sender}) => sender === touching))
    rows.unshift({name: 'Recorded station', value: 'played', says: 'The played session contains this station’s messages.'});
  rows.push({
    name: browsers.length < 2 ? 'Browser' : `Browsers: ${browsers.length}`,
    value: browsers.length < 2 ? 'you' : 'you among them',
    says: browsers.map(({address}) => address).join(', '),
  });
  if (holder.viewer !== 0n)
    rows.push({
      name: 'Hand in a browser',
      value: holder.viewer === me ? 'yours' : `viewer ${holder.viewer}`,
      level: holder.viewer === me ? 'good' : 'warn',
    });
  return rows;
}

/** "telepalp-station" becomes "Station": the others are shown as they call themselves. */
function programName(name: string): string {
  const short = name.replace(/^telepalp-/, '');
  return short === '' ? 'Unnamed' : short.charAt(0).toUpperCase() + short.slice(1);
}
