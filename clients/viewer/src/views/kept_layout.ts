import {keep} from '../page/page';
import type {View} from './view';

const KEPT_AS = 'telepalp-layout';

/** What a user folded or closed in each view; kept in this browser, or until the page is closed if it keeps nothing. */
export class KeptLayout {
  private readonly parts: Partial<Record<View, string[]>>;

  constructor(private readonly store: Pick<Storage, 'getItem' | 'setItem'> | undefined) {
    this.parts = read(store);
  }

  has(view: View, part: string): boolean {
    return this.parts[view]?.includes(part) ?? false;
  }

  set(view: View, part: string, wanted: boolean): void {
    const others = (this.parts[view] ?? []).filter((one) => one !== part);
    this.parts[view] = wanted ? [...others, part] : others;
    keep(this.store, KEPT_AS, JSON.stringify(this.parts));
  }
}

/** The kept layout; empty where nothing is kept, or another program's text. */
function read(store: Pick<Storage, 'getItem'> | undefined): Partial<Record<View, string[]>> {
  try {
    const kept = JSON.parse(store?.getItem(KEPT_AS) ?? '{}') as Record<string, unknown>;
    return Object.fromEntries(Object.entries(kept).filter(([, parts]) => Array.isArray(parts)));
  } catch {
    return {};
  }
}
