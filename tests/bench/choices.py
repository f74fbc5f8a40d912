#!/usr/bin/env python3
"""What a choice of options is worth in error per second, on a set of scenes.

    tests/bench/choices.py SCENE ... --options "--roulette-depth 1" "--roulette-depth 5" [--common "--resolution 256x256"] [--samples 64] [--repeats 4] [--rounds 2]
                           [--reference-samples 1024] [--references FOLDER] [--json FILE]

Runs `eikonal bench SCENE --efficiency` with each set of options by turns. Prints relMSE (the variance between seeds, relative to a render of --reference-samples samples
with the common options) of all pixels and of all but the worst thousandth, seconds, and the efficiency 1 / (relMSE x seconds) over that of the first set, without the
outliers, which a few seeds meet by chance: medians over the rounds. References stay in FOLDER for the next run, or are forgotten.
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


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"choices: {' '.join(map(str, command))} failed:\n{done.stderr}")


def render_reference(program, scene, options, samples, folder):
    """An image that has converged, rendered unless it is there."""
    name = "-".join([*scene.resolve().parts[-2:], *options.split(), str(samples)]).replace("/", "_")
    image = folder / f"{name}.exr"
    if not image.exists():
        run([program, "render", scene, "-o", image, "--seed", 1_000_003, "--spp", samples, *options.split()])
    return image


def bench(program, scene, reference, options, samples, repeats):
    """relMSE without outliers, seconds, and relMSE of one set of options."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bench.json"
        run([program, "bench", scene, "--efficiency", "--reference", reference, "--spp", samples, "--repeats", repeats, "--json", file, *options.split()])
        figures = json.loads(file.read_text())
    return figures["relativeVarianceWithoutOutliers"], figures["renderSeconds"], figures["relativeVariance"]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="+", type=pathlib.Path)
    options.add_argument("--options", nargs="+", required=True, help="sets of options of `eikonal bench`; an empty one: none")
    options.add_argument("--common", default="", help="options of every set, and of the reference")
    options.add_argument("--reference-samples", type=int, default=1024)
    options.add_argument("--references", type=pathlib.Path, help="folder to keep references in")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--repeats", type=int, default=4)
    options.add_argument("--rounds", type=int, default=2)
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("choices", {"scene": None, "options": None, "relMSE": ".3g", "without outliers": ".3g", "seconds": ".2f", "efficiency, the first = 1": ".2f"})
    with tempfile.TemporaryDirectory() as temporary:
        folder = o.references or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for scene in o.scenes:
            reference = render_reference(o.program, scene, o.common, o.reference_samples, folder)
            rounds = [[bench(o.program, scene, reference, f"{o.common} {chosen}", o.samples, o.repeats) for chosen in o.options] for _ in range(o.rounds)]
            for i, chosen in enumerate(o.options):
                ratio = statistics.median((r[0][0] * r[0][1]) / (r[i][0] * r[i][1]) for r in rounds)
                add(f"{scene.parent.name}/{scene.name}", chosen or "default", *(statistics.median(r[i][k] for r in rounds) for k in (2, 0, 1)), ratio)


if __name__ == "__main__":
    main()
