import {element} from '../page/page';
import {addressOf, type View, viewForKey, viewForRole, viewInAddress, VIEWS} from './view';

/**
 * The links in the top bar that choose the view. Each view has an address. Without one, the role that the server names
 * decides, until the user chooses.
 */
export class ViewSwitch {
  view: View;
  private role = '';

  constructor(private readonly onView: (view: View) => void) {
    this.view = viewInAddress(location.search) ?? 'doctor';
    for (const view of VIEWS)
      element<HTMLAnchorElement>(`view-${view}`).addEventListener('click', (event) => {
        if (event.ctrlKey || event.metaKey || event.shiftKey) return;  // the browser opens the address elsewhere
        event.preventDefault();
        this.choose(view);
      });
    window.addEventListener('popstate', () => this.show(viewInAddress(location.search) ?? viewForRole(this.role)));
    this.show(this.view);
  }

  /** `role`: the name of this visitor's role at the server; empty while it is not known. */
  setRole(role: string): void {
    if (role === this.role) return;
    this.role = role;
    if (viewInAddress(location.search) === undefined) this.show(viewForRole(role));
  }

  /** True if `key` chooses a view. */
  takeKey(key: string): boolean {
    const view = viewForKey(key);
    if (view !== undefined) this.choose(view);
    return view !== undefined;
  }

  private choose(view: View): void {
    if (view === this.view && viewInAddress(location.search) !== undefined) return;
    history.pushState(null, '', addressOf(view, location.search));
    this.show(view);
  }

  private show(view: View): void {
    this.view = view;
    document.body.dataset['view'] = view;
    for (const one of VIEWS) {
      const link = element<HTMLAnchorElement>(`view-${one}`);
      link.href = addressOf(one, location.search);
      if (one === view) link.setAttribute('aria-current', 'page');
      else link.removeAttribute('aria-current');
    }
    this.onView(view);
  }
}
