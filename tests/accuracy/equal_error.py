#!/usr/bin/env python3
"""Measures samplers and light samplers by efficiency, 1 / (relative mean squared error x time), and writes the table of docs/accuracy.md.

    tests/accuracy/equal_error.py --program build/eikonal                      the six scenes of ../shared if they are there, else scenes/
    tests/accuracy/equal_error.py --print scenes/cornell-box.pbrt              these scenes, and write nothing
    tests/accuracy/equal_error.py --before OLD/eikonal                         with a row for another build

The relative mean squared error is the mean over the pixels, less the worst thousandth of them, of (x - r)^2 / (r^2 + (mean of r / 10)^2): x is a pixel's
luminance, r that of a long render with another seed. "Blurred" is the same after a Gaussian of 1.5 pixels over both images: what a filter, a denoiser or an eye makes
of the error. Time is the processor time that --samples samples take beyond a render of one sample, the least of all seeds, since others use the machine, too:
loading and compiling do not count. All that is compared is rendered by turns, seed by seed; +- is the standard error over the seeds of the relative error.
Needs Debian's python3-openimageio.
"""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from blur import blur
import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "accuracy.md"
BEGIN, END = "<!-- table: made by tests/accuracy/equal_error.py -->\n", "<!-- end of the table of efficiency -->\n"
SHARED = ROOT.parent / "shared" / "scenes"
SIX = ["peer-cornell/scene", "veach-mis/scene-v4", "staircase2/scene-v4", "coffee/scene-v4", "classroom/scene-v4", "volumetric-caustic/scene-v4"]
OWN = ["cornell-box", "environment", "instances", "materials", "medium", "textures"]
WAYS = [(sampler, None) for sampler in ("independent", "sobol", "zsobol")] + [("zsobol", light) for light in ("uniform", "power", "bvh")]


def render(program, scene, image, samples, seed, size, sampler=None, light=None):
    """Luminance of the pixels, and processor seconds that it took."""
    command = [program, "render", scene, "--quiet", "--spp", samples, "--seed", seed, "--resolution", size, "-o", image]
    command += ["--sampler", sampler] if sampler else []
    command += ["--light-sampler", light] if light else []
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    pixels = oiio.ImageBuf(str(image))
    names = list(pixels.spec().channelnames)
    values = pixels.get_pixels().astype(float)
    return sum(weight * values[..., names.index(c)] for c, weight in zip("RGB", (0.2126, 0.7152, 0.0722))), seconds


def relative_error(image, reference):
    errors = np.sort(((image - reference) ** 2 / (reference**2 + (reference.mean() / 10) ** 2)).ravel())
    return errors[: len(errors) - len(errors) // 1000].mean()


def size_of(program, scene, height):
    """Of the scene's shape, so many pixels high."""
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder) / "image.exr"
        subprocess.run([str(program), "render", str(scene), "--quiet", "--spp", "1", "-o", str(image)], check=True, stdout=subprocess.DEVNULL)
        spec = oiio.ImageBuf(str(image)).spec()
        return f"{max(round(height * spec.full_width / spec.full_height), 1)}x{height}"


def measure(o, scene, image):
    """For each way: the errors of each seed, those after a blur, and processor seconds."""
    size = size_of(o.program, scene, o.height)
    ways = [(o.program, *way) for way in WAYS] + ([(o.before, None, None)] if o.before else [])
    start = [render(*way[:1], scene, image, 1, 1, size, *way[1:])[1] for way in ways]   # compiles, if need be
    start = [min(seconds, render(*way[:1], scene, image, 1, 1, size, *way[1:])[1]) for way, seconds in zip(ways, start)]
    reference = render(o.program, scene, image, o.reference_samples, 1000, size)[0]
    blurred = blur(reference)
    errors, after, times = ([[] for _ in ways] for _ in range(3))
    for seed in range(1, o.seeds + 1):
        for i, (program, *how) in enumerate(ways):
            pixels, seconds = render(program, scene, image, o.samples, seed, size, *how)
            errors[i].append(relative_error(pixels, reference))
            after[i].append(relative_error(blur(pixels), blurred))
            times[i].append(seconds)
    names = [sampler + (f", {light}" if light else "") for sampler, light in WAYS] + (["before"] if o.before else [])
    return [(name, e, a, max(min(t) - s, 1e-3)) for name, e, a, t, s in zip(names, errors, after, times, start)]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", type=pathlib.Path)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--before", type=pathlib.Path, help="another build of the program")
    options.add_argument("--samples", type=int, default=16)
    options.add_argument("--reference-samples", type=int, default=2048)
    options.add_argument("--seeds", type=int, default=4)
    options.add_argument("--height", type=int, default=96)
    options.add_argument("--print", action="store_true", help="write nothing")
    o = options.parse_args()
    o.program = o.program.resolve()
    shared = [SHARED / f"{name}.pbrt" for name in SIX]
    scenes = o.scenes or (shared if all(scene.exists() for scene in shared) else [ROOT / "scenes" / f"{name}.pbrt" for name in OWN])

    lines = ["| scene | sampler, lights | relMSE x 1000 | blurred x 1000 | seconds | efficiency | efficiency, blurred |", "|---|---|--:|--:|--:|--:|--:|"]
    for scene in scenes:
        title = scene.parent.name if scene.name.startswith("scene") else scene.stem
        with tempfile.TemporaryDirectory() as folder:
            rows = measure(o, scene.resolve(), pathlib.Path(folder) / "image.exr")
        efficiency = [[1 / (np.mean(e) * seconds) for e in (errors, after)] for _, errors, after, seconds in rows]
        for (name, errors, after, seconds), both in zip(rows, efficiency):
            cells = [f"{1000 * np.mean(e):.3g} +- {1000 * np.std(e, ddof=1) / len(e) ** 0.5:.2g}" if len(e) > 1 else f"{1000 * e[0]:.3g}" for e in (errors, after)]
            relative = [value / first for value, first in zip(both, efficiency[0])]
            lines.append(f"| {title} | {name} | {cells[0]} | {cells[1]} | {seconds:.2f} | {relative[0]:.2f} | {relative[1]:.2f} |")
            print(lines[-1], file=sys.stderr, flush=True)
    text = "\n".join(lines) + "\n"
    page.put(PAGE, BEGIN, text, END, only_print=o.print)


if __name__ == "__main__":
    main()
