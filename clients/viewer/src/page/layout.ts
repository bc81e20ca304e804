import {element} from './page';

const GAP_PX = 8;

/** Keeps the CSS variable `variable` at the height that the element `id` takes; 0 px while it is hidden. */
export function measureHeight(id: string, variable: string): () => void {
  const measured = element(id);
  const measure = () => {
    const height_px = measured.offsetHeight === 0 ? 0 : measured.offsetHeight + GAP_PX;
    document.documentElement.style.setProperty(variable, `${height_px}px`);
  };
  new ResizeObserver(measure).observe(measured);
  measure();
  return measure;
}
