#!/usr/bin/python3
"""Renders five scenes in RGB and at wavelengths, and writes what each costs and how far it is from pbrt-v4 into docs/accuracy.md.

    tests/accuracy/spectral.py               of ../shared/gallery, 1024 samples a pixel
    tests/accuracy/spectral.py --spp 64 --print

Error: the mean of |pixel - reference| over that of the reference, of an image of 8 x 8 blocks, so that noise hardly counts. Cost: time of
rendering, that in RGB being 1; --rounds of each, taking turns, of which the fastest counts.
"""

import argparse
import pathlib
import re
import sys

import numpy as np
import OpenImageIO as oiio

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import gallery
import page

SCENES = ["material-diffuse", "material-conductor-rough", "light-blackbody", "medium-absorb", "film-sensor"]
BEGIN, END = "<!-- table: made by tests/accuracy/spectral.py -->\n", "<!-- end of the table of colour -->\n"


def blocks(path):
    """The image, averaged over blocks of 8 x 8 pixels."""
    pixels = oiio.ImageBuf(str(path)).get_pixels(oiio.FLOAT)[:, :, :3]
    height, width = pixels.shape[0] // 8 * 8, pixels.shape[1] // 8 * 8
    return pixels[:height, :width].reshape(height // 8, 8, width // 8, 8, 3).mean(axis=(1, 3))


def render(o, scene, color):
    """The fastest of the rounds, seconds, and the image."""
    image = o.renders / f"{scene}-{color}.exr"
    if not gallery.render(o.program, o.gallery / f"{scene}.pbrt", image, o.spp, color):
        sys.exit(f"spectral.py: {scene} cannot be rendered:\n" + image.with_suffix(".log").read_text())
    seconds = re.search(r"^  render +([0-9.]+) s", image.with_suffix(".log").read_text(), re.MULTILINE)
    return float(seconds[1]), image


def row(o, scene):
    reference = blocks(o.gallery / "reference" / f"{scene}.exr")
    times, errors, means = {}, {}, {}
    for _ in range(o.rounds):
        for color in ("rgb", "spectral"):
            seconds, image = render(o, scene, color)
            times[color] = min(times.get(color, seconds), seconds)
            ours = blocks(image)
            errors[color] = np.abs(ours - reference).mean() / reference.mean()
            means[color] = " ".join(f"{x:.4f}" for x in ours.mean(axis=(0, 1)) / reference.mean(axis=(0, 1)))
    return (f"| {scene} | {means['rgb']} | {means['spectral']} | {100 * errors['rgb']:.2f} % | {100 * errors['spectral']:.2f} % | "
            f"{times['spectral'] / times['rgb']:.2f} |")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--gallery", type=pathlib.Path, default=gallery.ROOT.parent / "shared" / "gallery")
    options.add_argument("--program", type=pathlib.Path, default=gallery.ROOT / "build" / "eikonal")
    options.add_argument("--spp", type=int, default=1024)
    options.add_argument("--rounds", type=int, default=2)
    options.add_argument("--renders", type=pathlib.Path, default=gallery.ROOT / "build" / "accuracy-color", help="where images and logs go")
    options.add_argument("--print", action="store_true", help="print the table, write nothing")
    o = options.parse_args()
    o.renders.mkdir(parents=True, exist_ok=True)
    lines = [f"{o.spp} samples per pixel.", "", "| scene | mean / reference in RGB | spectral | error in RGB | spectral | cost |",
             "|---|---|---|--:|--:|--:|"]
    for scene in SCENES:
        lines.append(row(o, scene))
        print(lines[-1], file=sys.stderr, flush=True)
    text = "\n".join(lines) + "\n"
    page.put(gallery.PAGE, BEGIN, text, END, only_print=o.print)


if __name__ == "__main__":
    main()
