#!/usr/bin/env python3
"""Renders the book's figures again: each docs/book/figures/NAME.pbrt to NAME.png.

    figures.py --program build/eikonal            writes the images
    figures.py --program build/eikonal --check    renders to a temporary folder; status 1 if an image differs from the committed one

The renderer gives the same bits on one kind of device; another compiler may round differently, so --check allows a mean FLIP error of 0.01.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from fragments import BOOK, ROOT

LARGEST_FLIP = 0.01


def render(program, scene, image):
    subprocess.run([program, "render", scene, "-o", image, "--log-level", "error"], check=True)


def agree(program, image, reference):
    return subprocess.run([program, "compare", image, reference, "--fail-above", str(LARGEST_FLIP)], stdout=subprocess.DEVNULL).returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted((BOOK / "figures").glob("*.pbrt")):
            image = scene.with_suffix(".png")
            target = Path(folder) / image.name if options.check else image
            render(options.program.resolve(), scene, target)
            differs = options.check and not agree(options.program.resolve(), target, image)
            failed += differs
            print(f"{image.relative_to(ROOT)}: {'DIFFERS' if differs else 'agrees' if options.check else 'rendered'}", flush=True)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
