#!/usr/bin/python3
"""Measures the energy that rough metal and rough glass keep, and writes the table into docs/accuracy.md.

    tests/accuracy/rough_energy.py               16,384 samples an entry
    tests/accuracy/rough_energy.py --print       prints the table instead

A ball that absorbs nothing stands under a sky of radiance 1 and is seen at a point, at a given angle to its normal. What is missing from 1 is
the light that would have left the microfacets after more than one bounce. Metal: one reflection. Glass: the whole path through the ball.
"""

import argparse
import array
import math
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ALPHAS = [0.01, 0.1, 0.3, 0.6, 1]
COSINES = [1, 0.7, 0.2]
INDICES = [1.0000001, 1.1, 1.5, 2.5]
BEGIN, END = "<!-- table: made by tests/accuracy/rough_energy.py -->\n", "<!-- end of the table of rough materials -->\n"

SCENE = """Film "rgb" "integer xresolution" 16 "integer yresolution" 16
PixelFilter "box" Sampler "sobol" "integer pixelsamples" {spp}
Integrator "path" "integer maxdepth" 200
LookAt {eye}  {point}  0 1 0
Camera "perspective" "float fov" 0.02
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Material {material} "bool remaproughness" false "float roughness" {alpha}
Shape "sphere"
"""


def read_mean(path):
    """The mean of the green channel of a PFM file."""
    with open(path, "rb") as file:
        file.readline()
        width, height = map(int, file.readline().split())
        file.readline()
        values = array.array("f", file.read(12 * width * height))
    return sum(values[1::3]) / (width * height)


def energy(o, folder, material, alpha, cosine):
    """Seen from 4 away from a point of the ball, at that cosine to its normal, which is -z."""
    sine = math.sqrt(1 - cosine * cosine)
    scene, image = folder / "ball.pbrt", folder / "ball.pfm"
    scene.write_text(SCENE.format(spp=o.spp, eye=f"{4 * sine} 0 {-1 - 4 * cosine}", point="0 0 -1", material=material, alpha=alpha))
    subprocess.run([o.program, "render", scene, "-o", image], check=True, capture_output=True)
    return read_mean(image)


def table(o):
    materials = [("metal", '"conductor" "rgb reflectance" [1 1 1]')]
    materials += [(f"glass, eta {index:.8g}", f'"dielectric" "float eta" {index:.8g}') for index in INDICES]
    lines = ["| | cosine | " + " | ".join(f"alpha {alpha:g}" for alpha in ALPHAS) + " |", "|---|---|" + "---|" * len(ALPHAS)]
    with tempfile.TemporaryDirectory() as name:
        for title, material in materials:
            for cosine in COSINES:
                kept = [energy(o, pathlib.Path(name), material, alpha, cosine) for alpha in ALPHAS]
                lines.append(f"| {title} | {cosine:g} | " + " | ".join(f"{x:.3f}" for x in kept) + " |")
    return "\n".join(lines) + "\n"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--spp", type=int, default=64, help="samples of each of 256 pixels")
    options.add_argument("--print", action="store_true", help="print the table instead of writing it")
    o = options.parse_args()
    made = table(o)
    if o.print:
        print(made, end="")
        return
    document = ROOT / "docs" / "accuracy.md"
    text = document.read_text()
    document.write_text(re.sub(re.escape(BEGIN) + ".*?" + re.escape(END), lambda _: BEGIN + made + END, text, flags=re.DOTALL))


if __name__ == "__main__":
    main()
