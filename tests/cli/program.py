"""What the tests of the program share: running it, a folder of its own for each test.

Each test file is run as: FILE BENCH SOURCE_DIR [unittest arguments].
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

BENCH, SOURCE = (os.path.abspath(path) for path in sys.argv[1:3])
COMPARE = "/usr/share/benchmark/compare.py"
# Cells that cost little; six repetitions are the fewest with an interval.
FAST = ["--size", "32x32", "--benchmark_repetitions=2", "--seeds", "2", "--quiet"]
NO_VULKAN = {"VK_ICD_FILENAMES": "/nonexistent", "VK_DRIVER_FILES": "/nonexistent"}
NO_EGL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}


def run(*arguments, env=None, cwd=None, timeout=120):
    return subprocess.run([BENCH, *arguments], capture_output=True, text=True, timeout=timeout,
                          env={**os.environ, **(env or {})}, cwd=cwd)


def cells_of(file):
    with open(file) as text:
        return [e for e in json.load(text)["benchmarks"] if e["run_type"] == "aggregate"]


def names_of(file):
    return [e["run_name"] for e in cells_of(file)]


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


def main():
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[3:]])
