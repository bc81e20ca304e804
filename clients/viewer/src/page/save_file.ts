import {made} from './page';

/** Offers `data` to the user as a file to save. */
export function saveFile(name: string, type: string, data: string | Blob): void {
  const link = made('a');
  link.href = URL.createObjectURL(data instanceof Blob ? data : new Blob([data], {type}));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
