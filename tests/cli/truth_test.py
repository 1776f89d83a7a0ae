#!/usr/bin/env python3
"""The truth and its cache, suites, reports, changed scenes."""
import glob
import json
import os

from program import FAST, Case, run, main

# A triangle under a lamp with a radius.
AREA_LIGHT = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "extras": {"shadowbench": {"radius": 0.5}}}]}},
    "nodes": [{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}},
                            "translation": [0, 0, 2]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,"
                 "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
}


class Truth(Case):
    def test_pictures_and_cache(self):
        cache = {"XDG_CACHE_HOME": self.path("cache")}
        arguments = ["truth", "--scene", "layers", "--size", "32x24", "--quiet", "-o",
                     self.path("t")]
        first = self.ok(*arguments, env=cache).stdout
        self.assertRegex(first, r"\d+ rays in [\d.]+ s: [\d.]+ million a second\n$")
        for part in ("", ".visibility"):
            for extension in (".png", ".exr"):
                self.assertTrue(os.path.getsize(self.path("t" + part + extension)) > 0)
        self.assertTrue(os.path.exists(self.path("t.edges.png")))
        self.assertIn("by an earlier run", self.ok(*arguments, env=cache).stdout)
        self.assertNotIn("by an earlier run",
                         self.ok(*arguments, "--no-cache", env=cache).stdout)
        self.assertIn(" 1 truths", self.ok("cache", env=cache).stdout)
        self.assertIn("removed", self.ok("cache", "--clear", env=cache).stdout)
        self.assertIn(" 0 truths", self.ok("cache", env=cache).stdout)

        # A truth that was cut off is traced again.
        self.ok(*arguments, env=cache)
        file, = glob.glob(self.path("cache/**/*.truth"), recursive=True)
        os.truncate(file, os.path.getsize(file) // 2)
        self.assertNotIn("by an earlier run", self.ok(*arguments, env=cache).stdout)

    def write(self, name, scene):
        path = self.path(name)
        with open(path, "w") as file:
            json.dump(scene, file)
        return path

    def entries(self, *arguments):
        """Aggregates of a run by name of technique and number of rays."""
        results = self.path("r.json")
        self.ok("--backend", "vulkan", *arguments, *FAST, "--json", results)
        with open(results) as file:
            return {(e["technique"], e["knobs"].get("rays")): e
                    for e in json.load(file)["benchmarks"] if e["run_type"] == "aggregate"}

    def test_media(self):
        fog = {**AREA_LIGHT, "nodes": AREA_LIGHT["nodes"] + [
            {"extras": {"shadowbench": {"medium": {"extinction": [1, 1, 1]}}}}]}
        fog["scenes"] = [{"nodes": [0, 1, 2]}]
        scene = self.write("fog.gltf", fog)
        self.ok("truth", "--scene", scene, "--size", "8x8", "-o", self.path("t"))
        self.assertTrue(os.path.exists(self.path("t.png")))
        entries = self.entries("--technique", "none,RayTraced", "--scene", scene)
        self.assertIn("participating-media", entries["none", None]["effects_unrepresented"])
        self.assertIsNotNone(entries["none", None]["image"])
        self.assertEqual(entries["RayTraced", "1"]["status"], "ok")

    def test_area_lights(self):
        scene = self.write("area.gltf", AREA_LIGHT)
        self.ok("truth", "--scene", scene, "--size", "8x8", "-o", self.path("t"))
        entries = self.entries("--technique", "ShadowMap,RayTraced", "--set", "rays=1,4,256",
                               "--scene", "penumbra")
        maps = entries["ShadowMap", None]
        self.assertIn("area-lights", maps["effects_unrepresented"])
        self.assertGreater(maps["truth_stderr"], 0)
        self.assertLess(maps["truth_stderr"], 5e-4)
        self.assertIs(maps["below_truth"], False)
        errors = [entries["RayTraced", n]["visibility"]["rmse"] for n in ("1", "4", "256")]
        # One ray gives hard shadows, as maps do; more rays are a front of their own.
        self.assertGreater(errors[0], 0.02)
        self.assertLess(errors[1], 0.8 * errors[0])
        self.assertLess(errors[2], 0.1 * errors[0])
        self.assertIn("rays", self.ok("--help").stdout)
        result = run("--technique", "RayTraced", "--scene", "penumbra", "--set", "rays=3", "--list")
        self.assertEqual(result.returncode, 2)
        self.assertIn("rays", result.stderr)

    def test_wrong_arguments(self):
        for arguments, text in ((("truth", "--scene", "layers", "--scene", "window"), "one"),
                                (("truth", "--scene", "layer"), "unknown scene"),
                                (("truth", "--size", "0x4"), "--size"),
                                (("truth", "--technique", "none"), "--technique")):
            result = run(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(text, result.stderr)


class Suites(Case):
    def test_a_suite_a_report_and_no_truth(self):
        suite, html, results = self.path("s.toml"), self.path("r.html"), self.path("r.json")
        with open(suite, "w") as file:
            file.write('title = "t"\nseeds = 2\n[[run]]\nscenes = ["layers"]\nsize = "32x32"\n'
                       'backends = ["vulkan"]\ntechniques = ["none", "RayTraced", "CSSM2"]\n'
                       'sweep.kernel = [1, 3, 9]\n')
        result = self.ok("--suite", suite, "--benchmark_repetitions=2", "--quiet", "--html", html,
                         "--json", results)
        for text in ("CSSM2/vulkan/layers/kernel:3/32x32", "error ~ knob", "16 x none"):
            self.assertIn(text, result.stdout)
        with open(html) as file:
            page = file.read()
        self.assertIn("CSSM2/vulkan/layers/kernel:3/32x32", page)
        # The same page from the files alone.
        self.ok("report", results, "-o", self.path("again.html"))
        with open(self.path("again.html")) as file:
            self.assertEqual(file.read(), page)
        with open(results) as file:
            cssm2 = [e for e in json.load(file)["benchmarks"]
                     if e["run_type"] == "aggregate" and e["technique"] == "CSSM2"]
        self.assertEqual([e["noise"]["seeds"] for e in cssm2], [2, 2, 2])
        self.assertEqual(os.listdir(self.folder).count("r.pictures"), 1)

        # Without JSON the pictures go into the page and nowhere else.
        os.mkdir(self.path("empty"))
        self.ok("--technique", "none", "--scene", "layers", *FAST, "--html", "page.html",
                cwd=self.path("empty"))
        self.assertEqual(os.listdir(self.path("empty")), ["page.html"])

        self.ok("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST,
                "--no-truth", "--json", results)
        with open(results) as file:
            entry = json.load(file)["benchmarks"][-1]
        self.assertIsNone(entry["visibility"])
        self.assertEqual(entry["visibility_why"], "no truth was asked for")

    def test_mistakes(self):
        suite = self.path("s.toml")
        with open(suite, "w") as file:
            file.write('[[run]]\nscenes = ["layers"]\ntechniques = ["Cssm2"]\n')
        for arguments, text in ((("--suite", suite), "s.toml:1: run 1: unknown technique 'Cssm2'"),
                                (("--suite", "accurac"), "accuracy"),
                                (("--suite", "accuracy", "--scene", "layers"), "--suite"),
                                (("--seeds", "0"), "--seeds"),
                                (("--set-material", "zzz:alpha=1", "--scene", "layers"),
                                 "unknown material 'zzz'")):
            result = run(*arguments, "--json", self.path("none.json"))
            self.assertEqual(result.returncode, 2, (arguments, result.stderr))
            self.assertIn(text, result.stderr)
            self.assertFalse(os.path.exists(self.path("none.json")))

    def test_changed_scenes_are_named_and_can_be_run_again(self):
        names = self.ok("--list", "--technique", "none", "--backend", "vulkan", "--scene", "teapot",
                        "--set-material", "*:alpha=0.5,t=0.9", "--sun", "direction=0,-1,0",
                        "--camera", "eye=0,1,5,at=0,0,0").stdout.split()
        self.assertEqual(names, ["none/vulkan/teapot?*:alpha=0.5,t=0.9,0.9,0.9;camera:eye=0,1,5,"
                                 "at=0,0,0;sun:direction=0,-1,0/512x512"])
        results = self.path("r.json")
        self.ok("--technique", "none", "--backend", "vulkan", "--scene", "layers", "--set-material",
                "*:alpha=0.5", *FAST, "--json", results)
        with open(results) as file:
            entry = json.load(file)["benchmarks"][-1]
        self.assertIn("--scene 'layers?*:alpha=0.5'", entry["command"])

    def test_a_camera_in_motion_ends_where_it_stands(self):
        motion = ("--motion", "turn=10,move=1,0,0,steps=3")
        names = self.ok("--list", "--technique", "none", "--backend", "vulkan", "--scene", "layers",
                        *motion).stdout.split()
        self.assertEqual(names, ["none/vulkan/layers?motion:move=1,0,0,turn=10,steps=3/512x512"])
        pictures = []
        for arguments in (motion, ()):
            self.ok("render", "--technique", "CSSM2", "--backend", "vulkan", "--scene", "layers",
                    "--set", "size=128", "--size", "64x64", *arguments, "-o", self.path("p"))
            with open(self.path("p.exr"), "rb") as file:
                pictures.append(file.read())
        self.assertEqual(pictures[0], pictures[1])


if __name__ == "__main__":
    main()
