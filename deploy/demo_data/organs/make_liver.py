#!/usr/bin/env python3
"""Makes visible_human_liver.ply from the HuBMAP reference liver: one closed skin around its open, touching parts.

    make_liver.py VH_M_Liver.ply visible_human_liver.ply

Input and output are binary little-endian PLY in metres, y towards the head, +z out of the patient's front. The
script marks the cells of 6 mm that the parts pass through. These cells, and all cells that cannot be reached from
outside, are liver. The mesh is the smoothed border of the liver's cells. The gaps between the parts are far smaller
than a cell.
"""

import collections
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from ply import read_ply, write_ply

CELL_M = 0.006
RELAXATIONS = 12
SIX_SIDES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))


def cells_of(vertices, faces):
    """The cells that the triangles pass through, by points on them at half a cell's distance."""
    touched = set()
    for face in faces:
        a, b, c = (vertices[i] for i in face)
        longest = max(sum((p[i] - q[i]) ** 2 for i in range(3)) ** 0.5 for p, q in ((a, b), (b, c), (c, a)))
        parts = max(1, int(2 * longest / CELL_M) + 1)
        for i in range(parts + 1):
            for j in range(parts + 1 - i):
                u, v = i / parts, j / parts
                touched.add(tuple(int((a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k])) // CELL_M) for k in range(3)))
    return touched


def filled(touched):
    """All cells but those that can be reached from outside."""
    low = [min(c[k] for c in touched) - 1 for k in range(3)]
    high = [max(c[k] for c in touched) + 1 for k in range(3)]
    outside, front = {tuple(low)}, collections.deque([tuple(low)])
    while front:
        at = front.popleft()
        for side in SIX_SIDES:
            near = tuple(at[k] + side[k] for k in range(3))
            if all(low[k] <= near[k] <= high[k] for k in range(3)) and near not in outside and near not in touched:
                outside.add(near)
                front.append(near)
    every = ((x, y, z) for x in range(low[0], high[0] + 1) for y in range(low[1], high[1] + 1)
             for z in range(low[2], high[2] + 1))
    return {cell for cell in every if cell not in outside}


def eroded(solid):
    """`solid` without its outermost layer of cells: marking whole cells had enlarged the solid by this layer."""
    return {c for c in solid if all(tuple(c[k] + s[k] for k in range(3)) in solid for s in SIX_SIDES)}


def largest_piece(solid):
    left, best = set(solid), set()
    while left:
        start = left.pop()
        piece, front = {start}, [start]
        while front:
            at = front.pop()
            for side in SIX_SIDES:
                near = tuple(at[k] + side[k] for k in range(3))
                if near in left:
                    left.remove(near)
                    piece.add(near)
                    front.append(near)
        best = max(best, piece, key=len)
    return best


def corners_of(cell, side):
    """The four lattice corners of a cell's face, counter-clockwise seen from outside."""
    axis = next(k for k in range(3) if side[k])
    u, v = (axis + 1) % 3, (axis + 2) % 3
    turns = ((0, 0), (1, 0), (1, 1), (0, 1)) if side[axis] > 0 else ((0, 0), (0, 1), (1, 1), (1, 0))
    for du, dv in turns:
        corner = list(cell)
        corner[axis] += side[axis] > 0
        corner[u] += du
        corner[v] += dv
        yield tuple(corner)


def border(solid):
    """The faces between solid and empty cells, as triangles over lattice corners."""
    number, triangles = {}, []
    for cell in sorted(solid):
        for side in SIX_SIDES:
            if tuple(cell[k] + side[k] for k in range(3)) in solid:
                continue
            a, b, c, d = (number.setdefault(corner, len(number)) for corner in corners_of(cell, side))
            triangles += [(a, b, c), (a, c, d)]
    return [[x * CELL_M for x in corner] for corner in number], triangles


def without_pinches(solid):
    """Fills cells until none touch by an edge or a corner alone: there, a border would not be a surface."""
    while True:
        added = set()
        for x, y, z in solid:
            for dx in (-1, 0, 1):
                for dy in (-1, 0, 1):
                    for dz in (-1, 0, 1):
                        steps = [s for s in ((dx, 0, 0), (0, dy, 0), (0, 0, dz)) if any(s)]
                        if len(steps) < 2 or (x + dx, y + dy, z + dz) not in solid:
                            continue
                        if not any((x + s[0], y + s[1], z + s[2]) in solid for s in steps):
                            added.add((x + steps[0][0], y + steps[0][1], z + steps[0][2]))
        if not added:
            return solid
        solid = solid | added


def relaxed(points, triangles):
    """Moves vertices towards the mean of their neighbours and back, so that the mesh does not shrink (Taubin 1995)."""
    neighbours = [set() for _ in points]
    for a, b, c in triangles:
        neighbours[a] |= {b, c}
        neighbours[b] |= {a, c}
        neighbours[c] |= {a, b}
    for _ in range(RELAXATIONS):
        for share in (0.6, -0.62):
            means = [[sum(points[j][k] for j in near) / len(near) for k in range(3)] for near in neighbours]
            points = [[p[k] + share * (m[k] - p[k]) for k in range(3)] for p, m in zip(points, means)]
    return points


def main():
    source, target = sys.argv[1:]
    solid = without_pinches(largest_piece(eroded(filled(cells_of(*read_ply(source))))))
    points, triangles = border(solid)
    comments = [
        "Liver, from HuBMAP CCF 3D Reference Object Library VH_M_Liver v1.1 (Visible Human Male)",
        "CC BY 4.0, see ATTRIBUTION.md; one closed skin of its parts; metres, y towards the head, +z front",
    ]
    write_ply(target, comments, relaxed(points, triangles), triangles)
    print(f"{len(points)} vertices, {len(triangles)} triangles, {1e6 * len(solid) * CELL_M**3:.0f} ml of liver")


if __name__ == "__main__":
    main()
