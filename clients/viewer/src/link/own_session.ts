/** A recorded session that this page alone shows and moves. */
export interface OwnSession {
  session: string | undefined;  // name of a recording; undefined: the session that the server plays for all
  at_s: number | undefined;     // the moment at which it stands; undefined: it plays
}

/** The moment of a session that the address names, in seconds from its beginning; undefined: none. */
export function momentInAddress(search: string): number | undefined {
  const asked = new URLSearchParams(search).get('at_s');
  if (asked === null || !/^\d+(\.\d+)?$/.test(asked)) return undefined;
  return Number(asked);
}

/** The name of the recording that the address names; undefined: none. */
export function sessionInAddress(search: string): string | undefined {
  const asked = new URLSearchParams(search).get('session');
  return asked !== null && /^[\w.-]+$/.test(asked) ? asked : undefined;
}

/** What the address opens for this page alone; undefined: nothing, the page shows what the server publishes for all. */
export function ownSessionIn(search: string): OwnSession | undefined {
  const own = {session: sessionInAddress(search), at_s: momentInAddress(search)};
  return own.session === undefined && own.at_s === undefined ? undefined : own;
}

/** The query by which the server knows the page's own session; `id` names this page and no other. Empty: there is none. */
export function queryOf(own: OwnSession | undefined, id: string): string {
  if (own === undefined) return '';
  const query = new URLSearchParams({reading: id});
  if (own.session !== undefined) query.set('session', own.session);
  if (own.at_s !== undefined) query.set('at_s', String(own.at_s));
  return `?${query.toString()}`;
}

function madeUp(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** queryOf() for this page. Its scripts share it, also after Share has changed the address. */
export function ownQuery(): string {
  const kept = globalThis as {telepalpOwnQuery?: string};
  return (kept.telepalpOwnQuery ??= queryOf(ownSessionIn(location.search), madeUp()));
}
