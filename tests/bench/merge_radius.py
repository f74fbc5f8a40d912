#!/usr/bin/env python3
"""The first radius within which vcm merges paths: whether the one chosen for a scene is near the best.

    tests/bench/merge_radius.py [--program eikonal] [--scenes still-life,ring,...] [--width 96] [--spp 32] [--seeds 3] [--json FILE]

For each scene of scenes/, or scene file: the radius that is chosen (docs/integrators.md#merging), and relMSE with multiples of it, the mean over seeds; in
parentheses without the worst thousandth of the pixels. The reference has 64 times the samples, another seed, and a third of the radius, so it is biased a little.
"""

import argparse
import pathlib
import re
import statistics
import tempfile

from hard_light_renderers import HEAD_DIRECTIVE, Scene, first_radius, run
from paths import ROOT
from report import Report

FACTORS = (4, 2, 1, 0.5, 0.25)


class Merged:
    """Renders a scene with vcm. The copy with a given radius lies beside the scene, so that it finds its files."""

    def __init__(self, program, scene, radius):
        self.program, self.scene = program, scene
        head, world, rest = scene.path.read_text().partition("WorldBegin")
        head = re.sub(HEAD_DIRECTIVE.format("Integrator"), "", re.sub(r'#[^\n"]*$', "", head, flags=re.MULTILINE))
        self.copy = scene.path.with_name(f".radius-{scene.path.name}")
        self.copy.write_text(f'Integrator "vcm" "integer maxdepth" {scene.depth} "float radius" {radius}\n{head}{world}{rest}')

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.copy.unlink()

    def render(self, samples, seed, image):
        run(self.program, "render", self.copy, "--color", "rgb", "--resolution", f"{self.scene.width}x{self.scene.height}", "--spp", samples, "--seed", seed,
            "-o", image)
        return image


def error(program, image, reference):
    """relMSE, and that without the worst thousandth of the pixels. compare says by its exit status whether images differ."""
    told = run("sh", "-c", f"'{program}' compare '{image}' '{reference}' || true")
    return tuple(map(float, re.search(r"relative MSE\s+([\d.e+-]+) \(([\d.e+-]+)", told).groups()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--scenes", default="still-life,ring,glass-ball,lamp-in-glass")
    parser.add_argument("--width", type=int, default=96)
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--seeds", type=int, default=3)
    Report.add_to(parser)
    o = parser.parse_args()
    add = Report(o.json).table("radii", {"scene": None, "radius": ".3g", **{f"x {f:g}": None for f in FACTORS}})
    with tempfile.TemporaryDirectory() as folder:
        reference, image = (pathlib.Path(folder, name) for name in ("reference.pfm", "image.pfm"))
        for name in o.scenes.split(","):
            file = pathlib.Path(name)
            scene = Scene(file.name, file if file.suffix else ROOT / "scenes" / f"{name}.pbrt", o.width, o.program)
            chosen = first_radius(o.program, scene, image)
            with Merged(o.program, scene, chosen / 3) as merged:
                merged.render(64 * o.spp, 1000, reference)
            row = []
            for factor in FACTORS:
                with Merged(o.program, scene, factor * chosen) as merged:
                    errors = [error(o.program, merged.render(o.spp, seed, image), reference) for seed in range(1, o.seeds + 1)]
                row.append("{:.3g} ({:.2g})".format(*map(statistics.fmean, zip(*errors))))
            add(name, chosen, *row)


if __name__ == "__main__":
    main()
