/** The moment of a played session that the address names, in seconds from its beginning; undefined: none. */
export function momentInAddress(search: string): number | undefined {
  const asked = new URLSearchParams(search).get('at_s');
  if (asked === null || !/^\d+(\.\d+)?$/.test(asked)) return undefined;
  return Number(asked);
}

/**
 * The address that shows `position_s` to QA, and marks a note of this number: to be shared. Rounded up, because a seek
 * shows the newest image before its position.
 */
export function addressOfMoment(page: string, position_s: number, note?: number): string {
  const address = new URL(page);
  const query = new URLSearchParams({view: 'qa', at_s: (Math.ceil(100 * position_s - 1e-6) / 100).toFixed(2)});
  if (note !== undefined) query.set('note', String(note));
  address.search = query.toString();
  address.hash = '';
  return address.href;
}
