#!/usr/bin/env python3
"""Results survive interrupts, kills, full disks and mistakes; runs go on where they ended."""
import glob
import json
import os
import shutil
import signal
import subprocess
import time

from program import BENCH, FAST, SOURCE, Case, run, main

# Three groups, six cells, and blocks enough to be interrupted among.
RUN = ["--technique", "none,ShadowMap", "--backend", "vulkan", "--scene", "layers", "--scene",
       "panes", "--scene", "layers:alpha=0.5", "--size", "16x16",
       "--benchmark_repetitions=12", "--seeds", "2"]


def cells_of(file):
    with open(file) as text:
        return [e for e in json.load(text)["benchmarks"] if e["run_type"] == "aggregate"]


def names_of(file):
    return [e["run_name"] for e in cells_of(file)]


class Signals(Case):
    def start(self, *arguments):
        process = subprocess.Popen(
            [BENCH, *arguments], stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            cwd=self.folder, env={**os.environ, "XDG_CACHE_HOME": self.path("cache"),
                                  "TMPDIR": self.tmp()})
        self.addCleanup(process.kill)
        return process

    def tmp(self):
        os.makedirs(self.path("tmp"), exist_ok=True)
        return self.path("tmp")

    @staticmethod
    def wait_for(process, word):
        for line in process.stderr:
            if word in line:
                return
        raise AssertionError(f"no '{word}' before the end")

    def go_on(self, *arguments):
        return self.ok(*arguments, cwd=self.folder,
                       env={"XDG_CACHE_HOME": self.path("cache"), "TMPDIR": self.tmp()})

    def test_every_signal_keeps_what_is_finished_and_the_run_goes_on(self):
        self.go_on(*RUN, "--quiet", "--json", "whole.json")
        whole = names_of(self.path("whole.json"))
        self.assertEqual(len(whole), 6)
        self.assertFalse(os.path.exists(self.path("whole.journal")))
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(number.name):
                name = number.name.lower()
                process = self.start(*RUN, "--json", f"{name}.json")
                self.wait_for(process, "panes: measure")
                sent = time.monotonic()
                process.send_signal(number)
                if number != signal.SIGKILL:
                    self.wait_for(process, "stopping after the block under way")
                    self.assertLess(time.monotonic() - sent, 1)
                process.communicate(timeout=60)
                if number == signal.SIGKILL:
                    self.assertEqual(process.returncode, -9)
                    self.assertFalse(os.path.exists(self.path(f"{name}.json")))
                else:
                    self.assertEqual(process.returncode, 128 + number)
                    with open(self.path(f"{name}.json")) as file:
                        context = json.load(file)["context"]
                    self.assertIs(context["interrupted"], True)
                    self.assertEqual(context["cells_planned"], 6)
                    self.assertEqual(context["cells_done"], 2)
                    self.assertEqual(names_of(self.path(f"{name}.json")), whole[:2])
                lines = self.journal(f"{name}.journal")
                blocks = [b["block"]["cell"] for b in lines if "block" in b]
                self.assertGreaterEqual(len(blocks), 24)
                result = self.go_on("--resume", f"{name}.json")
                self.assertIn("going on: 2 of 6 are finished", result.stderr)
                self.assertEqual(names_of(self.path(f"{name}.json")), whole)
                with open(self.path(f"{name}.json")) as file:
                    self.assertIs(json.load(file)["context"]["interrupted"], False)
                for cell in cells_of(self.path(f"{name}.json")):
                    self.assertEqual(cell["status"], "ok", cell["reason"])
                    self.assertEqual(cell["repetitions"], 12)
                    if cell["technique"] == "ShadowMap" and not cell["contamination"]:
                        self.assertEqual([r["kind"] for r in cell["ratios"]], ["baseline"])
                        self.assertEqual(cell["ratios"][0]["n"], 12)
                    for picture in cell["pictures"].values():
                        self.assertTrue(os.path.exists(self.path(f"{name}.pictures/{picture}.png")))
                self.assertFalse(os.path.exists(self.path(f"{name}.journal")))

    def journal(self, name):
        with open(self.path(name)) as file:
            return [json.loads(line) for line in file if line.endswith("\n")]

    def test_an_interrupt_before_anything_is_finished_leaves_earlier_results_alone(self):
        outputs = ["--json", "a.json", "--csv", "a.csv", "--html", "a.html"]
        self.go_on("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST, *outputs)
        before = {}
        for name in ("a.json", "a.csv", "a.html"):
            with open(self.path(name)) as file:
                before[name] = file.read()
        process = self.start(*RUN, *outputs)
        self.wait_for(process, "layers: measure")
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted; 0 of 6", errors)
        for name, text in before.items():
            with open(self.path(name)) as file:
                self.assertEqual(file.read(), text, name)
        # A new run does not write over the journal of the one that ended early.
        self.go_on("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST, *outputs)
        self.assertTrue(os.path.exists(self.path("a.journal.old")))

    def test_an_empty_journal_is_of_a_run_killed_before_its_first_line(self):
        open(self.path("f.journal"), "w").close()
        self.go_on("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST,
                   "--json", "f.json")
        self.assertFalse(os.path.exists(self.path("f.journal")))

    def test_what_lies_in_the_journals_place_and_is_none_stays(self):
        with open(self.path("d.journal"), "w") as file:
            file.write("diary")
        os.mkdir(self.path("e.journal"))
        for name in ("d", "e"):
            result = run("--technique", "none", "--backend", "vulkan", "--scene", "layers", *FAST, "--json", self.path(name + ".json"), cwd=self.folder)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("no journal of a run", result.stderr)
        with open(self.path("d.journal")) as file:
            self.assertEqual(file.read(), "diary")
        self.assertEqual(sorted(os.listdir(self.folder)), ["d.journal", "e.journal"])

    def test_without_json_the_journal_is_named_and_two_interrupts_leave_no_temporary_files(self):
        process = self.start(*RUN, "--html", "a.html")
        first = process.stderr.readline()
        journal = first.split("journal ")[1].strip()
        self.assertTrue(os.path.exists(journal), first)
        self.wait_for(process, "panes: measure")
        process.send_signal(signal.SIGINT)
        self.wait_for(process, "stopping")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(os.listdir(self.tmp()), [])
        self.assertEqual(glob.glob(self.path("*.tmp*")), [])
        self.go_on("--resume", journal)
        self.assertTrue(os.path.exists(self.path("a.html")))
        self.assertFalse(os.path.exists(journal))
        self.assertEqual(os.listdir(os.path.dirname(os.path.dirname(journal))), [])

    def test_clearing_the_cache_takes_runs_that_ended_early_and_leaves_those_under_way(self):
        cache = {"XDG_CACHE_HOME": self.path("cache")}
        runs = self.path("cache/shadowbench/runs")
        killed = self.start(*RUN, "--html", "a.html")
        self.wait_for(killed, "layers: measure")
        self.assertIn("1 runs under way", self.ok("cache", env=cache).stdout)
        killed.kill()
        killed.communicate(timeout=60)
        with open(os.path.join(runs, "notes.txt"), "w") as file:
            file.write("somebody's")
        self.assertIn("1 runs that ended early (bench --resume", self.ok("cache", env=cache).stdout)
        alive = self.start(*RUN, "--html", "b.html")
        self.wait_for(alive, "layers: measure")
        text = self.ok("cache", "--clear", env=cache).stdout
        self.assertIn("1 runs that ended early, removed", text)
        self.assertIn("1 runs under way", text)
        left = sorted(os.listdir(runs))
        self.assertEqual((len(left), left[-1]), (2, "notes.txt"))
        # Nor may anybody else go on with it, or write over it.
        journal = os.path.join(runs, left[0], "run.journal")
        before = os.path.getsize(journal)
        result = run("--resume", journal, cwd=self.folder, env=cache)
        self.assertEqual(result.returncode, 2)
        self.assertIn("another run writes", result.stderr)
        self.assertGreaterEqual(os.path.getsize(journal), before)
        alive.kill()
        alive.communicate(timeout=60)
        self.ok("cache", "--clear", env=cache)
        self.assertEqual(os.listdir(runs), ["notes.txt"])

    def test_shaders_that_changed_in_between_are_another_run(self):
        shaders = self.path("shaders")
        shutil.copytree(os.path.join(SOURCE, "shaders"), shaders)
        arguments = [*RUN, "--shaders", shaders, "--json", "s.json"]
        process = self.start(*arguments)
        self.wait_for(process, "layers: measure")
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=60)
        with open(os.path.join(shaders, "none", "visibility.glsl"), "a") as file:
            file.write("// another\n")
        result = run(*arguments, "--resume", cwd=self.folder,
                     env={"XDG_CACHE_HOME": self.path("cache")})
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("setting shaders", result.stderr)

    def test_a_run_of_other_settings_is_refused_with_what_differs(self):
        process = self.start(*RUN, "--json", "a.json")
        self.wait_for(process, "panes: measure")
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=60)
        for change, words in ((["--seeds", "3"], "setting seeds: 2 there, 3 here"),
                              (["--benchmark_repetitions=13"], "repetitions: 12 there, 13 here"),
                              (["--scene", "window"], "window"),
                              (["--no-truth"], "setting truth")):
            changed = [a for a in RUN if not (change[0] == "--seeds" and a in ("--seeds", "2"))]
            result = run(*changed, *change, "--json", "a.json", "--resume", cwd=self.folder,
                         env={"XDG_CACHE_HOME": self.path("cache")})
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("a.journal is of another run", result.stderr)
            self.assertIn(words, result.stderr)
        result = run("--resume", self.path("a.json"), cwd="/")
        self.assertEqual(result.returncode, 2)
        self.assertIn("was started in", result.stderr)
        # A line that a kill cut in two is done again.
        with open(self.path("a.journal"), "a") as file:
            file.write('{"cell":[{"name":"half')
        result = self.go_on(*RUN, "--json", "a.json", "--resume")
        self.assertIn("cut off", result.stderr)
        self.assertEqual(len(names_of(self.path("a.json"))), 6)
        result = run("--resume", "a.json", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("that run is complete", result.stderr)

    def test_hard_cases_go_on_too(self):
        suite = self.path("s.toml")
        with open(suite, "w") as file:
            file.write('[[stability]]\ncases = ["G1", "G2", "G3"]\ntechniques = ["ShadowMap"]\n')
        arguments = ["--suite", suite, "--backend", "vulkan", "--json", "a.json"]
        process = self.start(*arguments)
        self.wait_for(process, "G3/")
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertEqual(len([1 for e in self.journal("a.journal") if "hard_case" in e]), 2)
        self.assertIn("going on: 2 of 3", self.go_on("--resume", "a.json").stderr)
        with open(self.path("a.json")) as file:
            self.assertEqual([c["case"] for c in json.load(file)["stability"]], ["G1", "G2", "G3"])


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


class Inputs(Case):
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
