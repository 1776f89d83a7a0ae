#!/usr/bin/env python3
"""From nothing to a measured technique: the README's own two files, built and run as they stand; and
a loop over lights."""
import csv
import json
import os
import re
import shlex
import shutil
import subprocess

from program import BENCH, FAST, SOURCE, Case, cells_of, main

BUILD = os.path.dirname(BENCH)


def readme_block(name):
    """The code block that the README shows as the contents of a file."""
    with open(os.path.join(SOURCE, "README.md")) as file:
        text = file.read()
    found = re.search(r"`" + re.escape(name) + r"`:\n\n```\w+\n(.*?)```", text, re.DOTALL)
    assert found, f"the README shows no {name}"
    return found.group(1)


LOOP = """
#include "techniques/render/registry.h"

namespace sb {
namespace {

class MyLoop final : public LightTechnique {};

REGISTER_TECHNIQUE(LightTechnique, MyLoop,
                   TechniqueInfo{.name = "MyLoop",
                                 .folder = "my_loop",
                                 .title = "of a test",
                                 .paper = "here",
                                 .represents = {},
                                 .knobs = {{.name = "reach",
                                            .unit = "lights",
                                            .help = "of a test",
                                            .fallback = "4",
                                            .min = 1,
                                            .max = 64}},
                                 .error = "it leaves out no light"});

}  // namespace
}  // namespace sb
"""


class AddingATechnique(Case):
    def compile_line(self, source, output):
        """As techniques/methods/shadow/none.cpp is compiled, for another file."""
        with open(os.path.join(BUILD, "compile_commands.json")) as file:
            entry, = [e for e in json.load(file) if e["file"].endswith("/techniques/methods/shadow/none.cpp")]
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = output
        return [source if w.endswith("/techniques/methods/shadow/none.cpp") else w for w in words]

    def link_line(self, extra, output):
        commands = subprocess.run(["ninja", "-C", BUILD, "-t", "commands", "bench"],
                                  capture_output=True, text=True, check=True).stdout
        line = [c for c in commands.splitlines() if " -o bench " in c][-1]
        line = line.replace(" -o bench ", f" {shlex.quote(extra)} -o {shlex.quote(output)} ")
        return re.sub(r"^: && (.*?) && :$", r"\1", line)

    def test_the_readme_compiles_as_written_and_is_measured(self):
        source, shader = "techniques/methods/shadow/my_technique.cpp", "shaders/my_technique/visibility.glsl"
        with open(self.path("my_technique.cpp"), "w") as file:
            file.write(readme_block(source))
        shaders = self.path("shaders")
        shutil.copytree(os.path.join(SOURCE, "shaders"), shaders)
        os.mkdir(os.path.join(shaders, "my_technique"))
        with open(self.path(shader), "w") as file:
            file.write(readme_block(shader))
        self.build(["-c"], self.compile_line(self.path("my_technique.cpp"), self.path("t.o")))
        self.build(["link"], ["sh", "-c", self.link_line(self.path("t.o"), self.path("bench"))])

        results = self.path("r.json")
        run = subprocess.run(
            [self.path("bench"), "--shaders", shaders, "--technique", "none,MyTechnique",
             "--scene", "layers", *FAST, "--validate", "--json", results],
            capture_output=True, text=True, cwd=self.folder, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        cells = cells_of(results)
        self.assertEqual({(c["technique"], c["backend"]) for c in cells},
                         {(t, b) for t in ("none", "MyTechnique") for b in ("vulkan", "opengl")})
        for cell in cells:
            self.assertEqual(cell["status"], "ok", cell["reason"])
            self.assertEqual([w for w in cell["warnings"] if "validation" in w], [])
            # Half of each light is not what the truth says, in another way than all of it is.
            self.assertGreater(cell["visibility"]["rmse"], 0.05)
            if cell["technique"] == "MyTechnique":
                self.assertLess(cell["visibility"]["bias"], 0)

    def test_a_loop_over_lights_is_named_by_cells_and_changes_no_picture(self):
        with open(self.path("my_loop.cpp"), "w") as file:
            file.write(LOOP)
        shaders = self.path("shaders")
        shutil.copytree(os.path.join(SOURCE, "shaders"), shaders)
        shutil.copytree(os.path.join(shaders, "all_lights"), os.path.join(shaders, "my_loop"))
        self.build(["-c"], self.compile_line(self.path("my_loop.cpp"), self.path("l.o")))
        self.build(["link"], ["sh", "-c", self.link_line(self.path("l.o"), self.path("bench"))])

        def bench(*arguments):
            result = subprocess.run([self.path("bench"), *arguments], capture_output=True, text=True,
                                    cwd=self.folder, timeout=300)
            self.assertEqual(result.returncode, 0, result.stderr + result.stdout)
            return result.stdout

        self.assertIn("MyLoop: of a test", bench("--help"))
        cells = ["--scene", "layers", "--technique", "ShadowMap,ShadowMap@MyLoop", "--set", "reach=8"]
        names = [f"{t}/{b}/layers/{k}32x32" for t, k in
                 (("ShadowMap", ""), ("ShadowMap@MyLoop", "reach:8/")) for b in ("vulkan", "opengl")]
        self.assertEqual(bench("--list", *cells, "--size", "32x32").split(), names)
        bench("--shaders", shaders, *cells, *FAST, "--validate", "--json", "r.json", "--csv", "r.csv")
        found = {e["run_name"]: e for e in cells_of(self.path("r.json"))}
        self.assertEqual(list(found), names)
        for name, cell in found.items():
            self.assertEqual(cell["status"], "ok", cell["reason"])
            self.assertEqual([w for w in cell["warnings"] if "validation" in w], [])
            self.assertEqual(cell["lights"], "MyLoop" if "@" in name else "AllLights")
            self.assertEqual(cell["knobs_changed"], ["reach"] if "@" in name else [])
            self.assertIn(f"--technique {name.split('/')[0]} ", cell["command"])
        for backend in (0, 1):
            self.assertEqual(found[names[backend]]["picture"], found[names[2 + backend]]["picture"])
        with open(self.path("r.csv")) as file:
            self.assertEqual([row["lights"] for row in csv.DictReader(file)],
                             ["AllLights", "AllLights", "MyLoop", "MyLoop"])
        bench("report", "r.json")
        with open(self.path("r.html")) as file:
            self.assertIn(">ShadowMap@MyLoop</span>", file.read())

    def build(self, what, command):
        result = subprocess.run(command, capture_output=True, text=True, cwd=BUILD)
        self.assertEqual(result.returncode, 0, f"{what}: {result.stderr}")


if __name__ == "__main__":
    main()
