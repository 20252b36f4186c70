#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Quality of the techniques of ambient occlusion against T1 and against the integral that each claims: tables of markdown on standard output.

usage: bench/ao_quality.py [TECHNIQUE...] [--scene SCENE...] [--filter ID] [--program build/release/bin/ombrage] [--size 640x360] [--spp 256]
                           [--work out/ao-quality] [--out FILE]

TECHNIQUE: ID[:key=value,...]; all of the family by default, each raw and, with --filter, after it. Model files stand on a ground.
"""
import argparse
import json
import pathlib
import subprocess
import sys

METRICS = ["psnr", "gain_db", "ssim", "bias", "noise", "residual"]


def call(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("techniques", nargs="*")
    parser.add_argument("--scene", action="append")
    parser.add_argument("--filter", default="")
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--spp", default="256")
    parser.add_argument("--work", default="out/ao-quality", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()

    techniques = arguments.techniques
    if not techniques:
        listed = call([arguments.program, "list", "techniques", "--json"])["techniques"]
        techniques = [t["id"] for t in listed if t["family"] == "ao" and t["id"] != "ao/none"]
    if arguments.filter:
        techniques = [p for t in techniques for p in (t, f"{t}+{arguments.filter}")]
    records = []
    for scene in arguments.scene or ["corner", "cornell", "bumpy"]:
        command = [arguments.program, "compare", scene, "--size", arguments.size, "--spp", arguments.spp, "--json", "-o", arguments.work]
        for technique in techniques:
            command += ["--technique", technique]
        if "/" in scene:
            command.append("--ground")
        records += call(command)["records"]
        print(scene, file=sys.stderr)
    for scene in dict.fromkeys(r["scene"] for r in records):
        for kind in dict.fromkeys(r["truth"]["kind"] for r in records):
            mine = [r for r in records if r["scene"] == scene and r["truth"]["kind"] == kind]
            if not mine:
                continue
            print(f"\n### {scene}, {kind}\n\n| technique | " + " | ".join(METRICS) + " |\n|---|" + "--:|" * len(METRICS))
            for record in sorted(mine, key=lambda r: -(r["metrics"]["psnr"] or 0)):
                digits = {"psnr": 2, "gain_db": 2}
                cells = ["–" if record["metrics"].get(m) is None else f"{record['metrics'][m]:.{digits.get(m, 3)}f}" for m in METRICS]
                print(f"| `{record['pipeline']}` | " + " | ".join(cells) + " |")
    if arguments.out:
        rows = [{k: r[k] for k in ("scene", "pipeline", "truth", "metrics")} for r in records]
        arguments.out.write_text(json.dumps({"records": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
