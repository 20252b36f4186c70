#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is said of screen-space ambient occlusion, measured again: tables of markdown on standard output and a plot each.

usage: bench/ao_claims.py [families|kernels|thin|volumetric|bumps]... [--scene SCENE]... [--program build/release/bin/ombrage]
                          [--size 640x360] [--spp 256] [--plots docs/images] [--work out/ao-claims] [--out FILE]

families    psnr against T1 over the number of depths read
kernels     ao/blocks by 16, 32 and 64 samples, raw and filtered: noise over 8 seeds, residual, psnr, cost beside the G-buffer's
thin        horizons against bitmasks where occluders are thin
volumetric  one area against points
bumps       the truth of displaced geometry against flat, bump and normal mapped surfaces

--scene replaces a claim's own scenes; model files stand on a ground. Plots need matplotlib (Debian: python3-matplotlib).
"""
import argparse
import json
import pathlib
import subprocess
import sys

DEPTHS = [8, 16, 32, 64]
# Each slice is looked along both ways.
SLICES = {8: "slices=1,steps=4", 16: "slices=2,steps=4", 32: "slices=2,steps=8", 64: "slices=4,steps=8"}
FAMILIES = {
    "ao/blocks": lambda n: f"samples={n}",
    "ao/crytek": lambda n: f"pairs={n // 2}",
    "ao/starcraft2": lambda n: f"samples={n}",
    "ao/volumetric": lambda n: f"samples={n}",
    "ao/ssdo": lambda n: f"samples={n}",
    "ao/alchemy": lambda n: f"samples={n}",
    "ao/sao": lambda n: f"samples={n}",
    "ao/hbao": lambda n: f"directions={max(2, n // 8)},steps={n // max(2, n // 8)}",
    "ao/gtao": lambda n: SLICES[n],
    "ao/vbao": lambda n: SLICES[n],
}
FILTER = "filter/bilateral-separable"


def call(command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
    return json.loads(done.stdout)


class Lab:
    def __init__(self, arguments):
        self.arguments = arguments
        self.found = {}

    def compared(self, scene, pipelines, truth="T1", extra=()):
        """metrics by pipeline"""
        a = self.arguments
        command = [a.program, "compare", scene, "--size", a.size, "--spp", a.spp, "--truth", truth, "--json", "-o", a.work, *extra]
        for pipeline in pipelines:
            command += ["--technique", pipeline]
        if "/" in scene:
            command.append("--ground")
        print(scene, truth, *extra, file=sys.stderr, flush=True)
        return {record["pipeline"]: record["metrics"] for record in call(command)["records"]}

    def timed(self, scene, pipelines):
        """median milliseconds of the passes of each pipeline over those of the G-buffer, by turns in one run"""
        a = self.arguments
        file = a.work / "times.json"
        command = [a.program, "bench", scene, "--size", a.size, "--frames", 8, "--export-json", file, "--json"]
        for pipeline in pipelines:
            command += ["--technique", pipeline]
        if "/" in scene:
            command.append("--ground")
        print(scene, "times", file=sys.stderr, flush=True)
        ratios = {}
        for run in call(command)["groups"][0]["runs"]:
            passes = {p["name"]: p["gpu_ms"]["median"] for p in run["passes"]}
            rest = ("gbuffer", "lighting", "tonemap")
            ratios[run["pipeline"]] = sum(v for k, v in passes.items() if k not in rest) / passes["gbuffer"]
        return ratios

    def scenes(self, own):
        return self.arguments.scene or own


def table(head, rows):
    print("\n| " + " | ".join(head) + " |\n|---|" + "--:|" * (len(head) - 1))
    for row in rows:
        print("| " + " | ".join("–" if c is None else c if isinstance(c, str) else f"{c:.3f}" if abs(c) < 1 else f"{c:.2f}" for c in row) + " |")
    sys.stdout.flush()


def name(scene):
    return pathlib.Path(scene).stem


def figure(lab, title, panels, x_label, y_label, draw, log2=False):
    """One panel a scene, drawn by draw(axes, scene)."""
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "ombrage"
    import matplotlib.pyplot as plt
    plotted, axes = plt.subplots(1, len(panels), figsize=(4.2 * len(panels), 3.8), squeeze=False, sharey=True)
    for axis, scene in zip(axes[0], panels):
        draw(axis, scene)
        axis.set_title(name(scene), fontsize=10)
        axis.set_xlabel(x_label)
        axis.grid(alpha=0.3)
        if log2:
            axis.set_xscale("log", base=2)
    axes[0][0].set_ylabel(y_label)
    axes[0][-1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    plotted.tight_layout()
    plotted.savefig(lab.arguments.plots / f"ao-{title}.svg", metadata={"Date": None})


def families(lab):
    scenes = lab.scenes(["corner", "cornell", "nave"])
    known = {}
    for scene in scenes:
        pipelines = [f"{t}:{p(n)}" for t, p in FAMILIES.items() for n in DEPTHS]
        found = lab.compared(scene, pipelines)
        ordered = iter(found.values())
        known[scene] = {t: [next(ordered)["psnr"] for _ in DEPTHS] for t in FAMILIES}
        print(f"\n### {name(scene)}: psnr against T1 by depths read")
        table(["technique", *map(str, DEPTHS)], [[f"`{t}`", *v] for t, v in sorted(known[scene].items(), key=lambda e: -e[1][-1])])

    def draw(axis, scene):
        for technique, values in known[scene].items():
            axis.plot(DEPTHS, values, marker="o", markersize=3, label=technique)

    figure(lab, "families", scenes, "depths read", "psnr against T1 [dB]", draw, log2=True)
    return known


def kernels(lab):
    scenes = lab.scenes(["nave", "cornell"])
    counts = [16, 32, 64]
    raw = [f"ao/blocks:samples={n}" for n in counts]
    pipelines = [p for r in raw for p in (r, f"{r}+{FILTER}")]
    known = {}
    for scene in scenes:
        found = list(lab.compared(scene, pipelines).values())
        times = list(lab.timed(scene, pipelines).values())
        known[scene] = [[p, m["noise"], m["residual"], m["psnr"], t] for p, m, t in zip(pipelines, found, times)]
        print(f"\n### {name(scene)}: kernels of 16, 32 and 64")
        table(["pipeline", "noise (standard deviation)", "residual", "psnr", "time over the G-buffer's"], [[f"`{r[0]}`", *r[1:]] for r in known[scene]])

    def draw(axis, scene):
        for label, rows in (("raw", known[scene][::2]), ("filtered", known[scene][1::2])):
            axis.plot([r[4] for r in rows], [r[1] for r in rows], marker="o", label=f"noise, {label}")
            axis.plot([r[4] for r in rows], [r[2] for r in rows], marker="s", linestyle="--", label=f"residual, {label}")
            for r, n in zip(rows, counts):
                axis.annotate(str(n), (r[4], r[1]), fontsize=8, xytext=(3, 3), textcoords="offset points")

    figure(lab, "kernels", scenes, "time, G-buffer pass = 1", "standard deviation", draw)
    return known


def thin(lab):
    scenes = lab.scenes(["fence", "fur", "tree"])
    pipelines = ["ao/gtao", *(f"ao/vbao:thickness={t}" for t in (0.02, 0.05, 0.1, 0.25, 0.5)), "ao/hbao"]
    known = {scene: {p: m["psnr"] for p, m in lab.compared(scene, pipelines).items()} for scene in scenes}
    print("\n### thin occluders: psnr against T1")
    rows = {p: [known[s][q] for s in scenes for q in [list(known[s])[i]]] for i, p in enumerate(pipelines)}
    table(["technique", *map(name, scenes)], [[f"`{p}`", *v] for p, v in rows.items()])

    def draw(axis, scene):
        values = list(known[scene].values())
        axis.plot([0.02, 0.05, 0.1, 0.25, 0.5], values[1:6], marker="o", label="ao/vbao")
        axis.axhline(values[0], color="k", label="ao/gtao")
        axis.axhline(values[6], color="k", linestyle=":", label="ao/hbao")
        axis.set_xscale("log")

    figure(lab, "thin", scenes, "thickness [m]", "psnr against T1 [dB]", draw)
    return known


def volumetric(lab):
    scenes = lab.scenes(["corner", "cornell", "nave"])
    counts = [1, 3, 9, 17, 33, 64]
    points = [f"ao/volumetric:sampling=points,samples={n}" for n in counts]
    areas = [f"ao/volumetric:sampling=areas,samples={n}" for n in (1, 4, 9)]
    known = {}
    for scene in scenes:
        found = list(lab.compared(scene, points + areas, truth="own").values())
        known[scene] = [m["psnr"] for m in found]
        print(f"\n### {name(scene)}: points and areas against the volume they claim")
        table(["samples", "psnr"], [[f"`{p}`", v] for p, v in zip(points + areas, known[scene])])

    def draw(axis, scene):
        axis.plot(counts, known[scene][:len(counts)], marker="o", label="points")
        axis.plot([1, 4, 9], known[scene][len(counts):], marker="s", label="areas")

    figure(lab, "volumetric", scenes, "samples", "psnr against the claim [dB]", draw, log2=True)
    return known


def bumps(lab):
    scenes = lab.scenes(["bumpy"])
    techniques = ["ao/none", *FAMILIES, "ao/ray-traced"]
    known = {}
    for scene in scenes:
        known[scene] = {n: lab.compared(scene, techniques, truth="displaced", extra=("--normals", n)) for n in ("geometry", "bump", "map")}
        for metric in ("psnr", "ssim", "bias"):
            print(f"\n### {name(scene)}: {metric} against displaced geometry")
            table(["technique", "flat", "bump", "map"], [[f"`{t}`", *(known[scene][n][t][metric] for n in known[scene])] for t in techniques])

    def draw(axis, scene):
        for i, (normals, found) in enumerate(known[scene].items()):
            axis.barh([k + 0.27 * i for k in range(len(techniques))], [found[t]["psnr"] for t in techniques], height=0.25, label=normals)
        axis.set_yticks([k + 0.27 for k in range(len(techniques))], techniques, fontsize=7)
        axis.invert_yaxis()

    figure(lab, "bumps", scenes, "psnr against displaced geometry [dB]", "", draw)
    return known


CLAIMS = {f.__name__: f for f in (families, kernels, thin, volumetric, bumps)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("claims", nargs="*", metavar="CLAIM")
    parser.add_argument("--scene", action="append")
    parser.add_argument("--program", default="build/release/bin/ombrage", type=pathlib.Path)
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--spp", default="256")
    parser.add_argument("--plots", default="docs/images", type=pathlib.Path)
    parser.add_argument("--work", default="out/ao-claims", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    unknown = [c for c in arguments.claims if c not in CLAIMS]
    if unknown:
        parser.error(f"no claim {', '.join(unknown)}; there are {', '.join(CLAIMS)}")
    arguments.work.mkdir(parents=True, exist_ok=True)
    found = {claim: CLAIMS[claim](Lab(arguments)) for claim in arguments.claims or CLAIMS}
    if arguments.out:
        arguments.out.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
