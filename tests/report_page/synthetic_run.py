"""Results made by hand for the tests of the report's page: two scenes, three backends, a ray-traced
row without error, a stochastic technique with noise and certificate, a failed, a skipped and a
contaminated cell, hard cases, figures, hostile texts, and pictures as PNG files written with zlib alone.
"""
import json
import math
import os
import random
import struct
import zlib

HOSTILE = "window<script>alert(1)</script>\"'&</script>\u2028"
SCENES = ("layers", HOSTILE)
SIZE = 128


def png(width, height, rgb):
    """8-bit RGB, row 0 at the top."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    rows = b"".join(b"\0" + rgb[y * width * 3:(y + 1) * width * 3] for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" +
            chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))


class Pictures:
    """Writes each picture under a hash of its content."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def add(self, shade):
        rgb = bytearray()
        for y in range(SIZE):
            for x in range(SIZE):
                rgb += bytes(max(0, min(255, int(c))) for c in shade(x / SIZE, y / SIZE))
        content = png(SIZE, SIZE, bytes(rgb))
        name = f"{zlib.crc32(content):08x}{zlib.adler32(content):08x}"
        with open(os.path.join(self.folder, name + ".png"), "wb") as file:
            file.write(content)
        return name

    def of_cell(self, error, noise, tint):
        """Image, error map and blame map of a disc's shadow that is `error` too wide."""
        rng = random.Random(int(error * 1e6) + tint)

        def coverage(x, y, radius):
            return max(0, min(1, (math.hypot(x - 0.5, y - 0.55) - radius) * 20))

        def image(x, y):
            light = coverage(x, y, 0.28 + error) + rng.uniform(-1, 1) * noise
            return (60 + 170 * light, 60 + (150 - tint) * light, 70 + 120 * light)

        def wrong(x, y):
            e = abs(coverage(x, y, 0.28 + error) - coverage(x, y, 0.28)) + noise * rng.random()
            t = max(0, math.log(e + 1e-6) / math.log(1024) + 1)
            return (255 * t, 200 * t * t, 120 * math.sin(3 * t))

        def blame(x, y):
            e = abs(coverage(x, y, 0.28 + error) - coverage(x, y, 0.28))
            return (230 * e, 160 * e, 30) if noise < 0.01 else (90 * e, 120, 220 * noise * 5)
        return {"image": self.add(image), "error": self.add(wrong), "blame": self.add(blame)}


def stats(rmse):
    return {"rmse": rmse, "bias": -rmse / 3, "max": min(1, rmse * 12), "p999": min(1, rmse * 8),
            "over_1_255": min(1, rmse * 3), "rmse_rgb": [rmse] * 3, "bias_rgb": [-rmse / 3] * 3,
            "pixels": SIZE * SIZE if rmse else 0}


def distribution(median):
    return {"median": median, "q1": median * 0.97, "q3": median * 1.05, "cv": 0.03, "n": 40}


def iterations(name, ms):
    return [{"name": name, "run_name": name, "run_type": "iteration", "repetitions": 10,
             "threads": 1, "repetition_index": i, "iterations": 4, "real_time": ms * 0.5,
             "cpu_time": ms * (1 + 0.01 * math.sin(i * 7.0)), "time_unit": "ms"} for i in range(10)]


def identity(technique, backend, scene, variant=""):
    name = "/".join(filter(None, [technique, backend, scene, variant, f"{SIZE}x{SIZE}"]))
    knobs = dict(part.split(":") for part in variant.split("/") if part)
    return name, {
        "run_name": name, "technique": technique, "transparency": "Sorted", "lights": "AllLights",
        "role": {"none": "baseline", "RayTraced": "tracer"}.get(technique, "technique"),
        "backend": backend,
        "device": "llvmpipe (LLVM 15, 256 bits)" if backend != "cpu" else "ray tracer",
        "device_type": "software", "driver": "Mesa 22.3.6", "scene": scene,
        "scene_hash": "0123456789abcdef", "width": SIZE, "height": SIZE,
        "knobs": {"kernel": "3", "size": "1024", **knobs}, "knobs_changed": list(knobs), "seed": 0,
        "version": "0.1.0",
        "effects_planned": ["opaque casters"], "effects_skipped": [], "effects_unrepresented": [],
        "command": f"./bench --technique {technique} --backend {backend} --scene '{scene}'" +
                   "".join(f" --set {k}={v}" for k, v in knobs.items())}


def cell(technique, backend, scene, variant, ms, rmse, pictures, noisy=False):
    name, entry = identity(technique, backend, scene, variant)
    shadow = 0 if technique in ("none", "RayTraced") else ms * 0.4
    entry.update({
        "name": name + "_median", "run_type": "aggregate", "aggregate_name": "median",
        "iterations": 40, "real_time": ms * 0.5, "cpu_time": ms, "time_source": "software",
        "frame_ms": distribution(ms * 0.5), "wall_ms": distribution(ms * 0.5),
        "cpu_ms": distribution(ms), "record_ms": distribution(0.2), "device_ms": None,
        "device_ms_why": "plain frames carry no stamps", "submit_ms": 0.1, "compile_ms": 30.0,
        "stopped_by": "budget" if noisy else "precision", "precision": 0.03,
        "passes": [{"label": label, "count": 1, "ms": ms * share, "share": share,
                    "draws": 2, "triangles": 900,
                    "fragments": None, "fragments_why": "not counted"}
                   for label, share in (("shadow map", 0.3), ("blur", 0.1), ("camera", 0.5))]
        if shadow else [{"label": "camera", "count": 1, "ms": ms * 0.9, "share": 0.9, "draws": 1,
                         "triangles": 900, "fragments": 4096}],
        "shadow_ms": shadow, "scene_ms": ms * 0.5, "combined_ms": shadow + ms * 0.5,
        "stamped_frame_ms": ms, "ratios": [], "pass_count": 3, "draw_count": 5,
        "triangle_count": 1800, "bytes": int(3e6 + shadow * 2e6),
        "bytes_by_label": {"camera colour": int(3e6), "shadow map": int(shadow * 2e6)},
        "nonfinite": 0, "stable": True, "cross_backend_max_255": 1, "cross_backend_over_1_255": 0,
        "picture": pictures.get("image", ""), "visibility_layers": [],
        "visibility_regions": [{"region": "pale", "share": 1.0, "rmse": rmse / 2, "bias": 0,
                                "noise": rmse / 3 if noisy else None}],
        "visibility": {**stats(rmse), "interior": stats(rmse / 4)},
        "image": {**stats(0.4 * rmse ** 0.8), "relmse": rmse * 0.5, "flip": rmse * 0.6,
                  "interior": {**stats(rmse * 0.1), "relmse": rmse * 0.1, "flip": rmse * 0.1}},
        "noise": None, "noise_why": "not stochastic", "certificate": None,
        "certificate_why": "not stochastic",
        "blame": {"mse": rmse * rmse, "shares": {"noise": 0.5 if noisy else 0, "resolution":
                  0.3 if noisy else 0.7, "inner-layer": 0, "self-shadowing": 0.05 if noisy else 0.1,
                  "leaking": 0.15 if noisy else 0.2} if rmse else {}},
        "truth_stderr": 0.0, "pictures": pictures, "status": "ok", "reason": "", "warnings": [],
        "contamination": []})
    if technique != "none":
        entry["ratios"].append({"kind": "baseline", "against": f"none/{backend}/{scene}/x",
                                "of": "cpu_ms", "ratio": ms / 4, "low": ms / 4.2, "high": ms / 3.8,
                                "n": 10})
    if backend in ("vulkan", "opengl"):
        other = name.replace(f"/{backend}/", "/opengl/" if backend == "vulkan" else "/vulkan/")
        value = 1.12 if backend == "vulkan" else 1 / 1.12
        if "kernel" in variant:
            value = 1 + (value - 1) / 20
        entry["ratios"].append({"kind": "backend", "against": other, "of": "cpu_ms", "ratio": value,
                                "low": value * 0.96, "high": value * 1.03, "n": 10})
    if noisy:
        entry["noise"] = {"seeds": 64, "noise": rmse * 0.7, "bias_rmse": rmse * 0.1,
                          "bias": 1e-4, "bias_low": -1e-4, "bias_high": 3e-4, "rmse_low": rmse * 0.85, "rmse_high": rmse * 1.25}
        entry["certificate"] = {
            "unbiased": backend == "vulkan", "test": "binomial", "family_wise_error": 1e-6,
            "detectable": 0.01, "informative": 12,
            "regions": [{"light": 0, "layer": 0, "channel": i % 3, "x": 10 * i, "y": 20, "pixels": 300,
                         "q": 0.5, "trials": 19200, "passes": 9600 + 13 * i,
                         "mean": (9600 + 13 * i) / 19200, "error": 0.0036,
                         "p_value": 1e-9 if backend != "vulkan" and i == 11 else 0.9 / (i + 1)}
                        for i in range(12)]}
    return iterations(name, ms) + [entry]


def without_result(technique, backend, scene, status, reason):
    name, entry = identity(technique, backend, scene)
    entry.update({"name": f"{name}_{status}", "run_type": "aggregate", "aggregate_name": status,
                  "error_occurred": True, "error_message": f"{status}: {reason}", "status": status,
                  "reason": reason, "warnings": [], "contamination": []})
    return [entry]


def cells_of(scene, pictures, entries):
    """RayTraced, and on both APIs `none`, three sizes of ShadowMap, four kernels of CSSM2, one of
    them slower and worse than another."""
    factor = 1 if scene == "layers" else 1.7
    truth = pictures.add(lambda x, y: (200 - 90 * y, 190 - 80 * y, 170 if math.hypot(
        x - 0.5, y - 0.55) > 0.28 else 60))
    image = {"truth": truth, "image": truth}
    entries += cell("RayTraced", "cpu", scene, "", 900 * factor, 0.0, image)
    kinds = [("none", "", 4, 0.31, False)]
    kinds += [("ShadowMap", v, 7 * m, 0.11 / m, False)
              for v, m in (("size:512", 1), ("", 1.5), ("size:2048", 2.6))]
    kinds += [("CSSM2", v, 16 * m, 0.05 / m ** 1.2, True)
              for v, m in (("", 1), ("kernel:5", 1.9), ("kernel:9", 5))]
    kinds += [("CSSM2", "kernel:1", 60, 0.047, True)]
    for technique, variant, ms, rmse, noisy in kinds:
        shared = pictures.of_cell(rmse, rmse * 2 if noisy else 0, 10 if noisy else 0)
        for backend, speed in (("vulkan", 1.12), ("opengl", 1)):
            entries += cell(technique, backend, scene, variant, ms * speed * factor, rmse,
                            {**shared, "truth": truth}, noisy)


def hard_case(id, technique, backend, verdict, curve, parameter="", logarithmic=False):
    """`curve`: x, found, allowed; found None is no number."""
    broken = [x for x, found, allowed in curve if found is None or found > allowed]
    return {"name": f"{id}/{technique}/{backend}", "case": id, "title": f"Title of {id} <b>",
            "property": "what must hold (1)", "reason": "<b>half a step</b> of 8 bits",
            "technique": technique, "backend": backend, "parameter": parameter,
            "logarithmic": logarithmic, "verdict": verdict,
            "why": "" if verdict == "PASS" else f"why of {id}",
            "breaks_at": broken[0] if broken else None,
            "curve": [{"x": x, "value": found, "tolerance": allowed} for x, found, allowed in curve]}


def hard_cases():
    """Three cases, two of them with a curve: one over magnitudes with a value that is no number."""
    out = []
    for backend in ("vulkan", "opengl"):
        out += [hard_case("G1", "ShadowMap", backend, "PASS", [(0, 0, 0)]),
                hard_case("G1", "CSSM2", backend, "skipped", []),
                hard_case("G2", "ShadowMap", backend, "PASS",
                          [(10.0 ** e, 1e-7 * 10 ** (e / 2), 2e-3) for e in range(7)], "offset, m", True),
                hard_case("G2", "CSSM2", backend, "FAIL" if backend == "opengl" else "PASS",
                          [(10.0 ** e, None if backend == "opengl" and e == 6 else 1e-6 * 10 ** (e / 2),
                            2e-3) for e in range(7)], "offset, m", True),
                hard_case("T4", "CSSM2", backend, "EXPECTED",
                          [(a / 10, a / 20, 0.21) for a in range(11)], "alpha")]
    return out


def figure(id, kind, cells, statements, x=""):
    return {"id": id, "title": f"Title of {id} <b>", "kind": kind, "document": "It says <b>so</b>.",
            "x": x, "x_fallback": 0, "cells": cells,
            "cell_backends": [name.split("/")[1] for name in cells], "missing": [],
            "stated": [{"cells": "^CSSM2/", "passes": "three, <b>stated</b>", "attachments": "two",
                        "bytes": ""}],
            "statements": [{"text": f"<b>Claim</b> on {left}", "of": of,
                            "left": {"cells": left, "measure": measure, "at": None},
                            "right": {"cells": right, "measure": measure, "at": None},
                            "relation": "less", "factor": 1, "otherwise": "<b>otherwise</b>"}
                           for of, measure, left, right in statements]}


def figures(names):
    """One of each kind; the knob kernel is the first one's x."""
    layers = [n for n in names if "/layers/" in n and "osmesa" not in n]
    cssm2 = [n for n in layers if n.startswith("CSSM2/")]
    return [figure("5.3", "scaling", cssm2 + ["CSSM2/vulkan/layers/kernel:63/128x128"],
                   [("slope", "time", "^CSSM2/", "^CSSM2/.*kernel:9"),
                    ("value", "visibility", "kernel:9", "^CSSM2/[^/]*/layers/128"),
                    ("value", "visibility", "^CSSM2/[^/]*/layers/128", "kernel:9")], "kernel"),
            figure("5.4", "pictures", layers, []), figure("5.5", "layers", cssm2, []),
            figure("5.6", "regions", cssm2, []), figure("5.7", "resources", layers, [])]


def write(folder):
    """Writes results.json and its pictures; gives the path."""
    path = os.path.join(folder, "results.json")
    pictures = Pictures(os.path.join(folder, "results.pictures"))
    entries = []
    for scene in SCENES:
        cells_of(scene, pictures, entries)
    entries += without_result("CSSM2", "opengl-osmesa", "layers", "skipped",
                              "the device lacks geometry-shader & <b>more</b>")
    entries += without_result("ShadowMap", "opengl-osmesa", "layers", "failed",
                              "3 values of the picture are not finite")
    disturbed = cell("ShadowMap", "opengl-osmesa", "layers", "size:512", 30, 0.11,
                     {"image": "00000000000000ff", "error": "../../../etc/passwd"})
    disturbed[-1]["contamination"] = ["other programs used 80 % of the CPUs"]
    disturbed[-1]["ratios"] = []
    entries += disturbed
    context = {"date": "2024-05-04T12:00:00+0200", "host_name": "host \"<&>\"", "executable": "bench",
               "num_cpus": 2, "mhz_per_cpu": 2500, "cpu_scaling_enabled": False, "caches": [],
               "load_avg": [0.5, 0.4, 0.3], "library_build_type": "release",
               "shadowbench_version": "0.1.0", "warnings": ["scene x: a texture is missing"]}
    with open(path, "w") as file:
        names = [e["run_name"] for e in entries if e["run_type"] == "aggregate"]
        json.dump({"context": context, "benchmarks": entries, "stability": hard_cases(),
                   "figures": figures(names)}, file)
    return path
