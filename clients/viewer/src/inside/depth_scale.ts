/** Depths of the scale's marks [mm]: steps of 1, 2 or 5 times a power of ten, at most `most` of them. */
export function marks_mm(depth_m: number, most = 6): number[] {
  const depth_mm = 1000 * depth_m;
  if (!(depth_mm > 0) || !Number.isFinite(depth_mm)) return [];
  const power = 10 ** Math.floor(Math.log10(depth_mm / most));
  const step = power * ([1, 2, 5, 10].find((factor) => depth_mm / (factor * power) <= most) ?? 10);
  return Array.from({length: Math.floor(depth_mm / step + 1e-9) + 1}, (_, i) => i * step);
}

/** The caliper after a key: arrows move it by 1 mm, with Page keys by 10 mm; Escape removes it. */
export function caliperAfter(key: string, at_mm: number | undefined, depth_m: number): number | undefined {
  const moves: Record<string, number> = {ArrowUp: -1, ArrowDown: 1, PageUp: -10, PageDown: 10};
  const by_mm = moves[key];
  if (key === 'Escape') return undefined;
  if (by_mm === undefined) return at_mm;
  return Math.min(1000 * depth_m, Math.max(0, Math.round((at_mm ?? 0) + by_mm)));
}
