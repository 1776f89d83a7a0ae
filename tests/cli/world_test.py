#!/usr/bin/env python3
"""Missing drivers, scenes exported and read again, every command of the README."""
import filecmp
import json
import os
import re
import shlex

from program import FAST, NO_EGL, NO_VULKAN, SOURCE, Case, run, main


class Drivers(Case):
    def test_a_missing_driver_is_named_and_the_other_goes_on(self):
        for env, gone, left in ((NO_VULKAN, "vulkan", "opengl"), (NO_EGL, "opengl", "vulkan")):
            with self.subTest(gone):
                result = self.ok("--technique", "none", "--scene", "layers", *FAST, env=env)
                self.assertIn(f"backend {gone} does not start", result.stderr)
                self.assertIn(f"none/{left}/layers", result.stdout)
                self.assertNotIn(f"none/{gone}/layers", result.stdout)
                named = run("--backend", gone, "--technique", "none", "--scene", "layers", *FAST,
                            env=env)
                self.assertEqual(named.returncode, 1)
                self.assertIn("skipped: the backend does not start", named.stdout)

    def test_no_driver_at_all_is_a_failure_that_says_so(self):
        result = run("--technique", "none", "--scene", "layers", *FAST, env={**NO_VULKAN, **NO_EGL})
        self.assertEqual(result.returncode, 1)
        for backend in ("vulkan", "opengl"):
            self.assertIn(f"backend {backend} does not start", result.stderr)

    def test_doctor_says_why(self):
        text = self.ok("doctor", env={**NO_VULKAN, **NO_EGL}).stdout
        self.assertEqual(text.count("not available: "), 2)
        self.assertIn("opengl-osmesa", text)
        self.assertIn("twice the work takes twice the time", text)
        self.assertNotIn("GPU", text)

    def test_a_vector_width_of_llvmpipe_neither_corrupts_nor_mixes(self):
        cache = {"MESA_SHADER_CACHE_DIR": self.path("cache")}
        narrow = {**cache, "LP_NATIVE_VECTOR_WIDTH": "128"}
        for backend in ("vulkan", "opengl"):
            cell = ["render", "--backend", backend, "--technique", "ShadowMap", "--scene", "teapot",
                    "--size", "64x64", "--output"]
            # The first leaves code of the default width in the driver's cache.
            self.ok(*cell, self.path("wide"), env=cache)
            self.ok(*cell, self.path("narrow"), env=narrow)
            self.assertTrue(filecmp.cmp(self.path("wide.exr"), self.path("narrow.exr"), False))
        # Nor may a run at another width leave code behind.
        empty = {**narrow, "MESA_SHADER_CACHE_DIR": self.path("empty")}
        self.ok(*cell, self.path("again"), env=empty)
        self.assertEqual([f for _, _, f in os.walk(self.path("empty")) if f], [])
        said = "LP_NATIVE_VECTOR_WIDTH=128: software devices run at this width"
        self.assertIn(f"WARNING: {said}", self.ok("doctor", env=narrow).stdout)
        json_file = self.path("r.json")
        measured = self.ok("--technique", "none", "--scene", "layers", "--backend", "vulkan",
                           "--no-truth", "--json", json_file, *FAST, env=narrow)
        self.assertIn(said, measured.stderr)
        with open(json_file) as file:
            self.assertIn(said, json.load(file)["context"]["warnings"][0])

    def test_a_vector_width_that_crashes_the_driver_is_refused(self):
        for width in ("0", "64", "96", "300", "1024", "-128", "x"):
            with self.subTest(width):
                env = {"LP_NATIVE_VECTOR_WIDTH": width}
                for command in (["render", "--output", self.path("x")], ["--json", self.path("x")]):
                    result = run(*command, "--technique", "none", "--scene", "layers", env=env)
                    self.assertEqual(result.returncode, 2, result.stderr)
                    self.assertIn(f"LP_NATIVE_VECTOR_WIDTH: is '{width}'", result.stderr)
                    self.assertIn("expected 128", result.stderr)
        self.assertEqual(os.listdir(self.folder), [])
        text = self.ok("doctor", env={"LP_NATIVE_VECTOR_WIDTH": "64"}).stdout
        self.assertIn("WARNING: LP_NATIVE_VECTOR_WIDTH is '64'", text)


class Scenes(Case):
    def test_the_export_renders_the_same_picture(self):
        for scene in ("layers", "window"):
            with self.subTest(scene):
                file = self.path(f"{scene}.glb")
                self.ok("scene", scene, "--export", file)
                for name, source in (("a", scene), ("b", file)):
                    self.ok("render", "--technique", "ShadowMap", "--scene", source, "--size",
                            "48x32", "-o", self.path(name), "--visibility")
                for suffix in (".png", ".exr", ".visibility.exr", ".visibility.png"):
                    with open(self.path("a" + suffix), "rb") as a:
                        with open(self.path("b" + suffix), "rb") as b:
                            self.assertEqual(a.read(), b.read(), suffix)

    def test_an_export_stands_still_and_says_so(self):
        file = self.path("mine.glb")
        moving = self.ok("scene", "mine:moving=0.5?motion:steps=2", "--export", file)
        self.assertIn(f"warning: {file} holds the scene where its motion ends", moving.stderr)
        self.assertEqual(self.ok("scene", "mine", "--export", file).stderr, "")

    def test_the_ending_of_a_picture_is_no_part_of_its_prefix(self):
        for name in ("a.png", "b.exr", "c", "d.x"):
            self.ok("render", "--technique", "none", "--scene", "layers", "--backend", "vulkan",
                    "--size", "16x16", "-o", self.path(name))
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["a.exr", "a.png", "b.exr", "b.png", "c.exr", "c.png", "d.x.exr",
                          "d.x.png"])

    def test_scene_says_what_is_in_it(self):
        self.assertIn("triangles", self.ok("scene", "teapot").stdout)
        self.assertIn("meshes", json.loads(self.ok("scene", "teapot", "--json").stdout))


class Readme(Case):
    """Every command line of the README runs; measuring ones with a small budget."""

    def test_commands(self):
        with open(os.path.join(SOURCE, "README.md")) as file:
            blocks = re.findall(r"```sh\n(.*?)```", file.read(), re.DOTALL)
        self.assertTrue(blocks)
        scene = self.path("scene.glb")
        self.ok("scene", "teapot", "--export", scene)
        commands = 0
        before = self.source_files()
        for line in "".join(blocks).splitlines():
            words = shlex.split(line, comments=True)
            if not words or words[0] != "./bench":
                continue
            commands += 1
            words = words[1:]
            if not words or words[0].startswith("-"):
                words += ["--budget", "0.01", "--benchmark_repetitions=1", "--seeds", "1"]
                # A suite takes minutes: one technique of it.
                if "--suite" in words:
                    words += ["--filter", "^G8/ShadowMap/" if "--scene" in words else
                              "^(ShadowMap|TranslucentShadows)/vulkan/layers"]
                # The quick suite is every technique on every scene: here, on one.
                chosen = ("--suite", "--filter", "--technique", "--scene")
                if not any(word.startswith(chosen) for word in words):
                    words += ["--filter", "/layers/"]
                # A size of the README's own stays.
                words += [] if "--size" in words else ["--size", "16x16"]
            with self.subTest(line):
                self.ok(*words, cwd=self.folder, timeout=400)
        self.assertGreater(commands, 5)
        self.assertEqual(self.source_files(), before)

    @staticmethod
    def source_files():
        found = set()
        for folder, folders, files in os.walk(SOURCE):
            folders[:] = [f for f in folders if f != ".git" and not f.startswith("build")]
            found |= {os.path.join(folder, f) for f in files}
        return found


if __name__ == "__main__":
    main()
