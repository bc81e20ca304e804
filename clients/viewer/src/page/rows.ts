import {made, setText} from './page';

/** One line of a card: a name and a value. */
export interface Row {
  name: string;
  value: string;
  says?: string;      // explanation for the pointer and for screen readers
  level?: 'good' | 'warn' | 'alarm' | undefined;
  part?: boolean;     // a part of the row above it
}

/** Shows rows in a description list. Elements are kept, so that a hovered or spoken row does not flicker. */
export class RowList {
  private readonly lines: {line: HTMLElement; name: HTMLElement; value: HTMLElement}[] = [];

  constructor(private readonly list: HTMLElement) {}

  show(rows: readonly Row[]): void {
    while (this.lines.length < rows.length) this.add();
    while (this.lines.length > rows.length) this.lines.pop()?.line.remove();
    rows.forEach(({name, value, says, level, part}, at) => {
      const shown = this.lines[at]!;
      setText(shown.name, name);
      setText(shown.value, value);
      const kind = part === true ? 'part' : '';
      if (shown.line.title !== (says ?? '')) shown.line.title = says ?? '';
      if (shown.line.className !== kind) shown.line.className = kind;
      if (shown.value.dataset['level'] !== (level ?? '')) shown.value.dataset['level'] = level ?? '';
    });
  }

  private add(): void {
    const [line, name, value] = [made('div'), made('dt'), made('dd')];
    line.append(name, value);
    this.list.append(line);
    this.lines.push({line, name, value});
  }
}
