#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frame times of Ombrage beside other renderers on one scene, by turns in one run.

usage: bench/peers.py FOLDER [--program build/release/bin/ombrage_bench_frames] [--rounds 5] [--frames 12] [--processor] [--out results.json]

FOLDER holds a program per renderer, FOLDER/NAME/run.sh SCENE.bin WIDTH HEIGHT TECHNIQUE FRAMES, which prints a JSON line with
"ms_median", the time of a whole finished frame, and FOLDER/scene/scene.bin: 'PSCN', four uint32 (vertices, triangles, and
how many of each belong to the ground, which casts nothing), then float positions, float normals, uint32 corners.
Renderers that are not there, or fail, are left out and named. Figures are medians over the rounds; "added" is over
the same renderer's "none" in the same round. "Least" compares the quickest single frames of all rounds, which other work on
the machine disturbs least.

"map" draws the light's map anew in every frame, as the others do; "map kept" keeps it while neither light nor casters
move, which they do not here, as Ombrage does by default. "map 1024" is for OGRE, whose 2048² texels lie on 400 m (twice its
shadow far distance of 200 m), 0.20 m each; Ombrage fits its map to the casters, 124 m, and has 0.12 m with 1024².

--processor measures the processor time of the whole process for each further frame in the place of the wall clock's: on a
machine that is busy with other work it scatters less. It runs every program with a quarter of the frames and with all of them,
and leaves three.js out, whose browser keeps processes that nobody waits for.
"""
import argparse
import json
import pathlib
import resource
import statistics
import struct
import subprocess
import sys

PEERS = {
    "osg": ["none", "ShadowMap"],
    "three": ["none", "Basic"],
    "ogre": ["none", "texture_additive", "stencil_additive"],
}
OURS = {
    "none": "none",
    "map": "map:resolution=2048,cache=false",
    "map 1024": "map:resolution=1024,cache=false",
    "map kept": "map:resolution=2048",
    "pcf": "pcf:resolution=2048,cache=false",
    "volume-zfail": "volume-zfail",
}
SIZE = (1280, 720)


def write_scene(binary, folder):
    """The same scene as two models and a scene file."""
    data = binary.read_bytes()
    if data[:4] != b"PSCN":
        sys.exit(f"{binary}: not a PSCN file")
    vertices, triangles, ground_vertices, ground_triangles = struct.unpack("<4I", data[4:20])
    floats = struct.unpack(f"<{6 * vertices}f", data[20:20 + 24 * vertices])
    positions, normals = floats[:3 * vertices], floats[3 * vertices:]
    corners = struct.unpack(f"<{3 * triangles}I", data[20 + 24 * vertices:20 + 24 * vertices + 12 * triangles])

    def model(name, color, v0, v1, t0, t1):
        (folder / f"{name}.mtl").write_text(f"newmtl m\nKd {color}\nKs 0 0 0\n")
        with open(folder / f"{name}.obj", "w") as file:
            file.write(f"mtllib {name}.mtl\nusemtl m\n")
            for keyword, values in (("v", positions), ("vn", normals)):
                for i in range(v0, v1):
                    file.write("%s %.9g %.9g %.9g\n" % (keyword, *values[3 * i:3 * i + 3]))
            for i in range(t0, t1):
                file.write("f " + " ".join(f"{c - v0 + 1}//{c - v0 + 1}" for c in corners[3 * i:3 * i + 3]) + "\n")

    model("ground", ".8 .8 .8", 0, ground_vertices, 0, ground_triangles)
    model("casters", ".8 .55 .35", ground_vertices, vertices, ground_triangles, triangles)
    scene = {"name": "peers",
             "models": [{"file": "ground.obj", "casts": False}, {"file": "casters.obj"}],
             "lights": [{"type": "sun", "direction": [-40, -70, -25], "intensity": 2.5}],
             "cameras": [{"name": "main", "position": [45, 32, 62], "target": [0, 0, 0], "fov_deg": 45}],
             "ambient": 0.25}
    path = folder / "scene.json"
    path.write_text(json.dumps(scene))
    return path


def peer_command(folder, name, technique, frames):
    return [folder / name / "run.sh", folder / "scene/scene.bin", *map(str, SIZE), technique, str(frames), folder / "scene/ombrage/peer.png"]


def processor_ms(command_of, frames):
    """Processor time per frame, from the difference of two runs: what starts and ends a program falls out."""
    spent = []
    for count in (frames // 4, frames):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run(command_of(count), capture_output=True, timeout=300)
        except (OSError, subprocess.TimeoutExpired):
            return None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            return None
        spent.append(1e3 * (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime))
    ms = (spent[1] - spent[0]) / (frames - frames // 4)
    return {"median": ms, "least": ms}


def processor_round(program, scene, folder, frames):
    times = {}
    for name, technique in OURS.items():
        times[name] = processor_ms(
            lambda count: [program, scene, "--rounds", "1", "--frames", str(count), "--shadow", technique], frames)
    for name, techniques in PEERS.items():
        for technique in techniques if name != "three" else []:
            times[f"{name} {technique}"] = processor_ms(lambda count: peer_command(folder, name, technique, count), frames)
    return times


def run_peer(folder, name, technique, frames):
    command = peer_command(folder, name, technique, frames)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        result = json.loads(lines[-1]) if lines else {}
        return {"median": result["ms_median"], "least": result["ms_min"]} if result else None
    except (OSError, subprocess.TimeoutExpired, ValueError, KeyError):
        return None


def run_ours(program, scene, frames):
    command = [program, scene, "--yardstick", "--json", "--rounds", "1", "--frames", str(frames)]
    for technique in OURS.values():
        command += ["--shadow", technique]
    result = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    names = ["loop none", "loop hard", *OURS]
    return {
        name: {"median": subject["ms_median"], "least": subject["ms_least"]} for name, subject in zip(names, result["subjects"])
    }, result["renderer"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=pathlib.Path("build/release/bin/ombrage_bench_frames"))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--processor", action="store_true")
    parser.add_argument("--out", type=pathlib.Path)
    options = parser.parse_args()

    folder = options.folder.resolve()
    scratch = folder / "scene/ombrage"
    scratch.mkdir(exist_ok=True)
    scene = write_scene(folder / "scene/scene.bin", scratch)
    rounds, device = [], ""
    for number in range(options.rounds):
        if options.processor:
            times = processor_round(options.program, scene, folder, options.frames)
        else:
            times, device = run_ours(options.program, scene, options.frames)
            for name, techniques in PEERS.items():
                for technique in techniques:
                    times[f"{name} {technique}"] = run_peer(folder, name, technique, options.frames)
        rounds.append(times)
        print(f"round {number + 1} of {options.rounds}", file=sys.stderr)

    def spread(ratios, least):
        if not ratios:
            return "not measured"
        return f"{statistics.median(ratios):.2f} [{min(ratios):.2f} .. {max(ratios):.2f}], least {least:.2f}"

    def least(name):
        return min((r[name]["least"] for r in rounds if r.get(name)), default=float("nan"))

    def over(a, b):
        return spread([r[a]["median"] / r[b]["median"] for r in rounds if r.get(a) and r.get(b)], least(a) / least(b))

    def added_over(a, a0, b, b0):
        def added(r, name, none):
            return r[name]["median"] - r[none]["median"]

        ratios = [added(r, a, a0) / added(r, b, b0) for r in rounds if all(r.get(k) for k in (a, a0, b, b0)) and added(r, b, b0) > 0]
        return spread(ratios, (least(a) - least(a0)) / (least(b) - least(b0)))

    clock = "processor time" if options.processor else "wall clock"
    print(f"{SIZE[0]}x{SIZE[1]}, {device or 'device as in the other table'}, {clock}, {options.rounds} rounds of {options.frames} frames\n")
    print("| what | ms, median | least |\n|---|---|---|")
    for name in rounds[0]:
        values = [r[name]["median"] for r in rounds if r.get(name)]
        print(f"| {name} | {statistics.median(values):.1f} | {least(name):.1f} |" if values else f"| {name} | not measured | |")
    print("\n| ratio | median [least .. most] | asked for |\n|---|---|---|")
    print(f"| none / minimal loop none | {over('none', 'loop none')} | 1.0 |")
    print(f"| pcf / minimal loop hard | {over('pcf', 'loop hard')} | 1.35 |")
    print(f"| map / OSG ShadowMap, total | {over('map', 'osg ShadowMap')} | 1.0 |")
    print(f"| map kept / OSG ShadowMap, total | {over('map kept', 'osg ShadowMap')} | |")
    print(f"| map / OSG ShadowMap, added | {added_over('map', 'none', 'osg ShadowMap', 'osg none')} | 1.0 |")
    print(f"| map / three.js Basic, total | {over('map', 'three Basic')} | 1.0 |")
    print(f"| map / three.js Basic, added | {added_over('map', 'none', 'three Basic', 'three none')} | 1.0 |")
    print(f"| map / OGRE texture shadows, total | {over('map', 'ogre texture_additive')} | 1.2 |")
    print(f"| map 1024 / OGRE texture shadows, total | {over('map 1024', 'ogre texture_additive')} | 1.2 |")
    print(f"| map kept / OGRE texture shadows, total | {over('map kept', 'ogre texture_additive')} | |")
    print(f"| volume-zfail / OGRE stencil additive, added "
          f"| {added_over('volume-zfail', 'none', 'ogre stencil_additive', 'ogre none')} | 1.0 |")
    if options.out:
        options.out.write_text(json.dumps({"device": device, "clock": clock, "size": SIZE, "frames": options.frames, "rounds": rounds}, indent=1))


if __name__ == "__main__":
    main()
