#!/usr/bin/env python3
"""Arguments and their errors; names of cells."""
import csv
import json
import os
import stat
import tempfile

from program import FAST, Case, run, main


class WrongInput(Case):
    def refused(self, arguments, *words):
        result = run(*arguments)
        self.assertEqual(result.returncode, 2, f"{arguments}: {result.stderr}")
        self.assertEqual(result.stdout, "")
        for word in words:
            self.assertIn(word, result.stderr, str(arguments))
        self.assertEqual(os.listdir(self.folder), [])

    def test_unknown_names_give_the_nearest(self):
        self.refused(["--technique", "CSM2"], "technique", "CSM2", "CSSM2")
        self.refused(["--technique", "CSSM2+Sortd"], "Sortd", "Sorted")
        self.refused(["--backend", "vulcan"], "--backend", "vulkan")
        self.refused(["--scene", "layer"], "layer", "layers")
        self.refused(["--scene", "spheres_quads:quad=3"], "quad", "quads")
        self.refused(["--set", "kernal=3"], "--set", "kernal", "kernel")
        self.refused(["--filter=CSM2/vulkan/windo"], "--filter", "CSSM2/vulkan/window/256x256")
        self.refused(["--benchmark_filter=CSM2/vulkan/windo"], "CSSM2/vulkan/window/256x256")
        self.refused(["scene", "layer"], "layers")
        self.refused(["render", "--technique", "CSM2"], "CSSM2")

    def test_bad_values_name_the_option_and_what_is_expected(self):
        for arguments, word in [
            (["--size", "0x3"], "--size"), (["--size", "3"], "--size"),
            (["--size", "99999x1"], "--size"), (["--seed", "-1"], "--seed"),
            (["--seed", "x"], "--seed"), (["--budget", "x"], "--budget"),
            (["--budget", "-1"], "--budget"), (["--precision", "0"], "--precision"),
            (["--precision", "nan"], "--precision"), (["--gl", "foo"], "--gl"),
            (["--set", "kernel"], "--set"), (["--set", "kernel=4"], "kernel"),
            (["--filter=("], "--filter"), (["--scene", "layers:gap=x"], "gap"),
            (["--benchmark_repetitions=x"], "--benchmark_repetitions"),
            (["--benchmark_nonsense=1"], "--benchmark_nonsense"),
            (["--nonsense"], "--nonsense"), (["nonsense"], "nonsense"),
            (["--json", self.path("x"), "doctor"], "--json"),
            (["doctor", "--benchmark_filter=x"], "--benchmark_filter"),
            (["--filter=x", "--benchmark_filter=x"], "--benchmark_filter"),
            (["render", "--technique", "none,CSSM2"], "render"),
            (["--scene", "/nonexistent.glb"], "/nonexistent.glb"),
            (["--shaders", "/nonexistent"], "/nonexistent"),
        ]:
            with self.subTest(arguments):
                self.refused(arguments, word)

    def test_files_that_cannot_be_written_are_refused_before_measuring(self):
        bad = "/nonexistent/x"
        for option in ("--json", "--csv"):
            self.refused([option, bad], option, bad)
        self.refused(["--json", self.folder], "--json", "folder")
        self.refused([f"--benchmark_out={bad}"], "--benchmark_out", bad)
        self.refused(["render", "-o", bad], "--output", bad)
        self.refused(["scene", "layers", "--export", bad + ".glb"], bad)

    def test_an_option_with_nothing_behind_its_equals_sign_takes_no_other(self):
        for option in ("--json", "--csv", "--filter", "--scene"):
            self.refused([option + "=", "--list"], option, "empty")

    def test_suites_of_endless_keys_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "x.toml")
            with open(path, "w") as file:
                file.write("a." * 40000 + "b = 1\n")
            self.refused(["--suite", path, "--list"], "x.toml:1", "dots")

    def test_an_export_leaves_pipes_and_links_what_they_are(self):
        link, target = os.path.join(self.folder, "l.glb"), os.path.join(self.folder, "t.glb")
        os.symlink(target, link)
        self.assertEqual(run("scene", "layers", "--export", link).returncode, 0)
        self.assertTrue(os.path.islink(link) and os.path.getsize(target) > 0)
        self.assertEqual(run("scene", "layers", "--export", "/dev/null").returncode, 0)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_complaints_name_the_option_that_was_typed(self):
        self.refused(["--sun", "0.3,-1,0.2"], "--sun", "direction=X,Y,Z")
        self.refused(["--camera", "eye=1,2,3", "--list"], "--camera", "at")
        self.refused(["--gltf-scene", "Foo", "--scene", "layers", "--no-truth"], "--gltf-scene 'Foo'")
        self.refused(["render", "--technique", "RayTraced"], "bench truth")
        self.refused(["--technique", "none", "--set", "kernel=3"], "which is a knob of")
        self.refused(["--backend", "metal"], "--backend: unknown backend 'metal'")
        self.refused(["compare", "a.json", "b.json"], "compare a.json b.json")

    def test_results_that_are_none_are_refused(self):
        self.refused(["report"], "results")
        self.refused(["report", "/nonexistent.json"], "/nonexistent.json")
        self.refused(["report", self.folder], self.folder)
        with open(self.path("a.json"), "w") as file:
            file.write('{"context": {"shadowbench_version": 3}, "benchmarks": []}')
        for arguments, word in (([], "context.shadowbench_version: found 3, expected a text"),
                                (["-o", "/nonexistent/x"], "--output"),
                                (["--pictures", "/nonexistent"], "--pictures")):
            result = run("report", self.path("a.json"), *arguments)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(word, result.stderr)
        self.assertEqual(os.listdir(self.folder), ["a.json"])

    def test_a_broken_file_is_refused_before_measuring(self):
        broken = self.path("broken.gltf")
        with open(broken, "w") as file:
            file.write('{"asset": {"version": "2.0"}, "scenes": 3}')
        result = run("--scene", "layers", "--scene", broken, *FAST)
        self.assertEqual(result.returncode, 2)
        self.assertIn(broken, result.stderr)
        self.assertEqual(result.stdout, "")

    def test_an_unknown_device_names_those_there_are(self):
        result = run("--device", "voodoo", "--scene", "layers", *FAST)
        self.assertEqual(result.returncode, 2)
        self.assertIn("voodoo", result.stderr)
        self.assertIn("--device", result.stderr)
        self.assertEqual(run("render", "--device", "voodoo", "-o", self.path("x")).returncode, 2)


class Names(Case):
    def test_list_and_help(self):
        names = self.ok("--list").stdout.split()
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual({name.split("/")[-1] for name in names}, {"256x256"})
        self.assertEqual({name.split("/")[1] for name in names}, {"vulkan", "opengl", "cpu"})
        for technique in ("none", "ShadowMap", "CSSM2"):
            self.assertIn(f"{technique}/vulkan/window/256x256", names)
        self.assertEqual(self.ok("--benchmark_list_tests").stdout.split(), names)
        self.assertIn("opengl-osmesa", self.ok("--list", "--gl=osmesa").stdout)
        text = self.ok("--help").stdout
        for option in ("--filter", "--set", "--budget", "--precision", "--json", "--suite", "--html",
                       "--no-truth", "render", "truth", "cache", "report", "doctor",
                       "Exit code"):
            self.assertIn(option, text)
        self.assertRegex(self.ok("--version").stdout, r"^ShadowBench \d+\.\d+\.\d+\n")

    def test_sweeps_and_filters(self):
        names = self.ok("--list", "--technique", "ShadowMap,none", "--backend", "vulkan", "--scene",
                        "layers", "--set", "size=512,1024", "--size", "8x8").stdout.split()
        self.assertEqual(sorted(names), ["ShadowMap/vulkan/layers/8x8",
                                         "ShadowMap/vulkan/layers/size:512/8x8",
                                         "none/vulkan/layers/8x8"])
        names = self.ok("--list", "--filter=^CSSM2/.*/window").stdout.split()
        self.assertEqual(len(names), 2)
        names = self.ok("--benchmark_list_tests=true", "--benchmark_filter=-CSSM2").stdout
        self.assertNotIn("CSSM2", names)


if __name__ == "__main__":
    main()
