#!/usr/bin/env python3
"""Compares the error of images at equal samples between two versions of the kernels: whether a change of the random numbers loses on real scenes.

    tests/bench/kernel_errors.py coffee=FILE.pbrt --kernels FOLDER --samples 32 --seeds 40 --size 128x128 --json OUT.json

FOLDER holds the other version's kernels/ and include/; their layouts must be those that the program knows. The relative squared error of a seed is the mean,
over the pixels but the noisiest of 500, of its squared distance from the version's mean over seeds, times n / (n - 1), over m^2 + (mean of m / 10)^2: m is
the pixel's mean over everything. The column "this / other" has the ratio of its means over seeds, and the standard error of that, from the scatter between
seeds. Versions render by turns. Needs numpy.
"""

import argparse
import pathlib
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "points"), str(HERE)]
from points import render_with
from report import Report

ROOT = HERE.parents[1]


def render(o, kernels, scene, seed, image):
    return render_with(o.program, kernels, scene, image, "--spp", o.samples, "--seed", seed, "--resolution", o.size)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="+", metavar="NAME=FILE")
    options.add_argument("--kernels", type=pathlib.Path, required=True, help="the other version's folder")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--samples", type=int, default=32)
    options.add_argument("--seeds", type=int, default=32)
    options.add_argument("--size", default="96x96")
    Report.add_to(options)
    o = options.parse_args()
    o.program = o.program.resolve()
    add = Report(o.json).table("error by kernels", {"scene": None, "samples": None, "seeds": None, "other, relMSE": ".3g", "this / other": ".3f", "+-": ".3f"})
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder) / "image.pfm"
        for word in o.scenes:
            title, _, scene = word.partition("=")
            versions = (o.kernels.resolve(), ROOT)
            turns = [[render(o, kernels, scene, seed, image) for kernels in versions] for seed in range(1, o.seeds + 1)]
            images = np.array(turns).swapaxes(0, 1)
            mean = images.mean(axis=(0, 1))
            weight = 1 / (mean**2 + (mean.mean() / 10) ** 2)
            noise = images.var(axis=1, ddof=1).sum(axis=0) * weight
            kept = noise <= np.quantile(noise, 0.998)
            other, this = (((each - each.mean(axis=0)) ** 2 * weight)[:, kept].mean(axis=1) * o.seeds / (o.seeds - 1) for each in images)
            ratio = this.mean() / other.mean()
            scatter = np.hypot(*(each.std(ddof=1) / each.mean() for each in (this, other))) / o.seeds**0.5
            add(title, o.samples, o.seeds, other.mean(), ratio, ratio * scatter)


if __name__ == "__main__":
    main()
