/** What the page is used for. Safety readings are in every view. */
export type View = 'doctor' | 'technician' | 'qa';

export const VIEWS: readonly View[] = ['doctor', 'technician', 'qa'];

/** The view that the address asks for: `?view=technician`; undefined: none, or an unknown one. */
export function viewInAddress(search: string): View | undefined {
  const asked = new URLSearchParams(search).get('view');
  return VIEWS.find((view) => view === asked);
}

/** The view for a person of the server's role `role`. Guests see what the doctor sees. */
export function viewForRole(role: string): View {
  return role === 'technician' || role === 'qa' ? role : 'doctor';
}

/** The query `search` with `view` in it; its other parts stay. */
export function addressOf(view: View, search: string): string {
  const query = new URLSearchParams(search);
  query.set('view', view);
  return `?${query.toString()}`;
}

/** The view that the key `key` chooses: 1, 2, 3 in the order of VIEWS. */
export const viewForKey = (key: string): View | undefined => (/^[1-3]$/.test(key) ? VIEWS[Number(key) - 1] : undefined);
