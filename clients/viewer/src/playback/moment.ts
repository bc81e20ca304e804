import {sessionInAddress} from '../link/own_session';

/**
 * The address that shows its reader alone `position_s` of the page's session, and marks a note of this number: to be
 * shared. Rounded up, because a seek shows the newest image before its position.
 */
export function addressOfMoment(page: string, position_s: number, note?: number): string {
  const address = new URL(page);
  const query = new URLSearchParams({view: 'qa', at_s: (Math.ceil(100 * position_s - 1e-6) / 100).toFixed(2)});
  const session = sessionInAddress(address.search);
  if (session !== undefined) query.set('session', session);
  if (note !== undefined) query.set('note', String(note));
  address.search = query.toString();
  address.hash = '';
  return address.href;
}
