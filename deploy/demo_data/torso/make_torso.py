#!/usr/bin/env python3
"""Makes visible_human_torso.ply from the HuBMAP reference skin: crop, keep the front, thin out by vertex clustering.

    make_torso.py VH_M_Skin.ply visible_human_torso.ply

Input and output are binary little-endian PLY in metres, y towards the head, +z out of the patient's front.
The cell of 13 mm leaves details down to a navel and fits a file of about 150 kB; the program that reads it smooths
the remaining facets.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from ply import read_ply, write_ply

CROP_X_M = 0.52            # to either side: arms and hands, as far as a camera 0.8 m above the belly sees
CROP_Y_M = (-0.46, 0.90)   # from the middle of the thighs to the forehead
FRONT_NORMAL_Z = -0.15     # triangles whose normal has a smaller z lie on the table, unseen
CELL_M = 0.013


def faces_front(a, b, c):
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = sum(x * x for x in n) ** 0.5
    return length > 0 and n[2] / length > FRONT_NORMAL_Z


def inside_crop(p):
    return abs(p[0]) < CROP_X_M and CROP_Y_M[0] < p[1] < CROP_Y_M[1]


def cluster(vertices, faces):
    """Merges the vertices of each cell into their mean; a triangle that collapses is dropped."""
    cells = {}
    cell_of = {}
    for index in sorted({i for face in faces for i in face}):
        key = tuple(int(x // CELL_M) for x in vertices[index])
        cell = cells.setdefault(key, [len(cells), 0, 0.0, 0.0, 0.0])
        cell[1] += 1
        for axis in range(3):
            cell[2 + axis] += vertices[index][axis]
        cell_of[index] = cell[0]
    points = [tuple(s / count for s in (x, y, z)) for _, count, x, y, z in cells.values()]
    thinned, seen = [], set()
    for face in faces:
        merged = tuple(cell_of[i] for i in face)
        if len(set(merged)) == 3 and frozenset(merged) not in seen:
            seen.add(frozenset(merged))
            thinned.append(merged)
    return points, thinned


def main():
    vertices, faces = read_ply(sys.argv[1])
    faces = [f for f in faces if all(inside_crop(vertices[i]) for i in f) and faces_front(*(vertices[i] for i in f))]
    points, faces = cluster(vertices, faces)
    comments = [
        "Front of the trunk, from HuBMAP CCF 3D Reference Object Library VH_M_Skin v1.1 (Visible Human Male)",
        "CC BY 4.0, see ATTRIBUTION.md; cropped and thinned; metres, y towards the head, +z front",
    ]
    write_ply(sys.argv[2], comments, points, faces)
    print(f"{len(points)} vertices, {len(faces)} triangles")


if __name__ == "__main__":
    main()
