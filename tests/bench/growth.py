#!/usr/bin/env python3
"""How cost grows: with triangles, with pixels, with samples, and with the length of a scene's text.

    tests/bench/growth.py [--triangles 100000,1000000,10000000] [--program build/eikonal]

Makes its own scenes (the grey terrain of paths.py). Prints three tables.
"""

import argparse
import json
import math
import pathlib
import random
import re
import tempfile

from paths import ROOT, bench, run, write_terrain
from report import Report


def triangles_table(o, folder, report):
    add = report.table("triangles", {"triangles": None, "build, M triangles/s": ".2f", "bytes a triangle": ".0f", "ns a path": ".0f", "of it, for each doubling": ".0f"})
    last = None
    for count in o.triangles:
        scene = write_terrain(folder, round(math.sqrt(count / 2)))
        j = bench(o.program, scene, folder, "--spp", 4, "--repeats", 1)
        tables = json.loads(run([o.program, "info", scene, "--json"]))["memory"]["tables"]
        nanoseconds = 1e9 / j["pathsPerSecond"]
        add(count, count / j["buildSeconds"] * 1e-6, tables / count, nanoseconds, (nanoseconds - last[1]) / math.log2(count / last[0]) if last else None)
        last = count, nanoseconds


def first_ray(program, scene, *more):
    """Seconds until the first ray, and what the queues take, as the program says it."""
    with tempfile.TemporaryDirectory() as name:
        out = run([program, "render", scene, "--stats", "--time-limit", "0.01", "-o", pathlib.Path(name) / "image.exr", *more])
    return float(re.search(r"until the first ray\s+([\d.]+) s", out).group(1)), re.search(r"queues ([\d.]+ \w+)", out).group(1)


def starts_table(o, folder, report):
    """With --crop, only 64 x 64 pixels of the large image are rendered, and the film is theirs; without it, all get a sample, which takes minutes."""
    scene = write_terrain(folder, 100)
    first_ray(o.program, scene)   # compiles
    print()
    add = report.table("images", {"image": None, "samples a pixel": None, "until the first ray, s": ".2f", "queues": None})
    for size, samples in (("512x512", 1), ("512x512", 1000000), ("16384x16384", 1), ("16384x16384", 1000000)):
        window = ["--resolution", size, "--spp", samples]
        if size != "512x512":
            window += ["--pixelbounds", "0,64,0,64"] if o.crop else []
        seconds, queues = first_ray(o.program, scene, *window)
        add(size, samples, seconds, queues)


def text_table(o, folder, report):
    """A mesh whose vertices are written out."""
    numbers = random.Random(1)
    print()
    add = report.table("text", {"text, MB": ".0f", "read, s": ".3f", "MB/s": ".0f"})
    for count in (100000, 1000000):
        points = " ".join(f"{numbers.uniform(-1, 1):.6f}" for _ in range(3 * count))
        indices = " ".join(str(numbers.randrange(count)) for _ in range(3 * count))
        scene = folder / "text.pbrt"
        scene.write_text(f'Camera "perspective"\nWorldBegin\nLightSource "infinite"\nShape "trianglemesh" "point3 P" [ {points} ] "integer indices" [ {indices} ]\n')
        size = scene.stat().st_size * 1e-6
        out = run([o.program, "render", scene, "--stats", "--spp", 1, "--resolution", "16x16", "-o", folder / "image.exr"])
        seconds = float(re.search(r"read the scene\s+([\d.]+) s", out).group(1))
        add(size, seconds, size / seconds)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--triangles", type=lambda text: [int(n) for n in text.split(",")], default=[100000, 1000000, 10000000])
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--crop", action="store_true", help="of the large image, only 64 x 64 pixels")
    Report.add_to(options)
    o = options.parse_args()
    report = Report(o.json)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        triangles_table(o, folder, report)
        starts_table(o, folder, report)
        text_table(o, folder, report)


if __name__ == "__main__":
    main()
