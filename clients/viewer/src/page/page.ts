/** The element `id` of index.html. Throws if there is none: then page and script are not of the same build. */
export function element<Kind extends HTMLElement = HTMLElement>(id: string): Kind {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`index.html has no #${id}`);
  return found as Kind;
}

/**
 * The module of `file`, a bundle of its own that the page loads only when it is needed. The bundler cannot read an address
 * in a variable, so it leaves the module out of the page's own.
 */
export const later = async <Module>(file: string): Promise<Module> => import(new URL(file, import.meta.url).href) as Promise<Module>;

/** Writes only what changed: a screen reader reads out every write to a live region. */
export function setText(target: HTMLElement, text: string): void {
  if (target.textContent !== text) target.textContent = text;
}

/** A new element with a class and a text. */
export function made<Name extends keyof HTMLElementTagNameMap>(
    name: Name, className = '', text = ''): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  if (className !== '') element.className = className;
  if (text !== '') element.textContent = text;
  return element;
}

/** What a user wrote, as the server takes it: without control characters, which a pasted text may contain. */
export const oneLine = (text: string) => text.replace(/\p{Cc}+/gu, ' ').trim();

/** This browser's storage; undefined if it forbids one. */
export function browserStore(): Storage | undefined {
  try {
    return localStorage;
  } catch {
    return undefined;
  }
}

/** Keeps `value` under `name` for the next visit. In a browser without room, it holds until the page is closed. */
export function keep(store: Pick<Storage, 'setItem'> | undefined, name: string, value: string): void {
  try {
    store?.setItem(name, value);
  } catch {
    // nothing is kept
  }
}
