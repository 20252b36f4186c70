#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `ombrage tune` finds against the defaults, on cameras that it did not search on: a table of gains.

usage: bench/tuned.py TECHNIQUE... --scene SCENE [--scene SCENE...] [--program build/release/bin/ombrage] [--metric rmse] [--keep KEY,KEY]
                      [--evaluations 100] [--size 240x135] [--work out/tuned] [--out FILE]

What buys quality with cost or steadiness stays as it is, for no default can be wrong there: resolution, format, fit and cache by
default. A gain above 20 % says that a default is wrong for that scene.
"""
import argparse
import json
import pathlib
import subprocess
import sys


def tune(arguments, technique, scene):
    name = pathlib.Path(scene).stem
    folder = arguments.work / f"{technique.replace('/', '-')}-{name}"
    listed = json.loads(subprocess.run([str(arguments.program), "list", "params", technique, "--json"], capture_output=True, text=True,
                                       check=True).stdout)
    has = {p["key"] for p in listed["params"]}
    command = [arguments.program, "tune", scene, "--technique", technique, "--metric", arguments.metric, "--evaluations",
               arguments.evaluations, "--size", arguments.size, "-o", folder]
    for key in arguments.keep.split(","):
        if key in has:
            command += ["--keep", key]
    if "/" in scene:
        command.append("--ground")
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads((folder / "tune.json").read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("techniques", nargs="+")
    parser.add_argument("--scene", action="append", required=True)
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--metric", default="rmse")
    parser.add_argument("--keep", default="resolution,format,fit,cache")
    parser.add_argument("--evaluations", default=100, type=int)
    parser.add_argument("--size", default="240x135")
    parser.add_argument("--work", default="out/tuned", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()

    rows = []
    print(f"| technique | scene | {arguments.metric} | tuned | gain | what it changed |\n|---|---|--:|--:|--:|---|")
    for technique in arguments.techniques:
        for scene in arguments.scene:
            found = tune(arguments, technique, scene)
            before, after = (found[who]["held_out"]["error"] for who in ("start", "winner"))
            gain = (before - after) / before if before else 0.0
            changed = found["winner"]["pipeline"].partition(":")[2].replace(",", ", ")
            rows.append({"technique": technique, "scene": pathlib.Path(scene).stem, "metric": arguments.metric, "default": before,
                         "tuned": after, "gain": gain, "changed": changed})
            print(f"| `{technique}` | {pathlib.Path(scene).stem} | {before:.4f} | {after:.4f} | {100 * gain:.0f} % | {changed or 'nothing'} |",
                  flush=True)
    if arguments.out:
        arguments.out.write_text(json.dumps({"gains": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
