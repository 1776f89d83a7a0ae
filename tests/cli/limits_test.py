#!/usr/bin/env python3
"""Numbers out of range, and what does not fit the memory."""
import json
import os

from program import FAST, SOURCE, Case, cells_of, main, names_of, run


class Limits(Case):
    def test_numbers_neither_wrap_nor_are_ignored(self):
        suite = self.path("s.toml")
        for arguments, option in (
                (["--size", "4294967297x4294967297"], "--size"), (["--size", "1e2x1"], "--size"),
                (["--size", "16385x1"], "--size"), (["--seed", "4294967296"], "--seed"),
                (["--seed", "1.5"], "--seed"), (["--seed", "0x10"], "--seed"),
                (["--seeds", "0.5"], "--seeds"), (["--seeds", "1e300"], "--seeds"),
                (["--budget", "inf"], "--budget"), (["--budget", "1e400"], "--budget"),
                (["--precision", "nan"], "--precision"), (["--max-memory", "0"], "--max-memory"),
                (["render", "--exposure", "nan"], "--exposure"),
                (["render", "--exposure", "inf"], "--exposure"),
                (["truth", "--exposure", "-1"], "--exposure"),
                (["--benchmark_min_time=1e400"], "--benchmark_min_time"),
                (["--benchmark_format=xml"], "--benchmark_format"),
                (["--scene", "spheres_quads:quads=1e300"], "quads"),
                (["--scene", "spheres_quads:quads=0.5"], "quads"),
                (["--scene", "layers:gap=nan"], "gap")):
            with self.subTest(arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(option, result.stderr)
        for line in ("seeds = 1e300", "seeds = 0.5", "seeds = 0", "budget = inf", "budget = nan",
                     "precision = -1"):
            with open(suite, "w") as file:
                file.write(line + '\n[[run]]\nscenes = ["layers"]\n')
            result = run("--suite", suite)
            self.assertEqual(result.returncode, 2, line)
            self.assertIn(f"s.toml:1: {line.split()[0]}", result.stderr)

    def test_what_is_too_large_is_refused_with_the_figure(self):
        for arguments, word in ((["truth", "--size", "16384x16384", "--max-memory", "30000"], "truth"),
                                (["render", "--size", "16384x16384", "--max-memory", "2000"],
                                 "picture"),
                                (["--scene", "layers", "--size", "16384x16384", "--max-memory",
                                  "30000"], "truth")):
            result = run(*arguments, cwd=self.folder)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("--max-memory", result.stderr)
            self.assertRegex(result.stderr, word + r".* needs [\d.]+ GiB, expected at most [\d.]+ GiB")
        suite = self.path("s.toml")
        with open(suite, "w") as file:
            values = ", ".join(str(64 + i) for i in range(1000))
            file.write('[[run]]\nscenes = ["layers"]\ntechniques = ["CSSM2"]\n'
                       f'grid.size = [{values}]\ngrid.kernel = [{values}]\n')
        result = run("--suite", suite)
        self.assertEqual(result.returncode, 2)
        self.assertIn("more than 100000 cells", result.stderr)

    def test_a_skip_for_memory_is_no_success_unless_allowed(self):
        arguments = ["--technique", "none,ShadowMap", "--set", "size=8192", "--backend", "vulkan",
                     "--scene", "layers", *FAST, "--no-truth", "--max-memory", "200"]
        result = run(*arguments)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn("--allow-skips", result.stderr)
        self.assertIn("--max-memory", result.stdout)
        self.ok(*arguments, "--allow-skips")

    def test_maps_of_many_lights_that_do_not_fit_together_are_measured_apart(self):
        with open(os.path.join(SOURCE, "tests/cli/many_lights.gltf")) as file:
            scene = json.load(file)
        # Four of the twenty; their maps are small, and so is the memory.
        lights = [n for n in scene["nodes"] if "extensions" in n]
        for node in lights[4:]:
            del node["extensions"]
        del scene["extensions"]["KHR_lights_punctual"]["lights"][4:]
        with open(self.path("lights.gltf"), "w") as file:
            json.dump(scene, file)
        techniques = ["ShadowMap", "TranslucentShadows", "CSSM2", "CompositedTranslucent"]
        arguments = ["--scene", self.path("lights.gltf"), "--set", "size=256", "--no-truth", *FAST,
                     "--benchmark_repetitions=1"]
        whole, limited = self.path("whole.json"), self.path("limited.json")
        self.ok("--technique", ",".join(techniques), *arguments, "--json", whole)
        sizes = [e["bytes"] for e in cells_of(whole)]
        self.assertEqual(len(sizes), 8)
        self.assertGreater(sum(sizes), 2 * max(sizes))
        most = str(max(sizes) * 5 // 4 // 2**20 + 4)
        result = run("--technique", ",".join(techniques), *arguments, "--json", limited,
                     "--max-memory", most)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(names_of(limited), names_of(whole))
        cells = cells_of(limited)
        self.assertEqual([e["bytes"] for e in cells], sizes)
        self.assertIn("together they do not fit the memory", result.stdout + result.stderr)


if __name__ == "__main__":
    main()
