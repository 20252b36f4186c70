#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shadow settings that other engines ship, translated into Ombrage's parameters and scored beside Ombrage's own defaults.

usage: bench/engines.py [--program build/release/bin/ombrage] [--only PATTERN] [--out bench/results/engines.json] [--work DIR]

Each set is drawn with the technique that it stands for, at its own map size, over the scenes of its light type; beside it the
same technique and map size with Ombrage's defaults. The score is acne + contact_gap, shares of the picture, mean over the scenes.
docs/dev/engines.md says where the sets come from and how they are translated.
"""
import argparse
import fnmatch
import json
import math
import pathlib
import subprocess
import sys

SCENES = {
    "sun": ["plane-grazing", "gap", "sphere", "menger", "window", "thin-wall", "resting", "fence"],
    "spot": ["two-casters", "three-casters", "penumbrae:spot"],
    "point": ["room", "cornell", "nave:lamp", "penumbrae:lamp"],
}

# bgfx, examples/16-shadowmaps: map size (of a face of equal texels in all for the tetrahedron's atlas), then near and far plane, bias in
# window depth, normal offset in an object's own units, and for the moments' filters what else tells: VSM's minimum variance and
# depth multiplier, ESM's hardness times multiplier.
BGFX_SIZE = {"spot": 1024, "point": 1672, "sun": 2048}
BGFX = {
    ("spot", "inverse", "hard"): (1, 250, 0.0035, 0.0012),
    ("spot", "inverse", "pcf"): (1, 250, 0.007, 0.001),
    ("spot", "inverse", "pcss"): (1, 250, 0.001, 0.001),
    ("spot", "inverse", "vsm"): (8, 250, 0.045, 0.001, 0.02, 450),
    ("spot", "inverse", "esm"): (3, 250, 0.02, 0.001, 0.7 * 9000),
    ("spot", "linear", "hard"): (1, 250, 0.0025, 0.0012),
    ("spot", "linear", "pcf"): (1, 250, 0.0025, 0.001),
    ("spot", "linear", "pcss"): (1, 250, 0.0025, 0.001),
    ("spot", "linear", "vsm"): (1, 250, 0.006, 0.001, 0.02, 300),
    ("spot", "linear", "esm"): (1, 250, 0.0055, 0.001, 0.7 * 2500),
    ("point", "inverse", "hard"): (1, 250, 0.006, 0.001),
    ("point", "inverse", "pcf"): (1, 250, 0.004, 0.001),
    ("point", "inverse", "pcss"): (1, 250, 0.001, 0.001),
    ("point", "inverse", "vsm"): (8, 250, 0.055, 0.001, 0.02, 450),
    ("point", "inverse", "esm"): (3, 250, 0.035, 0.001, 0.7 * 9000),
    ("point", "linear", "hard"): (1, 250, 0.003, 0.001),
    ("point", "linear", "pcf"): (1, 250, 0.0035, 0.001),
    ("point", "linear", "pcss"): (1, 250, 0.001, 0.001),
    ("point", "linear", "vsm"): (1, 250, 0.006, 0.001, 0.02, 400),
    ("point", "linear", "esm"): (1, 250, 0.007, 0.001, 0.7 * 8000),
    ("sun", "inverse", "hard"): (1, 550, 0.0012, 0.001),
    ("sun", "inverse", "pcf"): (1, 550, 0.0012, 0.001),
    ("sun", "inverse", "pcss"): (1, 550, 0.0012, 0.001),
    ("sun", "inverse", "vsm"): (1, 550, 0.004, 0.001, 0.02, 2500),
    ("sun", "inverse", "esm"): (1, 550, 0.004, 0.001, 0.7 * 9500),
    ("sun", "linear", "hard"): (1, 550, 0.0012, 0.001),
    ("sun", "linear", "pcf"): (1, 550, 0.0012, 0.001),
    ("sun", "linear", "pcss"): (1, 550, 0.0012, 0.001),
    ("sun", "linear", "vsm"): (1, 550, 0.004, 0.001, 0.02, 2500),
    ("sun", "linear", "esm"): (1, 550, 0.004, 0.001, 0.7 * 9500),
}
FILTERS = {
    "hard": ("shadow/map", {}),
    "pcf": ("shadow/pcf", {"size": 4}),
    "pcss": ("shadow/pcss", {}),
    "vsm": ("shadow/vsm", {"kernel": 9}),
    "esm": ("shadow/esm", {"kernel": 9}),
}


class Place:
    """What a translation needs to know of one light in one scene."""

    def __init__(self, texel_m, distance_m, extent_m):
        self.texel_m = texel_m          # where the camera looks
        self.distance_m = distance_m    # from the lamp to there; none for a sun
        self.extent_m = extent_m        # the largest side of the scene's bounds


def bgfx_params(light, depth, near, far, bias, offset, place):
    """What bgfx subtracts from a window depth of [1/2, 1] over the view's range, as texels."""
    if light == "sun":
        # The range, twice the far plane, is about the sample's ground; ours is the scene's extent.
        bias_m = bias * place.extent_m
    elif depth == "linear":
        # As much of our lamp's distance as of a sample 100 units away, where its objects stand.
        bias_m = 2 * bias * (far - near) / 100 * place.distance_m
    else:
        # d(depth)/d(distance) = far near / ((far - near) distance^2), and the shader divides the bias by the distance.
        bias_m = 2 * bias * place.distance_m * (far - near) / (far * near)
    return {"bias": "normal-offset", "constant-bias": bias_m / place.texel_m, "normal-offset": offset / place.texel_m}


def sets():
    """Yields name, light, technique, map size, translation."""
    for (light, depth, kind), row in BGFX.items():
        technique, own = FILTERS[kind]

        def translate(place, light=light, depth=depth, row=row, own=own):
            return {**own, **bgfx_params(light, depth, *row[:4], place)}

        yield f"bgfx {light} {depth} {kind}", light, technique, BGFX_SIZE[light], translate
    for light in SCENES:
        # No bias at all; of one-sided materials the far sides are drawn into the map.
        yield (f"three.js {light}", light, "shadow/pcf", 512,
               lambda place: {"size": 3, "bias": "constant", "constant-bias": 0, "cull": "front"})
        godot = {"sun": (0.1, 2, 2048), "spot": (0.03, 1, 1024), "point": (0.1, 1, 1024)}[light]
        # A hundredth of the bias in metres, and as many texels along the normal.
        yield (f"Godot {light}", light, "shadow/pcf", godot[2],
               lambda place, godot=godot: {"size": 3, "bias": "normal-offset", "constant-bias": godot[0] / 100 / place.texel_m,
                                           "normal-offset": godot[1]})
        bevy = {"sun": (0.02, 1.8, 2048), "spot": (0.02, 1.8 * math.sqrt(2), 2048), "point": (0.02, 0.6 * math.sqrt(2), 1024)}[light]
        yield (f"Bevy {light}", light, "shadow/pcf", bevy[2],
               lambda place, bevy=bevy: {"size": 5, "bias": "normal-offset", "constant-bias": bevy[0] / place.texel_m,
                                         "normal-offset": bevy[1]})
        # One millimetre and twice the slope, as its polygon offset has it.
        yield (f"Filament {light}", light, "shadow/pcf", 1024,
               lambda place: {"size": 3, "bias": "slope", "constant-bias": 0.001 / place.texel_m, "slope-bias": 2})


def run(program, folder, scene, techniques):
    scene, _, light = scene.partition(":")
    command = [program, "compare", scene, *(["--light", light] if light else []), "--json", "-o", folder]
    for technique in techniques:
        command += ["--technique", technique]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)["records"]


def text(technique, params):
    def value(v):
        return f"{v:.6g}" if isinstance(v, float) else str(v)
    return technique + (":" if params else "") + ",".join(f"{k}={value(v)}" for k, v in params.items())


def place_of(program, folder, scene, size):
    """Texel and distance from a first run, the rest from what the scene says of itself."""
    record = run(program, folder, scene, [f"shadow/map:resolution={size}"])[0]
    info = json.loads(subprocess.run([str(program), "info", scene.partition(":")[0], "--json"], capture_output=True,
                                     text=True, check=True).stdout)
    extent_m = max(info["bounds"]["size_m"])
    counters = record["counters"]
    if "texel [m]" in counters:
        return Place(counters["texel [m]"], None, extent_m)
    camera = next(c for c in info["cameras"] if c["name"] == record["camera"])
    lamp = next(l for l in info["lights"] if l["name"] == record["light"])
    distance_m = math.dist(camera["target"], lamp["position"])
    return Place(counters["texel per metre from the light"] * distance_m, distance_m, extent_m)


def limited(program, technique, params, cache={}):
    """Values held to the parameters' ranges, and what had to be held."""
    if technique not in cache:
        listed = json.loads(subprocess.run([str(program), "list", "params", technique, "--json"], capture_output=True, text=True,
                                           check=True).stdout)
        cache[technique] = {p["key"]: p for p in listed["params"]}
    held = {}
    for key, value in params.items():
        declared = cache[technique][key]
        if isinstance(value, (int, float)) and "range" in declared:
            limit = min(max(value, declared["range"][0]), declared["range"][1])
            if limit != value:
                held[key] = value
                params = {**params, key: limit}
    return params, held


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--only", default="*")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--work", default="out/engines", type=pathlib.Path)
    arguments = parser.parse_args()

    places = {}
    rows = []
    print("| set | technique | acne | contact_gap | leak | sum | Ombrage's defaults: acne | contact_gap | leak | sum | |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for name, light, technique, size, translate in sets():
        if not fnmatch.fnmatch(name, arguments.only):
            continue
        sums = {"set": {}, "ours": {}}
        held = {}
        scenes = [s for s in SCENES[light] if technique != "shadow/pcss" or s.startswith("penumbrae")] or ["penumbrae:sun"]
        for scene in scenes:
            folder = arguments.work / scene.replace(":", "-")
            if (scene, size) not in places:
                places[scene, size] = place_of(arguments.program, folder, scene, size)
            params, outside = limited(arguments.program, technique, {"resolution": size, **translate(places[scene, size])})
            held.update(outside)
            records = run(arguments.program, folder, scene, [text(technique, params), text(technique, {"resolution": size})])
            for who, record in zip(("set", "ours"), records):
                for metric in ("acne", "contact_gap", "leak", "wrong"):
                    value = record["metrics"][metric] or 0.0
                    sums[who][metric] = sums[who].get(metric, 0.0) + value / len(scenes)
        score = {who: m["acne"] + m["contact_gap"] for who, m in sums.items()}
        verdict = "wins" if score["ours"] < score["set"] - 1e-5 else "ties" if score["ours"] <= score["set"] + 1e-5 else "loses"
        row = {"set": name, "technique": technique, "resolution": size, "scenes": scenes, "scores": sums, "verdict": verdict, "held": held}
        rows.append(row)
        cells = [f"{sums[who][m]:.5f}" for who in ("set", "ours") for m in ("acne", "contact_gap", "leak")]
        print(f"| {name} | `{technique}` {size} | {' | '.join(cells[:3])} | {score['set']:.5f} | {' | '.join(cells[3:])} | "
              f"{score['ours']:.5f} | {verdict} |", flush=True)
    if arguments.out:
        arguments.out.write_text(json.dumps({"sets": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
