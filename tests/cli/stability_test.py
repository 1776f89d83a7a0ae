#!/usr/bin/env python3
"""Hard cases of a scene of one's own: the generic properties, their verdicts, what is refused."""
import json
import os
import shutil

from program import SOURCE, Case, run, main

FILES = os.path.join(SOURCE, "tests", "scenes", "files")
GENERIC = [f"G{i}" for i in range(1, 12)] + ["G3 lights"]


class OwnScene(Case):
    def asked(self, *arguments):
        self.ok("--suite", "stability", "--size", "48x36", "--quiet", "--json", self.path("r.json"),
                *arguments, timeout=400)
        with open(self.path("r.json")) as file:
            return json.load(file)["stability"]

    def test_every_property_has_a_verdict(self):
        file = self.path("panes.gltf")
        shutil.copy(os.path.join(FILES, "coincident_red.gltf"), file)
        records = self.asked("--scene", file, "--technique", "CSSM2", "--html", self.path("r.html"))
        self.assertEqual(sorted((r["case"], r["backend"]) for r in records),
                         sorted((id, backend) for id in GENERIC for backend in ("vulkan", "opengl")))
        for r in records:
            self.assertEqual((r["scene"], r["width"], r["height"]), (file, 48, 36))
            self.assertEqual(r["name"], f"{r['case']}/CSSM2/{r['backend']}/{file}/48x36")
            # Whatever is not asked says why; whatever is asked holds.
            skipped = r["case"] in ("G3 lights", "G6")
            self.assertEqual(r["verdict"], "skipped" if skipped else "PASS", r)
            self.assertEqual(bool(r["why"]), skipped, r)
            self.assertTrue(skipped or r["curve"], r)
        with open(self.path("r.html")) as page:
            self.assertIn(f"Asked of {file}, 48×36.", page.read())

    def test_what_a_scene_lacks_is_said(self):
        records = self.asked("--scene", os.path.join(FILES, "bowl32.gltf"), "--technique",
                             "ShadowMap", "--backend", "vulkan", "--filter", "^G(3|10|11)")
        why = {r["case"]: (r["verdict"], r["why"]) for r in records}
        self.assertEqual(why["G10"], ("skipped", "no caster of the scene is translucent"))
        self.assertEqual(why["G3 lights"], ("skipped", "the scene has fewer than two lights"))
        self.assertEqual(why["G11"], ("PASS", ""))

    def test_changes_of_the_scene_are_named(self):
        names = self.ok("--suite", "stability", "--scene", "layers", "--scene", "panes", "--technique", "CSSM2", "--backend", "vulkan",
                        "--sun", "direction=0,-1,0", "--filter", "^G8", "--list").stdout.split("\n")
        self.assertEqual(names[:2], ["G8/CSSM2/vulkan/layers?sun:direction=0,-1,0/96x64",
                                     "G8/CSSM2/vulkan/panes?sun:direction=0,-1,0/96x64"])

    def test_what_is_refused(self):
        for arguments, text in ((("accuracy", "--scene", "layers"), "--suite"),
                                (("accuracy", "--technique", "CSSM2"), "--suite"),
                                (("stability", "--set", "kernel=3"), "--suite"),
                                (("stability", "--sun", "direction=0,-1,0"), "--scene"),
                                (("stability", "--scene", "layer"), "unknown scene"),
                                (("stability", "--scene", self.path("no.gltf")), "no.gltf"),
                                (("stability", "--scene", "layers", "--max-memory", "1"),
                                 "--max-memory")):
            result = run("--suite", *arguments, "--json", self.path("none.json"))
            self.assertEqual(result.returncode, 2, (arguments, result.stderr))
            self.assertIn(text, result.stderr)
            self.assertFalse(os.path.exists(self.path("none.json")))


if __name__ == "__main__":
    main()
