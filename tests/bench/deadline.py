#!/usr/bin/env python3
"""How close to its --deadline a render ends, from outside of the program, with an empty cache of kernels and with a full one.

    tests/bench/deadline.py SCENE ...

Prints a row for each scene and deadline: seconds from the start of the process to its end.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
SUCCESS, PARTIAL_IMAGE = 0, 4


def seconds(program, scene, deadline, cache, more):
    with tempfile.TemporaryDirectory() as folder:
        environment = {key: value for key, value in os.environ.items() if key != "POCL_CACHE_DIR"}
        environment["EIKONAL_CACHE_DIR"] = cache
        command = [program, "render", scene, "--spp", 1 << 20, "--deadline", deadline, "-o", f"{folder}/image.exr", *more]
        command = [str(word) for word in command]
        begin = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        taken = time.perf_counter() - begin
    if done.returncode not in (SUCCESS, PARTIAL_IMAGE):
        sys.exit(f"deadline: {' '.join(command)} failed:\n{done.stderr}")
    return taken


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", type=pathlib.Path, nargs="+")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--deadlines", type=float, nargs="+", default=[20])
    options.add_argument("--render", default="", help="more options of render")
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("deadline", {"scene": None, "deadline, s": "g", "cold, s": ".1f", "warm, s": ".1f"})
    for scene in o.scenes:
        for deadline in o.deadlines:
            with tempfile.TemporaryDirectory() as cache:
                cold, warm = (seconds(o.program, scene, deadline, cache, o.render.split()) for _ in range(2))
                add(f"{scene.parent.name}/{scene.name}", deadline, cold, warm)


if __name__ == "__main__":
    main()
