#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A table per technique of its errors by cause, on the built-in scenes and on models: markdown on standard output.

usage: bench/map_errors.py TECHNIQUE... [--model FILE...] [--program build/release/bin/ombrage] [--size 640x360] [--work out/map-errors]

Every light of a scene is a row, but of scenes with more than four only the last. Models stand on a ground in the default light.
"""
import argparse
import json
import pathlib
import subprocess
import sys

METRICS = ["acne", "contact_gap", "leak", "leak_mass", "alias", "false_shadow", "wrong", "rmse"]


def call(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("techniques", nargs="+")
    parser.add_argument("--model", action="append", default=[])
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--work", default="out/map-errors", type=pathlib.Path)
    arguments = parser.parse_args()

    scenes = [s["name"] for s in call([arguments.program, "list", "scenes", "--json"])["scenes"]]
    records = []
    for scene in scenes + arguments.model:
        command = [arguments.program, "compare", scene, "--size", arguments.size, "--json", "-o", arguments.work]
        if scene in arguments.model:
            command.append("--ground")
        else:
            lights = [l["name"] for l in call([arguments.program, "info", scene, "--json"])["lights"]]
            if len(lights) > 4:
                command += ["--light", lights[-1]]
        for technique in arguments.techniques:
            command += ["--technique", technique]
        records += call(command)["records"]
        print(scene, file=sys.stderr)
    for technique in arguments.techniques:
        mine = [r for r in records if r["pipeline"] == technique]
        print(f"\n## {technique}\n\n| scene | light | " + " | ".join(METRICS) + " |\n|---|---|" + "--:|" * len(METRICS))
        for record in mine:
            cells = ["–" if record["metrics"].get(m) is None else f"{record['metrics'][m]:.5f}" for m in METRICS]
            print(f"| {record['scene']} | {record['light']} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
