"""The sample models of the glTF authors: what their pictures look like is written down.

Each picture is told by the mean colours of 12 x 12 tiles (samples.json), the same on both backends.
The models lie beside the repository, if at all; without them the test says that it was left out.
After a change that is meant: FILE BENCH SOURCE_DIR --write, and look at every picture.
"""
import json
import os
import struct
import sys
import unittest
import zlib

from program import Case, SOURCE, main

SHARED = os.path.join(os.path.dirname(SOURCE), "shared", "scenes")
EXPECTED = os.path.join(SOURCE, "tests", "cli", "samples.json")
SIZE, TILES = 144, 12
# Mean of a tile, of 255. Drivers differ at edges and in the last bit.
TOLERANCE = 4.0


def models():
    found = {}
    for folder in [SHARED, os.path.join(SHARED, "samples")]:
        for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
            path = os.path.join(folder, name)
            if os.path.isdir(path):
                path = os.path.join(path, name + ".glb")
            if path.endswith(".glb") and os.path.exists(path):
                found[os.path.basename(path)[:-4]] = path
    return found


def readPng(path):
    """Rows of 8-bit RGB triples of a PNG without interlacing."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and colour in (2, 6)
            step = 3 if colour == 2 else 4
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw, rows, before = zlib.decompress(packed), [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + width * step])
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            if kind == 4:
                p = left + up - corner
                left = min((left, up, corner), key=lambda v: abs(p - v))
            row[i] = (row[i] + {0: 0, 1: left, 2: up, 3: (left + up) // 2, 4: left}[kind]) & 255
        rows.append([tuple(row[x:x + 3]) for x in range(0, len(row), step)])
        before = row
    return rows


def tiles(rows):
    """Mean colours, row by row, one digit behind the point."""
    side, means = SIZE // TILES, []
    for ty in range(TILES):
        for tx in range(TILES):
            part = [p for row in rows[ty * side:(ty + 1) * side]
                    for p in row[tx * side:(tx + 1) * side]]
            means.append([round(sum(p[c] for p in part) / len(part), 1) for c in range(3)])
    return means


def picture(test, path, backend, prefix):
    test.ok("render", "--scene", path, "--technique", "CSSM2+DepthPeeling", "--backend", backend,
            "--size", f"{SIZE}x{SIZE}", "-o", prefix)
    return tiles(readPng(prefix + ".png"))


class Samples(Case):
    def testPicturesAreAsTheyWere(self):
        found = models()
        if not found:
            self.skipTest(f"{SHARED} is not there; the sample models were left out")
        with open(EXPECTED) as file:
            expected = json.load(file)
        self.assertGreaterEqual(len(expected), 17)
        for name, means in expected.items():
            for backend in ["vulkan", "opengl"]:
                with self.subTest(model=name, backend=backend):
                    self.assertIn(name, found)
                    now = picture(self, found[name], backend, self.path("p"))
                    off = [max(abs(a - b) for a, b in zip(x, y)) for x, y in zip(now, means)]
                    worst = max(range(len(off)), key=off.__getitem__)
                    self.assertLessEqual(
                        off[worst], TOLERANCE,
                        f"tile {worst % TILES},{worst // TILES}: {now[worst]} was {means[worst]}")


def write():
    class Write(Case):  # not of the module: only what is asked for may write
        def runTest(self):
            written = {name: picture(self, path, "vulkan", self.path("p"))
                       for name, path in models().items()}
            with open(EXPECTED, "w") as file:
                lines = ",\n".join(f' {json.dumps(n)}: {json.dumps(m, separators=(",", ":"))}'
                                   for n, m in sorted(written.items()))
                file.write("{\n" + lines + "\n}\n")

    return unittest.TextTestRunner().run(Write()).wasSuccessful()


if __name__ == "__main__":
    if "--write" in sys.argv:
        sys.exit(not write())
    main()
