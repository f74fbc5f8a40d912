#!/usr/bin/env python3
"""Measures how well samplers spread their points: the error of images at equal numbers of samples, for the shipped samplers and for others.

    tests/bench/points.py --json tests/bench/results/points.json               our own scenes
    tests/bench/points.py grey-coffee=/tmp/coffee/scene.pbrt --ways paddedsobol,sobol --seeds 4

The relative mean squared error is the mean over the pixels, less the worst of 500, of the variance between seeds over m^2 + (mean of m / 10)^2: m is a
pixel's mean over all that is rendered of the scene. Samplers here have no bias, so no reference is needed, and none adds noise of its own. (The
greatest relative distance between the means of two ways' images is shown, as a check of that.) "Blurred" is the same after a Gaussian of 1.5
pixels: what a filter, a denoiser or an eye makes of the error. Errors are relative to those of the first way, except the first column's (times 1000).
All ways are in one build of the kernels (tests/bench/points/candidates.clh), which is no measure of their speed. Needs numpy.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
PARTS = HERE / "points"
sys.path[:0] = [str(PARTS), str(HERE), str(HERE.parent)]
from blur import blur
from report import Report
from scenes import OWN

ROOT = pathlib.Path(__file__).resolve().parents[2]
WAYS = ["independent", "paddedsobol", "paddedzsobol", "sobol", "zsobol", "halton", "faure", "lattice"]   # as `candidate` in candidates.clh
OPTION_SHIFT = 20


def replaced(text, old, new):
    if old not in text:
        sys.exit(f"the kernels have changed: there is no \"{old}\" for the candidates to replace")
    return text.replace(old, new)


def build_kernels(folder):
    """The kernels, with the candidates in place of the samplers."""
    for part in ("kernels", "include"):
        shutil.copytree(ROOT / part, folder / part)
    random = folder / "kernels" / "math" / "random.clh"
    text = random.read_text()
    for name in ("float sample_1d(", "vec2 sample_2d("):
        text = replaced(text, f"FN {name}", f"FN {name.replace('sample', 'shipped_sample')}")
    stream = "/* A stream of independent numbers"
    random.write_text(replaced(text, stream, (PARTS / "candidates.clh").read_text() + stream))
    camera = folder / "kernels" / "camera" / "camera.clh"
    item = "/* weight: of the sample in its pixel"
    text = replaced(camera.read_text(), item, (PARTS / "candidate_place.clh").read_text() + item)
    camera.write_text(replaced(text, "place = place_in_sequence(", "place = candidate_place("))


def read_pfm(file):
    """Luminance of the pixels."""
    with open(file, "rb") as stream:
        kind, (width, height), scale = stream.readline().strip(), map(int, stream.readline().split()), float(stream.readline())
        values = np.frombuffer(stream.read(), "<f4" if scale < 0 else ">f4").reshape(height, width, 3 if kind == b"PF" else 1)
    return values.astype(float) @ ([0.2126, 0.7152, 0.0722] if kind == b"PF" else [1])


def render_with(program, kernels, scene, image, *options):
    """Luminance of the pixels that the program renders with the kernels of a folder."""
    command = [program, "render", scene, "--quiet", *options, "-o", image]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, env={**os.environ, "EIKONAL_KERNELS": str(kernels)})
    return read_pfm(image)


def render(o, folder, scene, way, samples, seed):
    return render_with(o.program, folder, scene, folder / "image.pfm", "--sampler", "zsobol", "--spp", samples, "--seed",
                       (WAYS.index(way) << OPTION_SHIFT) + seed, "--resolution", f"{o.size}x{o.size}", "--max-depth", 5)


def relative_variance(images, mean):
    errors = np.sort((np.var(images, axis=0, ddof=1) / (mean**2 + (mean.mean() / 10) ** 2)).ravel())
    return errors[: len(errors) - len(errors) // 500].mean()


def geometric_mean(values):
    return float(np.exp(np.mean(np.log(values))))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", help="NAME=FILE, or one of our own: " + ", ".join(OWN))
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--samples", default="16,64,256")
    options.add_argument("--ways", default=",".join(WAYS), help="of " + ", ".join(WAYS))
    options.add_argument("--seeds", type=int, default=4)
    options.add_argument("--size", type=int, default=96)
    Report.add_to(options)
    o = options.parse_args()
    o.program = o.program.resolve()
    counts, ways = [int(n) for n in o.samples.split(",")], o.ways.split(",")

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        build_kernels(folder)
        scenes = {"box": ROOT / "scenes" / "cornell-box.pbrt"} if not o.scenes else {}
        for word in o.scenes or OWN:
            title, _, file = word.partition("=")
            if not file:
                file = folder / f"{title}.pbrt"
                file.write_text(OWN[title]())
            scenes[title] = pathlib.Path(file).resolve()
        columns = {"scene": None, "samples": None, f"{ways[0]} x 1000": ".3g"}
        columns |= {f"{way}{after}": ".3f" for way in ways[1:] for after in ("", ", blurred")} | {"means differ": ".4f"}
        add = Report(o.json).table("error of samplers", columns)
        ratios = {n: [] for n in counts}
        for title, scene in scenes.items():
            images = {(n, way): [render(o, folder, scene, way, n, seed) for seed in range(1, o.seeds + 1)] for n in counts for way in ways}
            mean = sum(n * sum(each) for (n, _), each in images.items()) / sum(n * len(each) for (n, _), each in images.items())
            for n in counts:
                errors = [[relative_variance([change(i) for i in images[n, way]], mean) for change in (np.asarray, blur)] for way in ways]
                brightness = [np.mean(images[n, way]) for way in ways]
                ratios[n].append([e / first for each in errors[1:] for e, first in zip(each, errors[0])])
                add(title, n, 1000 * errors[0][0], *ratios[n][-1], max(brightness) / min(brightness) - 1)
        for n in counts:
            add("geometric mean", n, None, *(geometric_mean(column) for column in zip(*ratios[n])), None)


if __name__ == "__main__":
    main()
