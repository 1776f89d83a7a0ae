#!/usr/bin/env python3
"""Files that are written: mistakes with them, full disks."""
import os
import subprocess

from program import BENCH, FAST, Case, cells_of, main, run


class Outputs(Case):
    CELL = ["--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST]

    def refused(self, arguments, *words):
        before = sorted(os.listdir(self.folder))
        result = run(*arguments, cwd=self.folder)
        self.assertEqual(result.returncode, 2, f"{arguments}: {result.stderr}")
        for word in words:
            self.assertIn(word, result.stderr, str(arguments))
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_mistakes_with_files_are_refused_before_anything_runs(self):
        self.ok(*self.CELL, "--json", "r.json", cwd=self.folder)
        with open(self.path("s.toml"), "w") as file:
            file.write('[[run]]\nscenes = ["layers"]\n')
        self.ok("scene", "layers", "--export", "l.glb", cwd=self.folder)
        os.symlink("r.json", self.path("link.json"))
        os.symlink("nowhere/x.json", self.path("dangling.json"))
        os.symlink("loop.json", self.path("loop.json"))
        with open(self.path("taken.pictures"), "w"):
            pass
        cell = self.CELL
        for arguments, words in (
                ([*cell, "--json", "x", "--csv", "x"], ("--csv", "--json")),
                ([*cell, "--json", "x", "--csv", "./x"], ("--csv", "--json")),
                ([*cell, "--html", "x", "--benchmark_out=x"], ("--benchmark_out", "--html")),
                ([*cell, "--json", "r.json", "--csv", "link.json"], ("--csv", "--json")),
                ([*cell, "--json", "a.json", "--csv", "a.journal"], ("journal", "--csv")),
                ([*cell, "--json", ""], ("--json", "empty")),
                ([*cell, "--csv", ""], ("--csv", "empty")),
                ([*cell, "--benchmark_out="], ("--benchmark_out",)),
                ([*cell, "--json", "dangling.json"], ("--json", "nowhere")),
                ([*cell, "--json", "loop.json"], ("--json", "links lead nowhere")),
                ([*cell, "--json", "taken.json"], ("--json", "taken.pictures")),
                (["--scene", "l.glb", "--json", "l.glb"], ("--json", "scene")),
                (["--suite", "s.toml", "--csv", "s.toml"], ("--csv", "--suite")),
                (["report", "r.json", "-o", "r.json"], ("--output", "r.json")),
                (["report", "r.json", "-o", ""], ("--output", "empty")),
                (["report", "r.json", "-o", "link.json"], ("--output", "link.json")),
                (["report", "/dev/zero"], ("/dev/zero", "regular")),
                (["--suite", "/dev/zero.toml"], ("/dev/zero.toml",)),
                (["scene", "l.glb", "--export", "l.glb"], ("--export", "l.glb")),
                (["render", "-o", ""], ("--output", "empty"))):
            with self.subTest(arguments):
                self.refused(arguments, *words)
        # A link to what is not there yet is followed.
        os.symlink("target.json", self.path("new.json"))
        self.ok(*cell, "--json", "new.json", cwd=self.folder)
        self.assertTrue(os.path.islink(self.path("new.json")))
        self.assertTrue(os.path.isfile(self.path("target.json")))

    def test_a_full_device_is_no_success(self):
        for arguments in (self.CELL, ["--list"], ["--help"], ["scene", "layers"], ["--version"]):
            with open("/dev/full", "w") as full:
                result = subprocess.run([BENCH, *arguments], stdout=full, stderr=subprocess.PIPE,
                                        text=True, timeout=120)
            self.assertEqual(result.returncode, 1, arguments)
            self.assertIn("standard output", result.stderr)

    def test_one_output_that_fails_costs_no_other(self):
        aside = self.path("aside")
        os.mkdir(aside)
        result = run(*self.CELL, "--json", "/dev/full", "--csv", self.path("a.csv"), "--html",
                     self.path("a.html"), env={"TMPDIR": aside})
        self.assertEqual(result.returncode, 1)
        self.assertIn("none/vulkan/layers/32x32", result.stdout)
        for name in ("a.csv", "a.html"):
            self.assertGreater(os.path.getsize(self.path(name)), 100)
        file, = os.listdir(aside)
        self.assertIn(file, result.stderr)
        self.assertEqual(len(cells_of(os.path.join(aside, file))), 1)

if __name__ == "__main__":
    main()
