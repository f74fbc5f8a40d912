#!/usr/bin/env python3
"""What path guiding gains: the error and the processor time of renders with and without --guiding, against a render of many samples.

    tests/bench/guiding.py [SCENE ...]

Prints a row for each scene: relMSE without the worst thousandth of the pixels, mean of the seeds; processor seconds of the whole program, median;
efficiency, 1 / (relMSE x seconds), as a ratio. Runs take turns. Needs python3-openimageio. Takes about 4 minutes for a scene.
"""
import argparse
import pathlib
import resource
import statistics
import subprocess
import tempfile

import numpy
import OpenImageIO

from paths import ROOT

CASES = {"off": ["--guiding", "off"], "on": ["--guiding", "on"]}


def seconds_of(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(command, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def gray(path):
    return numpy.asarray(OpenImageIO.ImageBuf(str(path)).get_pixels(OpenImageIO.FLOAT))[..., :3].mean(-1)


def relative_error(image, reference):
    errors = numpy.sort(((image - reference) ** 2 / (reference ** 2 + (0.01 * reference.mean()) ** 2)).ravel())
    return errors[:int(0.999 * errors.size)].mean()


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", type=pathlib.Path, default=[ROOT / "scenes" / "door-ajar.pbrt"])
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--resolution", default="192x128")
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--reference", type=int, default=1024, help="samples of the reference")
    options.add_argument("--seeds", type=int, default=4)
    o = options.parse_args()
    print("| scene | relMSE off | on | seconds off | on | efficiency, on / off |\n|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as name:
        image = pathlib.Path(name) / "image.exr"
        for scene in o.scenes:
            def render(samples, seed, options):
                return seconds_of([o.program, "render", scene, "--resolution", o.resolution, "--spp", str(samples), "--seed", str(seed), *options,
                                   "-o", image, "--quiet"])
            render(o.reference, 77, CASES["on"])
            reference = gray(image)
            errors, seconds = {case: [] for case in CASES}, {case: [] for case in CASES}
            for seed in range(o.seeds + 1):   # the first compiles kernels
                for case, wanted in CASES.items():
                    seconds[case].append(render(o.samples, seed, wanted))
                    errors[case].append(relative_error(gray(image), reference))
            error = {case: statistics.mean(errors[case][1:]) for case in CASES}
            time = {case: statistics.median(seconds[case][1:]) for case in CASES}
            ratio = error["off"] * time["off"] / (error["on"] * time["on"])
            name_of = scene.stem if scene.stem != "scene-v4" else scene.parent.name
            print(f"| {name_of} | {error['off']:.3g} | {error['on']:.3g} | {time['off']:.2f} | {time['on']:.2f} | {ratio:.2f} |", flush=True)


if __name__ == "__main__":
    main()
