#!/usr/bin/env python3
"""How cost grows: with triangles, with pixels, with samples, with the length of a scene's text, and with instances.

    tests/bench/growth.py [--triangles 100000,1000000,10000000] [--only instances,memory] [--program build/eikonal]

Makes its own scenes (the grey terrain of paths.py, and those of instances.py). Prints a table for each. `memory` takes 2.5 GB and a minute.
"""

import argparse
import json
import math
import os
import pathlib
import random
import re
import subprocess
import tempfile

import instances
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


def usage(program, scene, image, samples):
    """What `render --stats` prints, and what Linux counts for it: seconds of CPU in `ru_utime`, kilobytes in `ru_maxrss`."""
    child = subprocess.Popen([str(program), "render", str(scene), "--stats", "--spp", str(samples), "-o", str(image)], stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, text=True)
    out = child.stdout.read()
    return out, os.wait4(child.pid, 0)[2]


def instances_table(o, folder, report):
    """Sponges of 160,000 cubes, and 168,420 cubes in sponges within one another, divided into instances or as one mesh: CPU time of 32 more samples."""
    print()
    add = report.table("instances", {"scene": None, "cubes an object": None, "instances": None, "tables, MiB": ".1f", "ns of CPU a path": ".0f"})
    file, image = folder / "sponge.pbrt", folder / "image.exr"
    scenes = [("sponge", inner, turn, lambda n, t: instances.write_sponge(file, 4, n, t)) for turn in (0, 25) for inner in (0, 1, 2, 4)]
    scenes += [("sponges within sponges", inner, turn, lambda n, t: instances.write_nested(file, 4, n or 2, t, n == 0)) for turn in (0, 25) for inner in (1, 2, 0)]
    for name, inner, turn, write in scenes:
        write(inner, turn)
        told = json.loads(run([o.program, "info", file, "--json"]))
        first_ray(o.program, file)   # compiles
        seconds = [usage(o.program, file, image, 36)[1].ru_utime - usage(o.program, file, image, 4)[1].ru_utime for _ in range(3)]
        count = told["counts"]["instances"]
        add(name + (f", turned by {turn} degrees" if turn else ""), 20**inner if count else "all", count, told["memory"]["tables"] / 2**20, sorted(seconds)[1] * 1e9 / (32 * 256 * 256))


def memory_table(o, folder, report):
    """What a render occupies at most, as `info` foretells it and as Linux counts it."""
    print()
    add = report.table("memory", {"scene": None, "told, MiB": ".0f", "taken, MiB": ".0f", "of it": ".2f", "read, s": ".2f", "build, s": ".2f", "render, s": ".2f"})
    for name, file, write in (("10,000 instances of 100,000 triangles", folder / "copies.pbrt", lambda f: instances.write_copies(f, 100000, 10000)),
                              ("20 million triangles in 4 PLY files", folder / "balls.pbrt", lambda f: instances.write_balls(f, 20000000, 4))):
        write(file)
        told = json.loads(run([o.program, "info", file, "--json"]))["memory"]["most"]
        first_ray(o.program, file)   # compiles
        out, used = usage(o.program, file, folder / "image.exr", 4)
        taken = used.ru_maxrss * 1024
        seconds = [float(re.search(rf"^  {what}\s+([\d.]+) s", out, re.MULTILINE).group(1)) for what in ("read the scene", "build the hierarchies", "render")]
        add(name, told / 2**20, taken / 2**20, told / taken, *seconds)


TABLES = {"triangles": triangles_table, "images": starts_table, "text": text_table, "instances": instances_table, "memory": memory_table}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--triangles", type=lambda text: [int(n) for n in text.split(",")], default=[100000, 1000000, 10000000])
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--crop", action="store_true", help="of the large image, only 64 x 64 pixels")
    options.add_argument("--only", type=lambda text: text.split(","), default=list(TABLES), help=f"of {', '.join(TABLES)}")
    Report.add_to(options)
    o = options.parse_args()
    report = Report(o.json)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for name in o.only:
            TABLES[name](o, folder, report)


if __name__ == "__main__":
    main()
