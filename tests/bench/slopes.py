#!/usr/bin/env python3
"""Measures how fast the error of smooth pixels falls with the number of samples: the table of slopes in docs/sampling.md.

    tests/bench/slopes.py --json tests/bench/results/slopes.json
    tests/bench/slopes.py --kernels before=/tmp/other-checkout --scenes lamp    against the kernels of another checkout, too

The error is the root of the mean, over 8 x 8 pixels, of the variance between seeds, over the mean. The slope is that of log(error) over log(samples), from
--from samples to the most: -0.5 for independent samples. With --kernels the program runs with each folder's kernels/ and include/. Needs numpy.
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
from scenes import SMOOTH

ROOT = HERE.parents[1]


def error_of(o, kernels, scene, samples, image):
    """Relative standard deviation of the pixels between seeds."""
    images = [render_with(o.program, kernels, scene, image, "--sampler", o.sampler, "--spp", samples, "--seed", seed) for seed in range(1, o.seeds + 1)]
    return float(np.sqrt(np.var(images, axis=0, ddof=1).mean()) / np.mean(images))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--scenes", default=",".join(SMOOTH), help="of " + ", ".join(SMOOTH))
    options.add_argument("--kernels", action="append", default=[], metavar="NAME=FOLDER", help="other kernels than those of this checkout")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--sampler", default="zsobol")
    options.add_argument("--samples", default="16,64,256,1024,4096,16384,65536")
    options.add_argument("--from", type=int, default=256, dest="start", metavar="SAMPLES", help="where the slope starts")
    options.add_argument("--seeds", type=int, default=4)
    Report.add_to(options)
    o = options.parse_args()
    o.program = o.program.resolve()
    counts = [int(n) for n in o.samples.split(",")]
    folders = {name: pathlib.Path(folder).resolve() for name, _, folder in (word.partition("=") for word in o.kernels)} | {"this": ROOT}

    add = Report(o.json).table("error of smooth pixels", {"scene": None, "kernels": None} | {f"{n}": ".2g" for n in counts} | {"slope": ".2f"})
    with tempfile.TemporaryDirectory() as name:
        for title in o.scenes.split(","):
            scene = pathlib.Path(name) / "scene.pbrt"
            scene.write_text(SMOOTH[title]())
            for which, kernels in folders.items():
                errors = [error_of(o, kernels, scene, n, pathlib.Path(name) / "image.pfm") for n in counts]
                tail = [(np.log(n), np.log(e)) for n, e in zip(counts, errors) if n >= o.start]
                add(title, which, *errors, np.polyfit(*zip(*tail), 1)[0])


if __name__ == "__main__":
    main()
