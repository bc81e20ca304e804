/** Eigenvalues of a symmetric matrix, largest first, each with its unit vector, by Jacobi's rotations. */
export function eigenpairs(symmetric: readonly (readonly number[])[]): {value: number; vector: number[]}[] {
  const n = symmetric.length;
  const a = symmetric.map((row) => [...row]);
  const v = a.map((_, i) => a.map((__, k) => (i === k ? 1 : 0)));
  for (let sweep = 0; sweep < 30; ++sweep)
    for (let p = 0; p < n; ++p)
      for (let q = p + 1; q < n; ++q) annihilate(a, v, p, q);
  return a.map((row, i) => ({value: row[i]!, vector: v.map((of) => of[i]!)})).sort((one, other) => other.value - one.value);
}

/** Turns the axes p and q so that a[p][q] becomes zero. */
function annihilate(a: number[][], v: number[][], p: number, q: number): void {
  const off = a[p]![q]!;
  if (Math.abs(off) < 1e-300) return;
  const angle = 0.5 * Math.atan2(2 * off, a[p]![p]! - a[q]![q]!);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (const row of [...a, ...v]) [row[p], row[q]] = [c * row[p]! + s * row[q]!, c * row[q]! - s * row[p]!];
  for (let k = 0; k < a.length; ++k)
    [a[p]![k], a[q]![k]] = [c * a[p]![k]! + s * a[q]![k]!, c * a[q]![k]! - s * a[p]![k]!];
}

/** The solution of a square linear system by elimination with pivots; undefined: the system is singular. */
export function solved(rows: readonly (readonly number[])[], right: readonly number[]): number[] | undefined {
  const a = rows.map((row, i) => [...row, right[i]!]);
  const n = a.length;
  for (let k = 0; k < n; ++k) {
    const best = a.slice(k).reduce((at, row, i) => (Math.abs(row[k]!) > Math.abs(a[at]![k]!) ? k + i : at), k);
    [a[k], a[best]] = [a[best]!, a[k]!];
    if (Math.abs(a[k]![k]!) < 1e-9) return undefined;
    for (let i = 0; i < n; ++i) {
      if (i === k) continue;
      const share = a[i]![k]! / a[k]![k]!;
      a[i] = a[i]!.map((value, j) => value - share * a[k]![j]!);
    }
  }
  return a.map((row, i) => row[n]! / row[i]!);
}
