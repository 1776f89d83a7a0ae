#!/usr/bin/env python3
"""Visibility as render and truth write it: layers, lights, values, files."""
import base64
import json
import os
import struct

import exr
from program import Case, run, main


def paneScene(lights):
    """A floor [-4, 4]^2 under a pane [-1, 1]^2 at height 1, seen from straight above."""
    corners = b"".join(struct.pack("<3f", x, 0, z) for x, z in ((-1, -1), (-1, 1), (1, 1), (1, -1)))
    data = corners + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    punctual = {"extensions": {"KHR_lights_punctual": {"lights": [light for light, _ in lights]}}}
    down = [-0.5 ** 0.5, 0, 0, 0.5 ** 0.5]
    nodes = [{"mesh": 0, "scale": [4, 1, 4]}, {"mesh": 1, "translation": [0, 1, 0]},
             {"camera": 0, "translation": [0, 5, 0], "rotation": down}]
    nodes += [{"extensions": {"KHR_lights_punctual": {"light": i}}, **place}
              for i, (_, place) in enumerate(lights)]
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "extensionsUsed": ["KHR_lights_punctual"], **(punctual if lights else {}),
        "nodes": nodes,
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 4, "ymag": 4, "znear": 0.1,
                                                              "zfar": 10}}],
        "materials": [{"doubleSided": True}, {"doubleSided": True, "extras": {
            "shadowbench": {"alpha": 0.5, "t": [1, 0.5, 0]}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": m}]}
                   for m in (0, 1)],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [-1, 0, -1], "max": [1, 0, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," +
                     base64.b64encode(data).decode()}],
    }


# Suns at 45 degrees that travel along +x and -x, and a lamp whose range ends before everything.
TO_RIGHT = ({"type": "directional"}, {"rotation": [-0.5, -0.5, 0, 0.5 ** 0.5]})
TO_LEFT = ({"type": "directional"}, {"rotation": [-0.5, 0.5, 0, 0.5 ** 0.5]})
FAR_LAMP = ({"type": "point", "range": 1}, {"translation": [0, 99, 0]})


class Visibility(Case):
    """All of it in one file, whose layers are those that hold something."""

    def write(self, lights):
        with open(self.path("s.gltf"), "w") as file:
            json.dump(paneScene(lights), file)
        return self.path("s.gltf")

    def files(self):
        return sorted(name for name in os.listdir(self.folder) if name.startswith("t"))

    def expect(self, planes, light, shift):
        """The pane, and its shadow `shift` to the right, at pixels away from edges."""
        where = {}
        for row in range(32):
            for column in range(32):
                x, z = (column + 0.5) / 4 - 4, (row + 0.5) / 4 - 4
                if any(abs(abs(a) - 1) < 0.3 for a in (x, x - shift, z)):
                    continue
                pane = abs(x) < 1 and abs(z) < 1
                shadow = abs(x - shift) < 1 and abs(z) < 1
                floor = (1, 0.75, 0.5, 1) if shadow else (1, 1, 1, 1)
                where[pane, shadow] = where.get((pane, shadow), 0) + 1
                for layer, value in (("opaque", floor), ("layer1", (1, 1, 1, 1) if pane else floor),
                                     ("layer2", floor if pane else (0, 0, 0, 0))):
                    for channel, v in zip("RGBA", value):
                        self.assertAlmostEqual(
                            planes[f"light{light}.{layer}.{channel}"][row][column], v, 6,
                            (layer, channel, row, column))
        self.assertEqual(len(where), 4, where)

    def layered(self, lights):
        return sorted(f"light{light}.{layer}.{channel}" for light in lights
                      for layer in ("opaque", "layer1", "layer2") for channel in "RGBA")

    def test_values_are_the_truths(self):
        scene = self.write([TO_RIGHT, FAR_LAMP, TO_LEFT])
        text = self.ok("truth", "--scene", scene, "--size", "32x32", "--quiet", "-o",
                       self.path("t")).stdout
        self.assertIn("columns: opaque, layer1, layer2; rows: lights 0, 2", text)
        self.assertEqual(self.files(), ["t.edges.png", "t.exr", "t.png", "t.visibility.exr",
                                        "t.visibility.png"])
        planes = exr.read(self.path("t.visibility.exr"))
        self.assertEqual(list(planes), self.layered((0, 2)))
        self.expect(planes, 0, 1)
        self.expect(planes, 2, -1)

    def test_render_writes_the_same_layers(self):
        scene = self.write([FAR_LAMP, TO_RIGHT])
        for backend in ("vulkan", "opengl"):
            self.ok("render", "--technique", "CSSM2", "--backend", backend, "--scene", scene, "--size", "32x32", "--visibility",
                    "-o", self.path("t"))
            self.assertEqual(self.files(), ["t.exr", "t.png", "t.visibility.exr",
                                            "t.visibility.png"])
            planes = exr.read(self.path("t.visibility.exr"))
            # The scene's numbers, not those of the lights that reach the view.
            self.assertEqual(list(planes), self.layered((1,)))
            self.assertEqual(planes["light1.opaque.R"][2][2], 1)

    def test_400_lights(self):
        lights = [({"type": "point", "range": 9}, {"translation": [i % 20 / 5 - 2, 3, i // 20 / 5 - 2]})
                  for i in range(400)]
        scene = self.write(lights)
        self.ok("truth", "--scene", scene, "--size", "64x64", "--quiet", "--no-cache", "-o",
                self.path("t"))
        self.assertEqual(len(self.files()), 5)
        self.assertEqual(exr.names(self.path("t.visibility.exr")), self.layered(range(400)))
        refused = run("truth", "--scene", scene, "--size", "2048x2048", "--max-memory", "4096",
                      "-o", self.path("u"))
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(refused.stderr, r"a truth of 2048x2048 with 400 lights needs [\d.]+ GiB, "
                                         r"expected at most 4\.0 GiB")

    def test_only_what_is_written_must_be_writable(self):
        lit, dark = self.write([TO_RIGHT]), self.path("dark.gltf")
        with open(dark, "w") as file:
            json.dump(paneScene([FAR_LAMP]), file)
        for taken, fails in (("t.visibility.exr", True), ("t.visibility.png", True),
                             ("t.edges.png", True), ("t.visibility.light0.opaque.exr", False)):
            os.mkdir(self.path(taken))
            result = run("truth", "--scene", lit, "--size", "8x8", "--quiet", "-o", self.path("t"))
            self.assertEqual(result.returncode, 2 if fails else 0, result.stderr)
            if fails:
                self.assertIn(taken, result.stderr)
                self.assertEqual(self.files(), [taken])
            os.rmdir(self.path(taken))
        for name in self.files():
            os.remove(self.path(name))
        result = self.ok("truth", "--scene", dark, "--size", "8x8", "--quiet", "-o", self.path("t"))
        self.assertIn("no light can reach what is seen", result.stderr)
        self.assertEqual(self.files(), ["t.edges.png", "t.exr", "t.png"])


if __name__ == "__main__":
    main()
