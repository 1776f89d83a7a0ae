#!/usr/bin/env python3
"""The real program from outside: cli_test.py BENCH SOURCE_DIR [unittest arguments].

Arguments and their errors, names, files, Google Benchmark's flags, compare.py, signals, missing
drivers, scenes exported and read again, and every command of the README. No test looks at a time.
"""
import csv
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import unittest

BENCH = ""
SOURCE = ""
COMPARE = "/usr/share/benchmark/compare.py"
# Cells that cost little; six repetitions are the fewest with an interval.
FAST = ["--size", "32x32", "--benchmark_repetitions=2", "--quiet"]
NO_VULKAN = {"VK_ICD_FILENAMES": "/nonexistent", "VK_DRIVER_FILES": "/nonexistent"}
NO_EGL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}


def run(*arguments, env=None, cwd=None, timeout=120):
    return subprocess.run([BENCH, *arguments], capture_output=True, text=True, timeout=timeout,
                          env={**os.environ, **(env or {})}, cwd=cwd)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def ok(self, *arguments, **options):
        result = run(*arguments, **options)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stdout}{result.stderr}")
        return result


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
        self.refused(["--filter=CSM2/vulkan/windo"], "--filter", "CSSM2/vulkan/window/512x512")
        self.refused(["--benchmark_filter=CSM2/vulkan/windo"], "CSSM2/vulkan/window/512x512")
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
        self.assertEqual({name.split("/")[1] for name in names}, {"vulkan", "opengl"})
        for technique in ("none", "ShadowMap", "CSSM2"):
            self.assertIn(f"{technique}/vulkan/window/256x256", names)
        self.assertEqual(self.ok("--benchmark_list_tests").stdout.split(), names)
        self.assertIn("opengl-osmesa", self.ok("--list", "--gl=osmesa").stdout)
        text = self.ok("--help").stdout
        for option in ("--filter", "--set", "--budget", "--precision", "--json", "render", "doctor",
                       "Exit code"):
            self.assertIn(option, text)
        self.assertRegex(self.ok("--version").stdout, r"^\d+\.\d+\.\d+\n$")

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


class Measuring(Case):
    def test_table_json_csv_and_compare(self):
        files = [self.path("a.json"), self.path("b.json")]
        for file in files:
            # Ten repetitions: enough for the U test. OSMesa is named, so a failure would be a row.
            result = self.ok("--technique", "ShadowMap", "--backend", "vulkan,opengl", "--scene",
                             "layers", "--size", "32x32", "--benchmark_repetitions=10", "--json",
                             file, "--csv", self.path("a.csv"))
            self.assertIn("ShadowMap/opengl/layers/32x32", result.stdout)
            if "(software)" in result.stdout:
                self.assertNotIn("GPU", result.stdout)
            self.assertRegex(result.stderr, r"\[ *\d+ %\] layers")  # progress, line by line
            self.assertNotIn("\r", result.stderr)
        with open(files[0]) as file:
            entries = json.load(file)["benchmarks"]
        medians = [e for e in entries if e.get("aggregate_name") == "median"]
        self.assertEqual(len(medians), 2)
        self.assertEqual(len(entries), 22)
        for entry in medians:
            self.assertEqual(entry["status"], "ok")
            self.assertTrue(entry["stable"])
            self.assertEqual(entry["stopped_by"], "repetitions")
            self.assertEqual(entry["nonfinite"], 0)
            self.assertIsNotNone(entry["cross_backend_over_1_255"])
            if entry["combined_ms"] is not None:
                self.assertLessEqual(entry["combined_ms"], entry["stamped_frame_ms"])
            else:
                self.assertIn("not trusted", entry["combined_ms_why"])
            if entry["device_type"] == "software":
                self.assertEqual(entry["time_source"], "software")
            for key, value in entry.items():
                if value is None:
                    self.assertIn(key + "_why", entry)
        with open(self.path("a.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([r["name"] for r in rows], [e["run_name"] for e in medians])
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.csv", "a.json", "b.json"])
        self.compare(files[0], files[1], "_pvalue", "U Test, Repetitions: 10 vs 10")

        # A cell that has a time in one file and none in the other.
        skipped = self.path("c.json")
        result = run("--technique", "ShadowMap", "--backend", "vulkan,opengl", "--scene", "layers",
                     "--size", "32x32", "--benchmark_repetitions=10", "--quiet", "--json", skipped,
                     env=NO_VULKAN)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(skipped) as file:
            entry = json.load(file)["benchmarks"][0]
        self.assertEqual(entry["status"], "skipped")
        self.assertEqual([k for k in entry if "time" in k or k.endswith("_ms")], [])
        self.compare(files[0], skipped, "ShadowMap/opengl")
        self.compare(skipped, files[0], "ShadowMap/opengl")

    def compare(self, a, b, *words):
        python = next((p for p in (sys.executable, "/usr/bin/python3")
                       if subprocess.run([p, "-c", "import scipy"], capture_output=True).returncode
                       == 0), None)
        if not python or not os.path.exists(COMPARE):
            self.skipTest("compare.py of libbenchmark-tools or python3-scipy is not there")
        result = subprocess.run([python, COMPARE, "--no-color", "benchmarks", a, b],
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        for word in words:
            self.assertIn(word, result.stdout)

    def test_google_benchmark_flags(self):
        out = self.path("out.json")
        result = self.ok("--technique", "none", "--scene", "layers", "--backend", "vulkan", *FAST,
                         "--benchmark_format=json", f"--benchmark_out={out}", "--json",
                         self.path("own.json"))
        printed = json.loads(result.stdout)["benchmarks"]
        with open(out) as file:
            written = json.load(file)["benchmarks"]
        with open(self.path("own.json")) as file:
            own = json.load(file)["benchmarks"]
        for entries in (printed, written):
            iterations = [e for e in entries if e["run_type"] == "iteration"]
            self.assertEqual(len(iterations), 2)
            self.assertEqual({e["aggregate_name"] for e in entries if e not in iterations},
                             {"mean", "median", "stddev", "cv"})
            for found, expected in zip(iterations, own):
                self.assertEqual(found["name"], "none/vulkan/layers/32x32")
                self.assertEqual(found["iterations"], expected["iterations"])
                self.assertAlmostEqual(found["real_time"], expected["real_time"], 5)
                self.assertAlmostEqual(found["cpu_time"], expected["cpu_time"], 5)
                self.assertIn("draws", found)
        result = self.ok("--technique", "none", "--scene", "layers", "--backend", "vulkan", *FAST,
                         "--benchmark_counters_tabular=true", f"--benchmark_out={out}",
                         "--benchmark_out_format=csv")
        self.assertRegex(result.stdout, r"CPU +Iterations +bytes +draws")
        with open(out) as file:
            self.assertIn("none/vulkan/layers/32x32", file.read())
        result = self.ok("--technique", "none", "--scene", "layers", "--backend", "vulkan",
                         "--size", "16x16", "--benchmark_min_time=0.2", "--quiet")
        self.assertIn("none/vulkan/layers/16x16", result.stdout)

    def test_validation_marks_results(self):
        file = self.path("a.json")
        result = self.ok("--technique", "none", "--scene", "layers", *FAST, "--validate", "--json",
                         file)
        self.assertIn("CONTAMINATED", result.stdout)
        with open(file) as text:
            for entry in json.load(text)["benchmarks"]:
                if entry["run_type"] != "aggregate":
                    continue
                self.assertIn("validation is on", entry["contamination"])
                self.assertEqual(entry["ratios"], [])
                self.assertEqual([w for w in entry["warnings"] if "validation:" in w], [])

    def test_an_interrupt_keeps_what_is_finished(self):
        file = self.path("a.json")
        process = subprocess.Popen(
            [BENCH, "--technique", "none", "--backend", "vulkan", "--scene", "layers", "--scene",
             "window", "--size", "16x16", "--budget", "1000", "--precision", "0.0001", "--json",
             file], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        for line in process.stderr:
            if "layers: measure" in line:
                break
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted; 0 of 2", errors)
        with open(file) as text:
            self.assertEqual(json.load(text)["benchmarks"], [])

        # The first scene is finished when the second one begins.
        process = subprocess.Popen(
            [BENCH, "--technique", "none", "--backend", "vulkan", "--scene", "layers", "--scene",
             "spheres_quads:quads=2000", "--size", "16x16", "--benchmark_repetitions=40", "--json",
             file], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        for line in process.stderr:
            if "spheres_quads" in line:
                break
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        self.assertIn("none/vulkan/layers/16x16", output)
        with open(file) as text:
            names = {e["run_name"] for e in json.load(text)["benchmarks"]}
        self.assertEqual(names, {"none/vulkan/layers/16x16"})


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


class Scenes(Case):
    def test_the_export_renders_the_same_picture(self):
        for scene in ("layers", "window"):
            with self.subTest(scene):
                file = self.path(f"{scene}.glb")
                self.ok("scene", scene, "--export", file)
                for name, source in (("a", scene), ("b", file)):
                    self.ok("render", "--technique", "ShadowMap", "--scene", source, "--size",
                            "48x32", "-o", self.path(name), "--visibility")
                for suffix in (".png", ".exr", ".visibility.light0.opaque.exr"):
                    with open(self.path("a" + suffix), "rb") as a:
                        with open(self.path("b" + suffix), "rb") as b:
                            self.assertEqual(a.read(), b.read(), suffix)

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
        for line in "".join(blocks).splitlines():
            words = shlex.split(line, comments=True)
            if not words or words[0] != "./bench":
                continue
            commands += 1
            words = words[1:]
            if not words or words[0].startswith("-"):
                words += ["--budget", "0.01", "--benchmark_repetitions=1"]
                # A size of the README's own stays.
                words += [] if "--size" in words else ["--size", "16x16"]
            with self.subTest(line):
                self.ok(*words, cwd=self.folder)
        self.assertGreater(commands, 5)


if __name__ == "__main__":
    BENCH, SOURCE = (os.path.abspath(path) for path in sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
