#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A table per technique of its errors by cause, on the built-in scenes and on models: markdown on standard output.

usage: bench/map_errors.py TECHNIQUE... [--model FILE...] [--program build/release/bin/ombrage] [--size 640x360]
                           [--work out/map-errors] [--records FILE]

Records are kept in FILE as they come, and what is there already is not measured again. Every light of a scene is a row, but of
scenes with more than four only the last. Models stand on a ground in the default light.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import time

METRICS = ["acne", "contact_gap", "leak", "leak_mass", "alias", "false_shadow", "wrong", "rmse"]


def call(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)


def cell(value):
    return "–" if value is None else f"{value:.5f}" if value else "0"


def compared(arguments, scene, techniques, fitting):
    """Records of one scene by technique: a comparison a light, with those that fit its type."""
    lights = [{"name": "sun", "type": "sun"}]
    command = [arguments.program, "compare", scene, "--size", arguments.size, "--json", "-o", arguments.work]
    if scene in arguments.model:
        command.append("--ground")
    else:
        lights = call([arguments.program, "info", scene, "--json"])["lights"]
    found = {t: [] for t in techniques}
    for light in lights if len(lights) <= 4 else lights[-1:]:
        chosen = [t for t in techniques if light["type"] in fitting[t]]
        if not chosen:
            continue
        named = [part for t in chosen for part in ("--technique", t)]
        for record in call(command + ["--light", light["name"]] + named)["records"]:
            found[record["pipeline"]].append(record)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("techniques", nargs="+")
    parser.add_argument("--model", action="append", default=[])
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--work", default="out/map-errors", type=pathlib.Path)
    parser.add_argument("--records", type=pathlib.Path)
    arguments = parser.parse_args()

    scenes = [s["name"] for s in call([arguments.program, "list", "scenes", "--json"])["scenes"]]
    listed = call([arguments.program, "list", "techniques", "--json"])["techniques"]
    fitting = {t["id"]: t["domain"]["lights"] for t in listed if t["family"] == "shadow"}
    kept = arguments.records and arguments.records.exists() and json.loads(arguments.records.read_text())
    measured = kept or {}   # technique -> scene -> records
    for scene in scenes + arguments.model:
        missing = [t for t in arguments.techniques if scene not in measured.setdefault(t, {})]
        if not missing:
            continue
        began = time.monotonic()
        for technique, records in compared(arguments, scene, missing, fitting).items():
            measured[technique][scene] = [{k: r[k] for k in ("scene", "light", "metrics")} for r in records]
        if arguments.records:
            arguments.records.write_text(json.dumps(measured, indent=1) + "\n")
        print(f"{scene} {time.monotonic() - began:.0f} s", file=sys.stderr, flush=True)
    for technique in arguments.techniques:
        mine = [record for scene in scenes + arguments.model for record in measured[technique][scene]]
        print(f"\n## {technique}\n\n| scene | light | " + " | ".join(METRICS) + " |\n|---|---|" + "--:|" * len(METRICS))
        for record in mine:
            cells = [cell(record["metrics"].get(m)) for m in METRICS]
            print(f"| {record['scene']} | {record['light']} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
