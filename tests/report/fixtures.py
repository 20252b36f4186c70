# SPDX-License-Identifier: MIT
"""The reports that the browser test opens, made by the program itself."""
import json
import os
import subprocess

EVIL = "</script><script>document.title='broken'</script><img src=x onerror=\"document.title='broken'\">"
MANY = 300


def run(program, *arguments):
    result = subprocess.run([program, *arguments], capture_output=True, text=True, env={**os.environ, "OMBRAGE_CACHE": "off"})
    if result.returncode != 0:
        raise RuntimeError(f"{program} {' '.join(arguments)} ended with {result.returncode}: {result.stderr}")


def small(program, folder):
    """Every shadow technique on two scenes, and a bench of two in the same folder."""
    run(program, "compare", "gap", "sphere", "--all", "shadow", "--size", "160x90", "-o", folder)
    run(program, "bench", "gap", "--technique", "shadow/none", "--technique", "shadow/planar", "--size", "64x36", "--frames", "12",
        "--warmup", "1", "-o", folder)
    run(program, "report", folder)
    return os.path.join(folder, "report.html")


def many_rows(program, source, folder):
    """Hundreds of rows in one table, with names that would break a page that took them for markup."""
    with open(os.path.join(source, "records.jsonl"), encoding="utf-8") as file:
        record = json.loads(next(line for line in file if '"shadow/map"' in line))
    os.makedirs(folder, exist_ok=True)
    images = os.path.join(folder, "images")
    if not os.path.exists(images):
        os.symlink(os.path.join(os.path.abspath(source), "images"), images)
    record["scene"] = record["camera"] = EVIL
    record["warnings"] = [EVIL]
    with open(os.path.join(folder, "records.jsonl"), "w", encoding="utf-8") as file:
        for i in range(MANY):
            record["pipeline"] = f"shadow/map:resolution={i}" if i else f"shadow/map:{EVIL}"
            # A fixed scatter: 7919 is prime to 300, so every error occurs once.
            record["metrics"]["rmse"] = 0.001 * (1 + i * 7919 % MANY)
            record["gpu_ms"] = {"median": 1 + i, "p95": 2 + i, "clock": "wall", "samples": [1 + i] * 3}
            file.write(json.dumps(record) + "\n")
    run(program, "report", folder)
    return os.path.join(folder, "report.html")
