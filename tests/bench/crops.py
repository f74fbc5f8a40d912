#!/usr/bin/env python3
"""What it takes to see 8 x 8 pixels of a scene, with one sample each: seconds, processor seconds and the most memory that a program has at a time.

    tests/bench/crops.py [SCENE.pbrt ...] [--interior TRIANGLES] [--sponge LEVELS] [--pbrt PBRT] [--before OTHER/eikonal]

PBRT is pbrt-v4's program, OTHER/eikonal another build of ours; all render by turns, in so many threads each, with kernels that are compiled. --interior: also
the furnished room of interior.py; --sponge: also 20^LEVELS instances in nested files (instances.py). Prints medians of the repeats; the ratios are medians of those
of each turn.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from instances import write_sponge_of_files
from interior import write_interior
from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = 8


def commands(o, scene, image):
    """(who, the command) of all."""
    info = json.loads(subprocess.run([str(o.program), "info", "--json", str(scene)], capture_output=True, text=True, check=True).stdout)
    x, y = info["width"] // 2, info["height"] // 2
    common = ["--spp", "1", "--nthreads", str(o.threads), "--pixelbounds", f"{x},{x + SIZE},{y},{y + SIZE}"]
    yield "Eikonal", [o.program, "render", scene, "--quiet", *common, "-o", image]
    if o.before:
        yield "Eikonal, before", [o.before, "render", scene, "--quiet", *common, "-o", image]
    if o.pbrt:
        yield "pbrt-v4", [o.pbrt, "--quiet", *common, "--outfile", image, scene]


def measure(command, environment):
    """(seconds, processor seconds, MiB)"""
    words = [str(word) for word in command]
    with tempfile.TemporaryFile("w+") as said:
        start = time.perf_counter()
        process = subprocess.Popen(words, stdout=said, stderr=said, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        if status:
            said.seek(0)
            sys.exit(f"crops: {' '.join(words)} failed:\n{said.read()}")
    return seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def compare(o, scene, name, folder, add):
    """Renders a scene with all, and adds their rows."""
    environment = {**os.environ, "EIKONAL_CACHE_DIR": str(folder / "kernels")}
    programs = dict(commands(o, scene, folder / "image.exr"))
    for command in programs.values():
        measure(command, environment)
    runs = {who: [] for who in programs}
    for _ in range(o.repeats):
        for who, command in programs.items():
            runs[who].append(measure(command, environment))
    for who, theirs in runs.items():
        ratios = [statistics.median(a[i] / b[i] for a, b in zip(runs["Eikonal"], theirs)) for i in range(3)]
        add(name, who, *(statistics.median(run[i] for run in theirs) for i in range(3)), *ratios)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", type=pathlib.Path, nargs="*")
    options.add_argument("--interior", type=int, metavar="TRIANGLES")
    options.add_argument("--sponge", type=int, metavar="LEVELS")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--before", type=pathlib.Path)
    options.add_argument("--pbrt", type=pathlib.Path)
    options.add_argument("--threads", type=int, default=os.cpu_count())
    options.add_argument("--repeats", type=int, default=5)
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("crops", {"scene": None, "renderer": None, "s": ".2f", "processor s": ".2f", "peak MiB": ".0f",
                                         "our s / theirs": ".2f", "our processor s / theirs": ".2f", "our MiB / theirs": ".2f"})
    with tempfile.TemporaryDirectory() as folder:
        scenes = [(scene, f"{scene.parent.name}/{scene.name}") for scene in o.scenes]
        if o.interior:
            scenes.append((write_interior(pathlib.Path(folder), o.interior), f"generated/interior.pbrt, {o.interior * 1e-6:.2f} M triangles"))
        if o.sponge:
            scenes.append((write_sponge_of_files(pathlib.Path(folder) / "sponge.pbrt", o.sponge), f"generated/sponge.pbrt, {20 ** o.sponge} instances"))
        for scene, name in scenes:
            compare(o, scene, name, pathlib.Path(folder), add)


if __name__ == "__main__":
    main()
