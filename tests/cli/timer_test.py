"""Devices whose time stamps wrap, jump, lie or are missing: a layer poses as such a GPU."""
import json
import os
import unittest

from program import Case, main, run

LAYER = os.environ.get("SHADOWBENCH_FAKE_GPU", "")
CELLS = ["--scene", "layers", "--size", "64x64", "--backend", "vulkan", "--technique",
         "none,ShadowMap", "--no-truth", "--quiet"]


def fake(**settings):
    return {"VK_LAYER_PATH": LAYER, "VK_INSTANCE_LAYERS": "VK_LAYER_SHADOWBENCH_fake_gpu",
            **{"FAKE_" + name.upper(): str(value) for name, value in settings.items()}}


@unittest.skipUnless(os.path.exists(os.path.join(LAYER, "fake_gpu.json")), "the layer is not built")
class Timers(Case):
    def measured(self, *arguments, code=0, **settings):
        out = self.path("out.json")
        result = run(*CELLS, "--json", out, *arguments, env=fake(**settings))
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        with open(out) as file:
            entries = json.load(file)["benchmarks"]
        return [e for e in entries if e["run_type"] == "aggregate"], [
            e for e in entries if e["run_type"] == "iteration"]

    def test_a_counter_that_wraps_within_a_frame(self):
        # 36 bits of 52 ns, as some integrated GPUs have: an hour. Within the frames under test.
        for reading in (60, 100, 140):
            records, blocks = self.measured("--benchmark_repetitions=60", bits=36, period=52.0833,
                                            event=f"wrap:{reading}")
            for record in records:
                self.assertEqual(record["time_source"], "gpu-timestamp")
                self.assertEqual(record["dropped_frames"], 0, record["warnings"])
                self.assertLess(record["frame_ms"]["p99"], 1000)
            self.assertLess(max(b["real_time"] for b in blocks), 1e6)

    def test_a_frame_in_which_the_counter_is_reset_is_dropped_and_counted(self):
        records, blocks = self.measured("--benchmark_repetitions=60", bits=64, event="reset:120")
        self.assertEqual(sum(r["dropped_frames"] for r in records), 1)
        self.assertEqual(sum("1 frames were dropped" in " ".join(r["warnings"]) for r in records), 1)
        self.assertLess(max(b["real_time"] for b in blocks), 1e6)

    def test_a_counter_that_is_always_reset_is_not_believed(self):
        out = self.path("out.json")
        result = run(*CELLS, "--json", out, "--benchmark_repetitions=2", env=fake(event="reset:*"))
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn("timer not trusted", result.stdout)

    def test_a_clock_that_is_too_slow_or_too_fast_is_not_believed(self):
        for speed in (1e-3, 10):
            result = run(*CELLS, "--benchmark_repetitions=2", env=fake(speed=speed))
            self.assertEqual(result.returncode, 1, f"{speed}\n{result.stdout}{result.stderr}")
            self.assertIn("timer not trusted", result.stdout, speed)

    def test_a_device_without_timestamps_is_measured_by_wall_time(self):
        records, _ = self.measured("--benchmark_repetitions=2", bits=0)
        self.assertEqual(len(records), 2)
        for record in records:
            self.assertEqual(record["time_source"], "wall")
            self.assertGreater(record["frame_ms"]["median"], 0)
            self.assertEqual(record["frame_ms"]["median"], record["wall_ms"]["median"])
            self.assertIsNone(record["device_ms"])
            self.assertIsNone(record["shadow_ms"])
            self.assertIn("no timestamps", record["shadow_ms_why"])
        picture = self.path("a")
        result = run("render", "--scene", "layers", "--size", "64x64", "--backend", "vulkan", "-o",
                     picture, env=fake(bits=0))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(os.path.exists(picture + ".png"))


if __name__ == "__main__":
    main()
