#!/usr/bin/env python3
"""What paths from lights are worth: the error of "volpath", "bdpt" and "vcm" after the same time.

    tests/bench/light_paths.py [SCENE ...] [--seconds 10] [--reference-seconds 200] [--rounds 3] [--common "--resolution 192x192"] [--json FILE]

Renders each scene for the same time with each integrator and other seeds, and compares with a long render with "vcm", which finds all that the others find, and more; its bias is that of a
radius that has shrunk. --reference-integrator names another one.
Prints, as medians over the rounds: the relative MSE (squared error over squared reference plus 0.01, mean over the pixels), which a few fireflies may dominate; the mean FLIP
(0: no visible difference, 1: the largest); and the mean of the image relative to the reference's.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ["water-pool", "glass-ball", "lamp-in-glass", "ring", "cornell-box"]
INTEGRATORS = ("volpath", "bdpt", "vcm")
FIGURES = {"relative MSE": ".3g", "FLIP": ".3f", "mean": ".3f"}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode not in (0, 4):   # 4: the time was over
        sys.exit(f"light_paths: {' '.join(map(str, command))} failed:\n{done.stderr}")
    return done.stdout


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", type=pathlib.Path, default=[ROOT / "scenes" / f"{name}.pbrt" for name in SCENES])
    options.add_argument("--seconds", type=float, default=10)
    options.add_argument("--reference-seconds", type=float, default=200)
    options.add_argument("--reference-integrator", default="vcm")
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--common", default="--resolution 192x192", help="options of every render")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    Report.add_to(options)
    o = options.parse_args()
    columns = {f"{figure}: {integrator}": form for figure, form in FIGURES.items() for integrator in INTEGRATORS}
    add = Report(o.json).table("light paths", {"scene": None, **columns})
    with tempfile.TemporaryDirectory() as folder:
        reference, image = pathlib.Path(folder) / "reference.exr", pathlib.Path(folder) / "image.exr"

        def render(scene, integrator, seconds, seed, file):
            run(o.program, "render", scene, "--integrator", integrator, "--spp", 1 << 20, "--time-limit", seconds, "--seed", seed, "-o", file, *o.common.split())

        def compare(scene, integrator, seed):
            render(scene, integrator, o.seconds, seed, image)
            found = json.loads(run(o.program, "compare", image, reference, "--json"))
            return found["relativeMse"], found["flip"], sum(found["mean"]) / sum(found["referenceMean"])

        for scene in o.scenes:
            for integrator in INTEGRATORS:   # kernels are compiled before time counts
                render(scene, integrator, 0.1, 1, image)
            render(scene, o.reference_integrator, o.reference_seconds, 1_000_003, reference)
            rounds = [[compare(scene, integrator, 17 * r + 1) for integrator in INTEGRATORS] for r in range(o.rounds)]
            add(scene.stem, *(statistics.median(r[i][k] for r in rounds) for k in range(len(FIGURES)) for i in range(len(INTEGRATORS))))


if __name__ == "__main__":
    main()
