#!/usr/bin/env python3
"""Measures the choice of lights on scenes with many emitters, and writes the tables of docs/lights.md.

    tests/accuracy/many_lights.py --program build/eikonal           all scenes and samplers
    tests/accuracy/many_lights.py --program build/eikonal --counts 4,16 --print

The relative error is the median over the pixels of the standard error of a pixel's mean, as the image's `variance` channel estimates it, over
that mean (a median, since a lamp that the camera sees is noise of another kind). The error at equal time is that times the square root of the
processor time that --samples more samples take (the least of three times: others use the machine, too): loading and compiling do not count. All samplers must agree on the mean. Needs Debian's python3-openimageio.
"""

import argparse
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

import numpy as np
import OpenImageIO as oiio

import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "lights.md"
BEGIN, END = "<!-- tables: made by tests/accuracy/many_lights.py -->\n", "<!-- end of tables -->\n"
SAMPLERS = ["uniform", "power", "bvh"]
REPEATS = 3


def hall(count, sky):
    """A long hall with columns and small lamps all over it: some as bright as a hundred others; half are triangles that shine downwards,
    the rest spheres that shine all around."""
    rng = random.Random(count)
    text = """LookAt 0 2.5 -19  0 1.5 0  0 1 0
Camera "perspective" "float fov" 60
Film "rgb" "integer xresolution" 64 "integer yresolution" 40
PixelFilter "box"
Sampler "zsobol" "integer pixelsamples" 16
Integrator "volpath" "integer maxdepth" 2
WorldBegin
Material "diffuse" "rgb reflectance" [ .6 .6 .6 ]
Shape "bilinearmesh" "point3 P" [ -10 0 -20  10 0 -20  -10 0 20  10 0 20 ]
Shape "bilinearmesh" "point3 P" [ -10 0 -20  -10 6 -20  -10 0 20  -10 6 20 ]
Shape "bilinearmesh" "point3 P" [ 10 0 -20  10 6 -20  10 0 20  10 6 20 ]
"""
    if sky:
        text += 'LightSource "infinite" "rgb L" [ .02 .03 .05 ]\n'
    for z in range(-16, 20, 4):
        for x in (-5, 5):
            text += f'AttributeBegin Translate {x} 3 {z} Scale .4 3 .4 Shape "sphere" AttributeEnd\n'
    size = 0.02
    for i in range(count):
        x, y, z = rng.uniform(-9.5, 9.5), rng.uniform(0.3, 5.8), rng.uniform(-19, 19)
        power = 400 / count * rng.choice((1, 1, 1, 1, 1, 1, 1, 1, 1, 100)) / 11
        colour = " ".join(f"{rng.uniform(.5, 1):.3f}" for _ in range(3))
        lamp = f'AttributeBegin AreaLightSource "diffuse" "rgb L" [ {colour} ] "float power" {power:.5g} Translate {x:.3f} {y:.3f} {z:.3f} '
        if i % 2:
            lamp += f'Shape "trianglemesh" "point3 P" [ 0 0 0  {size} 0 0  0 0 {size} ] "integer indices" [ 0 1 2 ]'
        else:
            lamp += f'Shape "sphere" "float radius" {size / 4}'
        text += lamp + " AttributeEnd\n"
    return text


def render(program, scene, sampler, samples, image):
    """Processor seconds that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "render", scene, "--light-sampler", sampler, "--spp", samples, "--aov", "variance", "-o", image]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime


def measure(program, folder, scene, sampler, samples):
    """Mean brightness, its standard error, relative error of a pixel, processor seconds."""
    image = folder / "image.exr"
    render(program, scene, sampler, 1, image)   # compiles, if need be
    few = min(render(program, scene, sampler, 1, image) for _ in range(REPEATS))
    seconds = min(render(program, scene, sampler, 1 + samples, image) for _ in range(REPEATS)) - few
    pixels = oiio.ImageBuf(str(image))
    names = list(pixels.spec().channelnames)
    values = pixels.get_pixels()
    luminance = values[..., names.index("R")] * 0.2126 + values[..., names.index("G")] * 0.7152 + values[..., names.index("B")] * 0.0722
    variance = values[..., names.index("variance")]
    mean = float(luminance.mean())
    lit = luminance > 0
    return mean, float(variance.sum() ** 0.5 / variance.size), float(np.median(variance[lit] ** 0.5 / luminance[lit])), seconds


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--counts", default="2,4,16,100,1000,10000")
    options.add_argument("--samples", type=int, default=256)
    options.add_argument("--print", action="store_true", help="write nothing")
    o = options.parse_args()

    lines, agree = [], True
    for sky in (False, True):
        lines += [f"| {'lamps and a sky' if sky else 'lamps'} | sampler | seconds | relative error | error at equal time, power = 1 |", "|--:|---|--:|--:|--:|"]
        for count in map(int, o.counts.split(",")):
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                scene = folder / "hall.pbrt"
                scene.write_text(hall(count, sky))
                results = {sampler: measure(o.program.resolve(), folder, scene, sampler, o.samples) for sampler in SAMPLERS}
            reference = results["power"]
            for sampler, (mean, error, relative, seconds) in results.items():
                equal = relative / reference[2] * (seconds / reference[3]) ** 0.5
                lines.append(f"| {count} | {sampler} | {seconds:.2f} | {100 * relative:.1f} % | {equal:.2f} |")
                print(lines[-1], f"mean {mean:.5g} +- {error:.2g}", file=sys.stderr, flush=True)
                if abs(mean - results["bvh"][0]) > 4 * (error**2 + results["bvh"][1] ** 2) ** 0.5:
                    agree = False
                    print(f"{sampler} and bvh differ", file=sys.stderr)
        lines.append("")
    text = "\n".join(lines)
    page.put(PAGE, BEGIN, text, END, only_print=o.print)
    sys.exit(not agree)


if __name__ == "__main__":
    main()
