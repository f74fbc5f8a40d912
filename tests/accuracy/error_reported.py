#!/usr/bin/env python3
"""Whether the error that a render reports is its true one, at equal samples in all pixels: a table of docs/accuracy.md.

    tests/accuracy/error_reported.py                                   our own scenes
    tests/accuracy/error_reported.py peer-cornell=FILE.pbrt --seeds 8  others

The true error is that of the mean over seeds: the root of the mean, over the pixels, of the variance between seeds over r^2 + 0.01; r is a pixel's luminance in
the mean of all renders of the scene. So no reference is needed. A cell has the true error over the mean of the reported ones, and, in brackets, over the greatest
and the least of them; F: some run says that its estimate is not reliable. error_asked.py measures the same for adaptive sampling, against references. Needs numpy.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "bench"), str(ROOT / "tests" / "bench" / "points")]
from points import read_pfm

REPORTED = re.compile(r"error about ([\d.e+-]+) %.*?(not reliable|$)", re.MULTILINE)


def render(o, scene, samples, seed, image):
    """Luminance, reported error, whether that is in doubt."""
    command = [o.program, "render", scene, "--spp", samples, "--seed", seed, "--resolution", f"{o.size}x{o.size}", "-o", image]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    found = REPORTED.search(done.stdout + done.stderr)
    if done.returncode or not found:
        sys.exit(f"error_reported.py: {' '.join(map(str, command))} failed:\n{done.stderr}")
    return read_pfm(image), float(found[1]) / 100, bool(found[2])


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*", metavar="NAME=FILE", default=[f"{name}={ROOT / 'scenes' / name}.pbrt" for name in ("materials", "environment")])
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--samples", default="16,32,64,128,256")
    options.add_argument("--seeds", type=int, default=8)
    options.add_argument("--size", type=int, default=72)
    o = options.parse_args()
    o.program = o.program.resolve()
    counts = [int(n) for n in o.samples.split(",")]
    print("| true / reported, samples: | " + " | ".join(map(str, counts)) + " |\n|---|" + "--:|" * len(counts))
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder) / "image.pfm"
        for word in o.scenes:
            title, _, scene = word.partition("=")
            runs = {n: [render(o, scene, n, seed, image) for seed in range(1, o.seeds + 1)] for n in counts}
            r = sum(n * sum(pixels for pixels, *_ in each) for n, each in runs.items()) / (o.seeds * sum(counts))
            cells = []
            for each in runs.values():
                true = np.sqrt((np.var([pixels for pixels, *_ in each], axis=0, ddof=1) / (r**2 + 0.01)).mean())
                reported = [error for _, error, _ in each]
                cells.append(f"{true / np.mean(reported):.2f} ({true / max(reported):.2f} to {true / min(reported):.2f}){' F' if any(doubt for *_, doubt in each) else ''}")
            print(f"| {title} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
