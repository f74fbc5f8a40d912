#!/usr/bin/env python3
"""Error after the same time of rendering on scenes whose light is hard to find: our integrators, and those of other renderers.

    tests/bench/hard_light.py [--pbrt PBRT] [--shared ../shared/scenes] [--venv VENV] [--only ring,coffee] [--seconds 6] [--rounds 2] [--json FILE]

PBRT is pbrt-v4's program. --shared: the folder of public scenes, which adds five. --venv: a virtual environment with numpy, and with pyluxcore and bpy or one of
them, for LuxCore and Cycles (hard_light_peers.py), which adds a Cornell box with a ball of glass. The samples that fill the time are found by short renders; then all
methods take turns, with other seeds in each round. Medians over the rounds; efficiency is 1 / (relMSE x seconds).

Two methods make the reference, one of ours and one of pbrt-v4's, each in two halves with other seeds. Both are unbiased, or nearly, and share no code: their means
tell whether both programs compute the same image. The halves tell the noise of each, and the reference is the mean of both, weighted by the other's noise.
Table "references": how far the mean of pbrt-v4's is from ours and its standard error; the relMSE of the one against the other; that of the reference, by the halves.
A method's relMSE includes it. Prints a row for each scene, and for each method.
"""

import argparse
import array
import json
import math
import os
import pathlib
import statistics
import sys
import tempfile

from hard_light_renderers import Eikonal, Pbrt, Scene, first_radius, run, samples_for
from paths import ROOT
from report import Report

SHARED = ["veach-bidir", "volumetric-caustic", "staircase2", "classroom", "coffee"]
SCENES = ["glass-ball", "water-pool", "lamp-in-glass", "ring", "door-ajar", *SHARED]
REFERENCES = {"glass-ball": ("vcm", "pbrt-v4 sppm"), "water-pool": ("vcm", "pbrt-v4 sppm")}   # what is seen in glass is for merging
REFERENCE, WITH_MEDIA = ("vcm", "pbrt-v4 bdpt"), ("volpath", "pbrt-v4 bdpt")
OURS = {"volpath": ["volpath"], "guided": ["volpath", "--guiding", "on"], "bdpt": ["bdpt"], "sppm": ["sppm"], "vcm": ["vcm"]}
WITHOUT_LIGHT_PATHS = ["volpath", "guided"]   # what differs in a scene with media
PBRT_RADIUS = 2   # of sppm, over our first radius: what was best for it
COLUMNS = {"scene": None, "method": None, "samples": "d", "seconds": ".2f", "relMSE": ".3g", "FLIP": ".3f", "efficiency": ".3g", "mean off, %": "+.2f"}
REFERENCE_COLUMNS = {"scene": None, "ours": None, "theirs": None, "theirs off, %": "+.2f", "+-": ".2f", "relMSE of theirs against ours": ".3g", "relMSE of the reference": ".2g"}


def read_pfm(path):
    """The values of an image in a PFM file, as they lie there, and its header."""
    data = path.read_bytes()
    begin = 0
    for _ in range(3):
        begin = data.index(b"\n", begin) + 1
    values = array.array("f", data[begin:])
    if (float(data[:begin].split()[-1]) < 0) != (sys.byteorder == "little"):
        values.byteswap()
    return values, data[:begin]


def mean_square(values, reference):
    """The mean of the squares of values relative to those of the reference: that of relMSE."""
    mean = [sum(reference[c::3]) * 3 / len(reference) for c in range(3)]
    return sum(v * v / (r * r + 0.01 * mean[i % 3] ** 2) for i, (v, r) in enumerate(zip(values, reference))) / len(values)


def blend(a, b, share):
    """share of a and the rest of b."""
    return [share * x + (1 - share) * y for x, y in zip(a, b)]


class References:
    """Renders the reference of a scene: the file, and the figures of its row."""

    def __init__(self, seconds, folder):
        self.seconds, self.folder = seconds, folder

    def halves(self, scene, renderer, samples):
        """The mean of two renders, half of their difference, which is as large as the noise of the mean, and the header of their files."""
        files = [self.folder / f"half-{i}.pfm" for i in range(2)]
        for i, file in enumerate(files):
            renderer.render(scene, samples, 1001 + i, file)
        (first, header), (second, _) = map(read_pfm, files)
        return blend(first, second, 0.5), [(x - y) / 2 for x, y in zip(first, second)], header

    def make(self, scene, methods, samples, names):
        means, noises, header = [], [], None
        for name in names:
            mean, noise, header = self.halves(scene, methods[name], max(1, round(samples[name] * self.seconds / 2)))
            means.append(mean)
            noises.append(noise)
        if len(names) == 1:
            return self.write(means[0], header), (None, None, None, mean_square(noises[0], means[0]))
        both = blend(*means, 0.5)
        errors = [max(mean_square(noise, both), 1e-30) for noise in noises]
        share = errors[1] / (errors[0] + errors[1])
        reference = blend(*means, share)
        sums = [math.fsum(mean) for mean in means]
        off = 100 * (sums[1] / sums[0] - 1)
        deviation = 100 * math.hypot(*(math.fsum(noise) / total for noise, total in zip(noises, sums)))
        apart = mean_square([x - y for x, y in zip(*means)], means[0])
        return self.write(reference, header), (off, deviation, apart, mean_square(blend(*noises, share), reference))

    def write(self, values, header):
        file = self.folder / "reference.pfm"
        words = header.split()
        file.write_bytes(b"PF\n%s %s\n%s\n" % (words[1], words[2], b"-1" if sys.byteorder == "little" else b"1") + array.array("f", values).tobytes())
        return file


def methods_of(o, scene, folder):
    """What renders the scene, by name."""
    found = {name: Eikonal(o.program, o.threads, "--integrator", *options) for name, options in OURS.items() if not scene.media or name in WITHOUT_LIGHT_PATHS}
    if o.pbrt:
        radius = None if scene.media else first_radius(o.program, scene, folder / "radius.pfm")
        found |= {f"pbrt-v4 {name}": Pbrt(o.pbrt, o.threads, name, folder / scene.name) for name in ("volpath", "bdpt", "mlt")}
        if radius:
            found["pbrt-v4 sppm"] = Pbrt(o.pbrt, o.threads, "sppm", folder / scene.name, PBRT_RADIUS * radius)
    return found


def measure(o, scene, methods, folder, references, add):
    image = folder / "image.pfm"
    for renderer in methods.values():   # kernels are compiled, files are in memory
        renderer.render(scene, 1, 1, image)
    samples = {name: samples_for(renderer, scene, o.seconds, image) for name, renderer in methods.items()}
    names = [name for name in REFERENCES.get(scene.name, WITH_MEDIA if scene.media else REFERENCE) if name in methods]
    reference, figures = References(o.reference_seconds, folder).make(scene, methods, {name: samples[name] / o.seconds for name in names}, names)
    references.append((scene.name, names[0], names[1] if len(names) > 1 else None, *figures))
    rounds = {name: [] for name in methods}
    for turn in range(o.rounds):
        for name, renderer in methods.items():
            seconds = renderer.render(scene, samples[name], 2 + turn, image)
            found = json.loads(run(o.program, "compare", image, reference, "--json"))
            rounds[name].append((seconds, found["relativeMse"], found["flip"], 100 * (sum(found["mean"]) / sum(found["referenceMean"]) - 1)))
    for name, found in rounds.items():
        seconds, error, flip, off = (statistics.median(values) for values in zip(*found))
        add(scene.name, name, samples[name], seconds, error, flip, 1 / (error * seconds), off)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--pbrt", type=pathlib.Path)
    options.add_argument("--shared", type=pathlib.Path)
    options.add_argument("--only", type=lambda text: text.split(","), default=SCENES, help=f"of {', '.join(SCENES)}")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--seconds", type=float, default=6)
    options.add_argument("--reference-seconds", type=float, default=60, help="of each of two renders")
    options.add_argument("--rounds", type=int, default=2)
    options.add_argument("--width", type=int, default=128, help="pixels")
    options.add_argument("--threads", type=int, default=os.cpu_count())
    Report.add_to(options)
    o = options.parse_args()
    report = Report(o.json)
    add, references = report.table("efficiency", COLUMNS), []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in o.only:
            if scene not in SHARED or o.shared:
                path = o.shared / scene / "scene-v4.pbrt" if scene in SHARED else ROOT / "scenes" / f"{scene}.pbrt"
                scene = Scene(scene, path, o.width, o.program)
                measure(o, scene, methods_of(o, scene, folder), folder, references, add)
    add_reference = report.table("references", REFERENCE_COLUMNS)
    for row in references:
        add_reference(*row)


if __name__ == "__main__":
    main()
