#!/usr/bin/env python3
"""Error after the same time of rendering on scenes whose light is hard to find: our integrators, and those of other renderers.

    tests/bench/hard_light.py [--pbrt PBRT] [--shared ../shared/scenes] [--only ring,coffee] [--json FILE]
    VENV/bin/python tests/bench/hard_light.py --venv VENV --only glass-cornell ...

PBRT is pbrt-v4's program. --shared: the folder of public scenes, five of which take part. --venv: a virtual environment with numpy, and with pyluxcore, bpy or
both, for LuxCore and Cycles, which render the scene glass-cornell (hard_light_peers.py). Short renders tell how many samples fill the time; then all methods take
turns, with other seeds in each round. Medians over the rounds; efficiency is 1 / (relMSE x seconds), and "trimmed" the
relMSE without the worst thousandth of the pixels. --add keeps what FILE
has of other scenes. hard_light_page.py writes the tables of docs/hard-light.md from it.

Two methods make the reference, one of ours and one of pbrt-v4's, each in two halves with other seeds. They share no code, so their means tell whether both
programs compute the same image. The halves tell the noise of each, and the reference is the mean of both, weighted by the noise of the other one.
The table "references" has how far the mean of theirs is from ours, with its standard error by the halves; the relMSE of theirs against ours; and that of the
reference, by the halves, which the relMSE of each method includes.
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
PEERS = "glass-cornell"
SCENES = ["glass-ball", "water-pool", "lamp-in-glass", "ring", "door-ajar", *SHARED, PEERS]
MERGED, CONNECTED, FROM_CAMERA = ("vcm", "pbrt-v4 sppm"), ("bdpt", "pbrt-v4 bdpt"), ("volpath", "pbrt-v4 volpath")
REFERENCES = {   # by what finds all of the light with the least noise
    "glass-ball": MERGED, "water-pool": MERGED, "lamp-in-glass": ("vcm", "pbrt-v4 bdpt"), "ring": ("vcm", "pbrt-v4 bdpt"), "door-ajar": CONNECTED,
    "veach-bidir": CONNECTED, "volumetric-caustic": CONNECTED, "staircase2": FROM_CAMERA, "classroom": ("bdpt", "pbrt-v4 volpath"),
    "coffee": ("bdpt", "pbrt-v4 volpath"), PEERS: CONNECTED}
OURS = {"volpath": ["volpath"], "guided": ["volpath", "--guiding", "on"], "bdpt": ["bdpt"], "sppm": ["sppm"], "vcm": ["vcm"]}
COLUMNS = {"scene": None, "method": None, "samples": "d", "seconds": ".2f", "relMSE": ".3g", "trimmed": ".3g", "FLIP": ".3f", "efficiency": ".3g",
           "mean off, %": "+.2f"}
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
        lower = [min(a, b) for a, b in zip(*means)]   # which has no fireflies, beside which they would look small
        errors = [max(mean_square(noise, lower), 1e-30) for noise in noises]
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


def path_of(o, name, folder):
    if name == PEERS:
        import hard_light_peers
        return hard_light_peers.write(folder / name, o.width)
    return o.shared / name / "scene-v4.pbrt" if name in SHARED else ROOT / "scenes" / f"{name}.pbrt"


def methods_of(o, scene, folder):
    """What renders the scene, by name."""
    found = {name: Eikonal(o.program, o.threads, "--integrator", *options) for name, options in OURS.items()}
    if o.pbrt:
        radius = None if scene.media else first_radius(o.program, scene, folder / "radius.pfm")
        found |= {f"pbrt-v4 {name}": Pbrt(o.pbrt, o.threads, name, folder / f"pbrt-{scene.name}") for name in ("volpath", "bdpt", "mlt")}
        if radius:
            found["pbrt-v4 sppm"] = Pbrt(o.pbrt, o.threads, "sppm", folder / f"pbrt-{scene.name}", radius)
    if scene.name == PEERS:
        import hard_light_peers
        found |= hard_light_peers.renderers(o.venv, o.threads, folder / PEERS)
    return found


def measure(o, scene, methods, folder, references, add):
    images = {name: folder / f"image.{getattr(renderer, 'suffix', 'pfm')}" for name, renderer in methods.items()}
    for name, renderer in methods.items():   # kernels are compiled, files are in memory
        renderer.render(scene, 1, 1, images[name])
    samples = {name: samples_for(renderer, scene, o.seconds, images[name]) for name, renderer in methods.items()}
    names = [name for name in REFERENCES[scene.name] if name in methods]
    reference, figures = References(o.reference_seconds, folder).make(scene, methods, {name: samples[name] / o.seconds for name in names}, names)
    references.append((scene.name, names[0], names[1] if len(names) > 1 else None, *figures))
    rounds = {name: [] for name in methods}
    for turn in range(o.rounds):
        for name, renderer in methods.items():
            seconds = renderer.render(scene, samples[name], 2 + turn, images[name])
            found = json.loads(run(o.program, "compare", images[name], reference, "--json"))
            rounds[name].append((seconds, found["relativeMse"], found["trimmedRelativeMse"], found["flip"], 100 * (sum(found["mean"]) / sum(found["referenceMean"]) - 1)))
    for name, found in rounds.items():
        seconds, error, trimmed, flip, off = (statistics.median(values) for values in zip(*found))
        add(scene.name, name, samples[name], seconds, error, trimmed, flip, 1 / (error * seconds), off)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--pbrt", type=pathlib.Path)
    options.add_argument("--shared", type=pathlib.Path)
    options.add_argument("--venv", type=pathlib.Path)
    options.add_argument("--only", type=lambda text: text.split(","), help=f"of {', '.join(SCENES)}")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--seconds", type=float, default=6)
    options.add_argument("--reference-seconds", type=float, default=45, help="of each of two renders")
    options.add_argument("--rounds", type=int, default=2)
    options.add_argument("--width", type=int, default=128, help="pixels")
    options.add_argument("--threads", type=int, default=os.cpu_count())
    Report.add_to(options)
    options.add_argument("--add", action="store_true", help="keep the figures of other scenes in the file of --json")
    o = options.parse_args()
    here = [name for name in SCENES if (o.shared if name in SHARED else o.venv if name == PEERS else True)]
    o.only = o.only or here
    for name in set(o.only) - set(here):
        options.error(f"scene {name} needs --venv" if name == PEERS else f"scene {name} needs --shared" if name in SHARED else f"no scene {name}; there are {', '.join(SCENES)}")
    kept = json.loads(o.json.read_text())["tables"] if o.add and o.json.exists() else {}
    kept = {table: [row for row in rows if row["scene"] not in o.only] for table, rows in kept.items()}
    report = Report(o.json)
    report.kept["settings"] = {key: getattr(o, key) for key in ("seconds", "reference_seconds", "rounds", "width", "threads")} | {"load": os.getloadavg()[0]}
    add, references = report.table("efficiency", COLUMNS), [row.values() for row in kept.get("references", [])]
    for row in kept.get("efficiency", []):
        add(*row.values())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in (Scene(name, path_of(o, name, folder), o.width, o.program) for name in o.only):
            measure(o, scene, methods_of(o, scene, folder), folder, references, add)
    add_reference = report.table("references", REFERENCE_COLUMNS)
    for row in references:
        add_reference(*row)


if __name__ == "__main__":
    main()
