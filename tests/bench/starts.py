#!/usr/bin/env python3
"""From the command to the first ray, with an empty cache and with a full one.

    tests/bench/starts.py SCENE ...

Prints a row for each scene: kernels that had to be compiled, seconds for them and until the first ray, cold and warm. Warm times are the
median of --repeats; cold ones are measured once, since each takes seconds. Nothing else should run on the machine.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]


def start(program, scene, cache):
    """(kernels compiled, seconds for kernels, seconds to the first ray)"""
    with tempfile.TemporaryDirectory() as folder:
        environment = {key: value for key, value in os.environ.items() if key != "POCL_CACHE_DIR"}
        environment["EIKONAL_CACHE_DIR"] = cache
        command = [program, "render", scene, "--spp", "1", "--cropwindow", "0,0.02,0,0.02", "--stats", "-o", f"{folder}/image.exr"]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=environment)
    text = done.stdout + done.stderr
    kernels = re.search(r"^  compile the kernels +([0-9.]+) s +(\d+) compiled", text, re.MULTILINE)
    first = re.search(r"^  until the first ray +([0-9.]+) s", text, re.MULTILINE)
    if done.returncode or not kernels or not first:
        sys.exit(f"starts: {' '.join(map(str, command))} failed:\n{text}")
    return int(kernels[2]), float(kernels[1]), float(first[1])


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", type=pathlib.Path, nargs="+")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--repeats", type=int, default=3)
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("starts", {"scene": None, "kernels": None, "cold: kernels, s": ".1f", "cold: first ray, s": ".1f", "warm: kernels, s": ".2f", "warm: first ray, s": ".2f"})
    for scene in o.scenes:
        with tempfile.TemporaryDirectory() as cache:
            count, cold, cold_first = start(o.program, scene, cache)
            warm = [start(o.program, scene, cache) for _ in range(o.repeats)]
        kernels, first = (statistics.median(run[i] for run in warm) for i in (1, 2))
        add(f"{scene.parent.name}/{scene.name}", count, cold, cold_first, kernels, first)


if __name__ == "__main__":
    main()
