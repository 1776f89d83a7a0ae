#!/usr/bin/env python3
"""What the program says: names, help, version, drivers that do not load."""
import json
import os
import signal
import subprocess

from program import BENCH, FAST, SOURCE, Case, cells_of, main, run


class Words(Case):
    def test_names_cannot_act_on_a_terminal_a_table_or_a_shell(self):
        scene = os.fsencode(self.path("=a\x1b[31m")) + b"\xff';x.glb"
        self.ok("scene", "layers", "--export", self.path("plain.glb"))
        os.rename(self.path("plain.glb"), scene)
        results, table = self.path("r.json"), self.path("r.csv")
        arguments = ["--technique", "none", "--backend", "vulkan", *FAST]
        result = subprocess.run([BENCH, *arguments, "--scene", scene, "--json", results, "--csv",
                                 table], capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 0, result.stderr)
        for text in (result.stdout, result.stderr, open(table, "rb").read()):
            self.assertNotIn(b"\x1b", text)
            self.assertNotIn(b"\xff", text)
        cell, = cells_of(results)
        self.assertIn("\\x1b[31m\\xff", cell["run_name"])
        # The command that reproduces the cell does.
        words = cell["command"].replace("./bench", f'"{BENCH}"', 1)
        again = subprocess.run(["bash", "-c", words + " --benchmark_repetitions=1 --no-truth"],
                               capture_output=True, timeout=120)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn(b"\\x1b[31m\\xff", again.stdout)
        # Errors are one short line.
        result = subprocess.run([BENCH, "--scene", b"\x1b[2J\n\xff" + b"x" * 5000 + b".glb"],
                                capture_output=True, timeout=120)
        self.assertEqual(result.returncode, 2)
        line, rest = result.stderr.split(b"\n", 1)
        self.assertEqual(rest, b"")
        self.assertLessEqual(len(line), 300)
        self.assertNotIn(b"\x1b", line)

    def test_every_name_that_is_listed_finds_itself(self):
        for arguments in ([], ["--suite", "stability"], ["--size", "64x64"],
                          ["--technique", "CSSM2+DepthPeeling", "--set-material", "*:alpha=0.5",
                           "--scene", "layers", "--set", "kernel=1,3"]):
            names = self.ok("--list", *arguments).stdout.split("\n")[:-1]
            for name in (names[0], names[len(names) // 2], names[-1]):
                with self.subTest(name):
                    self.assertEqual(self.ok("--list", *arguments, "--filter", name).stdout,
                                     name + "\n")

    def test_help_and_code_agree_on_defaults(self):
        text = self.ok("--help").stdout
        plan = self.run_line("--technique", "none", "--backend", "vulkan", "--scene", "layers")
        for option, words in (("--size", "size 512x512"), ("--budget", "budget 3 s"),
                              ("--precision", "precision 5 %"), ("--seeds", "64 seeds")):
            default = words.replace("size ", "").replace("budget ", "").replace("precision ", "")
            self.assertRegex(text, rf"{option}[^\[]*\[{default.split()[0]}")
            self.assertIn(words, plan)
        with open(os.path.join(SOURCE, "suites/quick.toml")) as file:
            quick = file.read()
        plan = self.run_line("--filter", "none/vulkan/layers")
        for key, words in (("seeds = 8", "8 seeds"), ("budget = 0.7", "budget 0.7 s"),
                           ('size = "256x256"', "size 256x256")):
            self.assertIn(key, quick)
            self.assertIn(words, plan)
        self.assertIn("of the suite quick on vulkan", plan)

    def test_help_says_what_may_be_given(self):
        text = self.ok("--help").stdout
        self.assertNotIn("{false}", text)
        self.assertIn("lights=1..1000  [10]  how many lamps", text)
        self.assertIn("orientation=aligned|random  [aligned]", text)
        self.assertIn("sun=0..10 degrees  [0]", text)

    def run_line(self, *arguments):
        """The first line of a run that is given up at once."""
        process = subprocess.Popen([BENCH, *arguments], stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, text=True)
        line = process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
        return line

    def test_the_version_says_what_was_built(self):
        text = self.ok("--version").stdout
        for word in ("ShadowBench ", "commit ", "build ", "compiler ", "OS ", "CPU "):
            self.assertRegex(text, rf"(?m)^{word}\S")
        results = self.path("r.json")
        self.ok("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST, "--json",
                results)
        with open(results) as file:
            context = json.load(file)["context"]
        for key in ("commit", "compiler", "os", "cpu_model"):
            self.assertIn(context[key], text)
        self.assertIn("--scene layers", context["command_line"])

    def test_a_driver_that_does_not_load_is_named(self):
        manifest = self.path("nv.json")
        with open(manifest, "w") as file:
            json.dump({"file_format_version": "1.0.0",
                       "ICD": {"library_path": "libnot_there.so.0", "api_version": "1.3.0"}}, file)
        for variable in ("VK_ICD_FILENAMES", "VK_DRIVER_FILES"):
            env = {"VK_ICD_FILENAMES": manifest, variable: manifest}
            result = run("render", "--scene", "layers", "--backend", "vulkan", env=env)
            self.assertEqual(result.returncode, 1)
            for word in ("a driver is installed", "libnot_there.so.0", "does not load"):
                self.assertIn(word, result.stderr)
            self.assertIn("libnot_there.so.0", self.ok("doctor", env=env).stdout)
        result = run("render", "--backend", "vulkan", env={"VK_ICD_FILENAMES": "/none.json",
                                                           "VK_DRIVER_FILES": "/none.json"})
        self.assertIn("names /none.json, which is not there", result.stderr)


if __name__ == "__main__":
    main()
