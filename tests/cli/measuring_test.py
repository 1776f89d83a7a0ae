#!/usr/bin/env python3
"""Tables and files, Google Benchmark's flags, compare.py, validation, signals. No test looks at a time."""
import csv
import json
import os
import signal
import subprocess
import sys

from program import BENCH, COMPARE, FAST, NO_VULKAN, Case, run, main


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
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["a.csv", "a.json", "a.pictures", "b.json", "b.pictures"])
        pictures = os.listdir(self.path("a.pictures"))
        named = {hash + ".png" for e in medians for hash in e["pictures"].values()}
        self.assertEqual(sorted(pictures), sorted(named))
        for entry, row in zip(medians, rows):
            self.assertEqual(sorted(entry["pictures"]), ["blame", "error", "image", "truth"])
            # The panes cast no shadow here: the visibility is wrong and too light.
            self.assertGreater(entry["visibility"]["rmse"], 0.05)
            self.assertGreater(entry["visibility"]["bias"], 0)
            self.assertGreater(entry["blame"]["shares"]["leaking"], 0.1)
            self.assertAlmostEqual(sum(entry["blame"]["shares"].values()), 1, 6)
            self.assertGreater(entry["image"]["flip"], 0)
            self.assertAlmostEqual(float(row["visibility_rmse"]), entry["visibility"]["rmse"], 4)
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
        self.assertFalse(os.path.exists(file))

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


if __name__ == "__main__":
    main()
