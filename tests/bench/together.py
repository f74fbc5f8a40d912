#!/usr/bin/env python3
"""How much faster two devices render an image than one, by turns, and whether it has the same bits.

    tests/bench/together.py [SCENE ...]

The devices are two of PoCL's `basic`, which has one thread. So two of them take the two cores of a machine that one leaves half idle; a
figure of 2 would be perfect, and what the same processor reaches as one device of two threads (`pthread`) is beside it.
Prints a row for each scene. Takes about 3 minutes.
"""

import argparse
import os
import pathlib
import re
import statistics
import subprocess
import tempfile

from paths import ROOT

CASES = {"one": ("basic", "0"), "two": ("basic basic", "all"), "threads": ("pthread", "0")}


def render_seconds(program, scene, options, case, image):
    devices, wanted = CASES[case]
    command = [program, "render", scene, *options, "--device", wanted, "-o", image, "--quiet", "--stats"]
    out = subprocess.run(command, env=os.environ | {"POCL_DEVICES": devices}, capture_output=True, text=True, check=True).stdout
    return float(re.search(r"^  render +([0-9.]+) s", out, re.M)[1])


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", type=pathlib.Path,
                         default=[ROOT / "scenes" / f"{name}.pbrt" for name in ("cornell-box", "environment", "instances", "glass-ball")])
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--resolution", default="256x256")
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--rounds", type=int, default=3)
    o = options.parse_args()
    print("| scene | one device, s | two | speed-up | by threads | same image |\n|---|--:|--:|--:|--:|---|")
    with tempfile.TemporaryDirectory() as name:
        image = {case: pathlib.Path(name) / f"{case}.exr" for case in CASES}
        for scene in o.scenes:
            seconds = {case: [] for case in CASES}
            for _ in range(o.rounds + 1):
                for case in CASES:
                    wanted = ["--resolution", o.resolution, "--spp", str(o.samples)]
                    seconds[case].append(render_seconds(o.program, scene, wanted, case, image[case]))
            one, two, threads = (statistics.median(seconds[case][1:]) for case in CASES)   # the first round compiles kernels
            compared = subprocess.run([o.program, "compare", image["two"], image["one"], "--json"], capture_output=True, text=True, check=True)
            same = re.search(r'"relativeMse": 0(\.0)?[,\n]', compared.stdout) is not None
            print(f"| {scene.stem} | {one:.2f} | {two:.2f} | {one / two:.2f} | {one / threads:.2f} | {'yes' if same else 'no'} |", flush=True)


if __name__ == "__main__":
    main()
