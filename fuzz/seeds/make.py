#!/usr/bin/env python3
"""Writes the binary seeds beside this file, the same bytes every time. The text ones are written by hand."""

import gzip
import json
from pathlib import Path
from struct import pack

HERE = Path(__file__).parent
CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def write(name, data):
    (HERE / name).write_bytes(data)


def glb(document, binary, version=2):
    text = json.dumps(document, separators=(",", ":")).encode()
    chunks = b""
    for kind, chunk, pad in [(b"JSON", text, b" "), (b"BIN\0", binary, b"\0")]:
        chunk += pad * (-len(chunk) % 4)
        chunks += pack("<I", len(chunk)) + kind + chunk
    return b"glTF" + pack("<II", version, 12 + len(chunks)) + chunks


def write_glb():
    positions = b"".join(pack("<3f", *c) for c in CORNERS)
    indices = b"".join(pack("<3H", *f) for f in TETRAHEDRON)
    document = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 72}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    }
    good = glb(document, positions + indices)
    write("glb/indexed.glb", good)
    write("glb/bad-cut.glb", good[:-9])
    write("glb/bad-length.glb", good[:8] + pack("<I", 11) + good[12:])
    write("glb/bad-version.glb", glb(document, positions + indices, version=1))
    write("glb/bad-index.glb", glb(document, positions + pack("<12H", *[4] * 12)))
    document["accessors"][1]["componentType"] = 5121
    document["meshes"][0]["primitives"][0]["mode"] = 5
    write("glb/strip_of_bytes.glb", glb(document, positions + bytes([0, 1, 2, 3] * 3) + bytes(12)))
    del document["meshes"][0]["primitives"][0]["indices"]
    document["bufferViews"][0] = {"buffer": 0, "byteLength": 72, "byteStride": 16}
    write("glb/interleaved.glb", glb(document, bytes(range(72))))


def write_ply():
    header = (
        "ply\nformat binary_{}_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nelement face 5\nproperty list uchar {} vertex_indices\nproperty short flags\nend_header\n"
    )
    faces = TETRAHEDRON + [(0, 1, 2, 3)]
    for name, order in [("little", "<"), ("big", ">")]:
        for type_name, code in [("int", "i"), ("ushort", "H"), ("uchar", "B")]:
            data = header.format(name, type_name).encode()
            data += b"".join(pack(order + "3fB", *c, 200) for c in CORNERS)
            data += b"".join(pack(f"{order}B{len(f)}{code}h", len(f), *f, -2) for f in faces)
            write(f"ply/{name}_{type_name}.ply", data)
    write("ply/bad-cut_binary.ply", data[:-5])
    write("ply/bad-long_list.ply", data.replace(b"\x04\x00\x01\x02\x03", b"\xff\x00\x01\x02\x03"))
    write("ply/bad-many_faces.ply", data.replace(b"face 5", b"face 4294967295"))


def write_stl():
    def stl(title, count):
        data = title.ljust(80, b"\0") + pack("<I", count)
        for face in TETRAHEDRON:
            data += pack("<12f", 0, 0, 1, *(x for v in face for x in CORNERS[v])) + pack("<H", 0x8001)
        return data

    write("stl/binary.stl", stl(b"tetrahedron COLOR=\xff\0\0\xff", 4))
    write("stl/binary_begins_with_solid.stl", stl(b"solid tetrahedron", 4))
    write("stl/binary_of_none.stl", stl(b"", 0)[:84])
    write("stl/bad-count.stl", stl(b"tetrahedron", 0xFFFFFFFF))
    write("stl/bad-cut_binary.stl", stl(b"tetrahedron", 4)[:-7])


def write_gzip():
    text = (HERE / "obj/cube.obj").read_bytes()
    data = gzip.compress(text, mtime=0)
    write("gzip/cube.obj.gz", data)
    write("gzip/stored.obj.gz", gzip.compress(text, compresslevel=0, mtime=0))
    write("gzip/two_members.obj.gz", data + gzip.compress(b"f 1 2 3\n", mtime=0))
    write("gzip/indexed.glb.gz", gzip.compress((HERE / "glb/indexed.glb").read_bytes(), mtime=0))
    write("gzip/with_name.obj.gz", data[:3] + b"\x08" + data[4:10] + b"cube.obj\0" + data[10:])
    write("gzip/bad-checksum.gz", data[:-8] + bytes(4) + data[-4:])
    write("gzip/bad-length.gz", data[:-1] + b"\x7f")
    write("gzip/bad-cut.gz", data[:50])
    write("gzip/bad-bomb.gz", gzip.compress(bytes(300_000), mtime=0))
    write("gzip/bad-twice.gz", gzip.compress(data, mtime=0))


def write_index_buffers():
    """One byte each: vertices, choices (from 128 on, corners may be out of range), corners."""

    def seed(name, vertices, faces, choices=0):
        write(f"index_buffer/{name}", bytes([vertices, choices]) + bytes(v for f in faces for v in f))

    def grid(n, m):
        at = lambda x, y: x % n * m + y % m
        quads = [(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)) for x in range(n) for y in range(m)]
        return [face for a, b, c, d in quads for face in [(a, b, c), (a, c, d)]]

    seed("nothing", 0, [])
    seed("isolated", 5, [], 3)
    seed("tetrahedron", 4, TETRAHEDRON, 24)
    seed("torus", 63, grid(7, 9), 9)
    seed("small_torus", 9, grid(3, 3)[:10], 1)
    seed("moebius", 5, [(i, (i + 1) % 5, (i + 2) % 5) for i in range(5)], 7)
    seed("projective_plane", 6, [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)])
    seed("fins", 6, [(0, 1, 2), (1, 0, 3), (0, 1, 4), (1, 0, 5)], 2)
    seed("same_direction", 4, [(0, 1, 2), (0, 1, 3)])
    seed("bowtie", 5, [(0, 1, 2), (0, 3, 4)])
    seed("pillow", 3, [(0, 1, 2), (2, 1, 0)])
    seed("copies", 4, [(0, 1, 2), (1, 2, 0), (0, 2, 1), (0, 1, 3)])
    seed("degenerate", 4, [(0, 0, 1), (1, 2, 1), (3, 3, 3), (0, 1, 2)])
    seed("out_of_range", 4, [(0, 1, 2), (1, 2, 4), (255, 0, 1)], 128)
    seed("two_holes", 9, [(0, 1, 3), (1, 4, 3), (1, 2, 4), (2, 5, 4), (3, 4, 6), (4, 7, 6), (5, 8, 7)], 130)
    seed("fan_of_many", 60, [(0, i, i + 1) for i in range(1, 59)], 5)
    seed("book", 60, [(0, 1, i) if i % 3 else (1, 0, i) for i in range(2, 60)], 5)


for kind in [write_glb, write_ply, write_stl, write_gzip, write_index_buffers]:
    kind()
