#!/usr/bin/python3
"""Adaptive sampling (--target-error) against uniform sampling: efficiency and bias, as the tables of docs/adaptive.md.

    tests/accuracy/adaptive.py                         all scenes of ../shared/scenes that are listed below
    tests/accuracy/adaptive.py --scenes coffee --seeds 4 --print

For each scene and seed an adaptive render, and one with the same samples everywhere: as many as the adaptive one took on average, rounded. By
turns. Error: relMSE, against the mean of --reference-samples a pixel of other seeds. Efficiency: 1 / (relMSE x seconds of
rendering), medians over the seeds: a mean would be that of the one seed that met the brightest path. Bias: the mean of adaptive renders less the reference, of the image and of blocks of 16 x 16 pixels; beside it
the same for uniform renders, which have none, so that what noise does to such a figure, also that of the reference, can be seen.
"""

import argparse
import pathlib
import re
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio

import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "adaptive.md"
BEGIN, END = "<!-- table: made by tests/accuracy/adaptive.py -->\n", "<!-- end of the table -->\n"
# Scene, resolution, target error.
SCENES = {
    "peer-cornell": ("scene.pbrt", "320x320", 0.06),
    "veach-mis": ("scene-v4.pbrt", "384x216", 0.12),
    "coffee": ("scene-v4.pbrt", "224x280", 0.12),
    "staircase2": ("scene-v4.pbrt", "256x256", 0.25),
    "classroom": ("scene-v4.pbrt", "320x180", 0.25),
    "veach-bidir": ("scene-v4.pbrt", "256x256", 0.3),
}
BLOCK = 16


def render(o, scene, samples, seed, target=None):
    """Seconds, the mean of samples a pixel, and the image."""
    file, resolution, _ = SCENES[scene]
    image = o.renders / f"{scene}-{'adaptive' if target else 'uniform'}.exr"
    command = [o.program, "render", o.shared / scene / file, "--resolution", resolution, "--spp", samples, "--seed", seed, "--stats", "-o", image]
    if target:
        command += ["--target-error", target]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    seconds = re.search(r"^  render +([0-9.]+) s", done.stdout, re.MULTILINE)
    if done.returncode or not seconds:
        sys.exit(f"adaptive.py: {' '.join(map(str, command))} failed:\n{done.stderr}")
    mean = float(re.search(r"fewest, ([0-9.]+) mean", done.stdout)[1])
    return float(seconds[1]), mean, oiio.ImageBuf(str(image)).get_pixels(oiio.FLOAT)[:, :, :3].astype(float)


def relative_error(image, reference):
    return ((image - reference) ** 2 / (reference ** 2 + 0.01)).mean()


def luminance_blocks(image):
    luminance = image @ np.array([0.2126, 0.7152, 0.0722])
    height, width = luminance.shape[0] // BLOCK * BLOCK, luminance.shape[1] // BLOCK * BLOCK
    return luminance[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).mean(axis=(1, 3))


def bias(images, reference):
    """Of the image, with its standard error, and of blocks; relative."""
    truth = luminance_blocks(reference)
    blocks = np.array([luminance_blocks(i) for i in images])
    count = len(images)
    whole = blocks.mean(axis=(1, 2))
    error = whole.std(ddof=1) / count ** 0.5
    deviation = blocks.mean(axis=0) - truth
    sigma = blocks.std(axis=0, ddof=1) / count ** 0.5
    lit = sigma > 0
    return (f"{100 * (whole.mean() / truth.mean() - 1):+.2f} % +- {100 * error / truth.mean():.2f} % | "
            f"{100 * (deviation[lit] / truth[lit]).mean():+.2f} % | {100 * np.median(deviation[lit] / truth[lit]):+.2f} %")


def row(o, scene):
    target = o.target or SCENES[scene][2]
    reference = np.mean([render(o, scene, o.reference_samples, 1000 + i)[2] for i in range(o.references)], axis=0)
    _, mean, _ = render(o, scene, o.most, 999, target)
    samples = max(round(mean), 1)
    figures = {"adaptive": [], "uniform": []}
    images = {"adaptive": [], "uniform": []}
    for seed in range(o.seeds):
        for kind in figures:
            seconds, taken, image = render(o, scene, o.most if kind == "adaptive" else samples, seed, target if kind == "adaptive" else None)
            figures[kind].append((seconds, taken, relative_error(image, reference)))
            images[kind].append(image)
    (a_time, a_samples, a_error), (u_time, _, u_error) = (np.median(figures[k], axis=0) for k in ("adaptive", "uniform"))
    a_path, u_path = a_time / a_samples, u_time / samples
    efficiency = (f"| {scene} | {target} | {a_error ** 0.5:.3f} | {u_error ** 0.5:.3f} | {a_samples:.1f} | {a_path / u_path:.3f} | "
                  f"{u_error * samples / (a_error * a_samples):.2f} | {u_error * u_time / (a_error * a_time):.2f} |")
    return efficiency, [f"| {scene} | {kind} | {bias(images[kind], reference)} |" for kind in images]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--shared", type=pathlib.Path, default=ROOT.parent / "shared" / "scenes")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--scenes", nargs="*", default=list(SCENES))
    options.add_argument("--target", type=float, help="instead of each scene's own")
    options.add_argument("--most", type=int, default=4096, help="samples that a pixel gets at most")
    options.add_argument("--seeds", type=int, default=6)
    options.add_argument("--reference-samples", type=int, default=1024)
    options.add_argument("--references", type=int, default=2)
    options.add_argument("--renders", type=pathlib.Path, default=ROOT / "build" / "accuracy-adaptive", help="where images go")
    options.add_argument("--print", action="store_true", help="print the tables, write nothing")
    o = options.parse_args()
    o.renders.mkdir(parents=True, exist_ok=True)
    efficiencies = ["| scene | target | error reached | error of uniform | samples a pixel | time a path / uniform's | gain at equal samples | gain in efficiency |",
                    "|---|--:|--:|--:|--:|--:|--:|--:|"]
    biases = ["| scene | sampling | image: mean over truth - 1 | blocks: mean | blocks: median |", "|---|---|--:|--:|--:|"]
    for scene in o.scenes:
        efficiency, lines = row(o, scene)
        efficiencies.append(efficiency)
        biases += lines
        print(efficiency, *lines, sep="\n", file=sys.stderr, flush=True)
    text = "\n".join(efficiencies) + "\n\n" + "\n".join(biases) + "\n"
    page.put(PAGE, BEGIN, text, END, only_print=o.print)


if __name__ == "__main__":
    main()
