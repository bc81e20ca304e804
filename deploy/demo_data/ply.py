"""Reads and writes PLY files: binary little-endian, x y z as floats, triangles."""

import struct


def read_ply(path):
    data = open(path, "rb").read()
    body = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:body]
    vertex_count = int(header.split(b"element vertex ")[1].split()[0])
    face_count = int(header.split(b"element face ")[1].split()[0])
    faces_at = body + 12 * vertex_count
    vertices = list(struct.iter_unpack("<fff", data[body:faces_at]))
    faces = [t[1:] for t in struct.iter_unpack("<Biii", data[faces_at : faces_at + 13 * face_count])]
    return vertices, faces


def write_ply(path, comments, points, triangles):
    """At most 65 535 points: their numbers are written as ushort."""
    with open(path, "wb") as out:
        out.write(b"ply\nformat binary_little_endian 1.0\n")
        out.write(b"".join(b"comment %s\n" % comment.encode() for comment in comments))
        out.write(
            b"element vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            b"element face %d\nproperty list uchar ushort vertex_indices\nend_header\n" % (len(points), len(triangles))
        )
        for point in points:
            out.write(struct.pack("<fff", *point))
        for triangle in triangles:
            out.write(struct.pack("<BHHH", 3, *triangle))
