#!/usr/bin/env python3
"""Results survive interrupts and kills; runs go on where they ended."""
import glob
import json
import os
import shutil
import signal
import subprocess
import time

from program import BENCH, FAST, SOURCE, Case, cells_of, main, names_of, run

# Three groups, six cells, and blocks enough to be interrupted among.
RUN = ["--technique", "none,ShadowMap", "--backend", "vulkan", "--scene", "layers", "--scene",
       "panes", "--scene", "layers:alpha=0.5", "--size", "16x16",
       "--benchmark_repetitions=12", "--seeds", "2"]


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
                    self.assertLess(time.monotonic() - sent, 5)
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

if __name__ == "__main__":
    main()
