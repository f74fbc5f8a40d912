#!/usr/bin/env python3
"""Whole paths a second, beside what Embree traces on the same machine at that moment, and error per second.

    tests/bench/paths.py SCENE[=WANTED] ... [--terrain WANTED]

Absolute times vary by two here, so each scene is measured next to Embree's bounced rays on a million triangles (tests/bench/traversal_bench,
built with -DEIKONAL_BENCH=ON), and WANTED (million paths a second) is what is asked of a machine on which Embree traces 6.0 million of them.
Relative variance and efficiency are those of `eikonal bench --efficiency`: at --samples a pixel, over --repeats seeds.
--terrain: also 1.5 million grey triangles under a white sky, made here. Prints a row for each scene.
"""

import argparse
import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
EMBREE_RATE = 6.0


PARTIAL_IMAGE = 4   # exit status of a render that --time-limit has ended


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode not in (0, PARTIAL_IMAGE):
        sys.exit(f"paths: {' '.join(map(str, command))} failed:\n{done.stderr}")
    return done.stdout


def bench(program, scene, folder, *options):
    """The figures of `eikonal bench`."""
    run([program, "bench", scene, "--json", folder / "bench.json", *options])
    return json.loads((folder / "bench.json").read_text())


def embree_rate(traversal_bench):
    """Million bounced rays a second."""
    report = json.loads(run([traversal_bench, "--json", "--scenes", "terrain-1", "--kinds", "bounced", "--batches", "65536", "--repeats", "3"]))
    return report["figures"][0]["embree_mrays"]


def write_terrain(folder, quads=866):
    """About 1.5 million triangles, all grey, white sky."""
    numbers = random.Random(1)
    waves = [(numbers.uniform(-1, 1) * 2**k, numbers.uniform(-1, 1) * 2**k, numbers.uniform(0, 6), 0.5**k) for k in range(8) for _ in range(3)]
    n = quads + 1
    with open(folder / "terrain.ply", "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {n * n}\nproperty float x\nproperty float y\nproperty float z\n"
                   f"element face {2 * quads * quads}\nproperty list uchar int vertex_indices\nend_header\n".encode())
        for j in range(n):
            for i in range(n):
                x, y = 8 * i / quads - 4, 8 * j / quads - 4
                file.write(struct.pack("<3f", x, y, 0.3 * sum(a * math.sin(u * x + v * y + p) for u, v, p, a in waves)))
        for j in range(quads):
            for i in range(quads):
                a = j * n + i
                file.write(struct.pack("<B3iB3i", 3, a, a + 1, a + n, 3, a + 1, a + n + 1, a + n))
    scene = folder / "terrain.pbrt"
    scene.write_text('LookAt 0 -5 4  0 0 0  0 0 1\nCamera "perspective" "float fov" 50\nFilm "rgb" "integer xresolution" 512 "integer yresolution" 512\n'
                     'Integrator "path" "integer maxdepth" 5\nWorldBegin\nLightSource "infinite" "rgb L" [ 1 1 1 ]\n'
                     'Material "diffuse" "rgb reflectance" [ 0.5 0.5 0.5 ]\nShape "plymesh" "string filename" "terrain.ply"\n')
    return scene


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*")
    options.add_argument("--terrain", type=float, metavar="WANTED")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--traversal-bench", type=pathlib.Path, default=ROOT / "build" / "tests" / "bench" / "traversal_bench")
    options.add_argument("--samples", type=int, default=8)
    options.add_argument("--repeats", type=int, default=5, help="at least 4")
    Report.add_to(options)
    o = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        wanted = [(pathlib.Path(path), float(rate) if rate else None) for path, _, rate in (scene.partition("=") for scene in o.scenes)]
        if o.terrain:
            wanted.append((write_terrain(folder), o.terrain))
        add = Report(o.json).table("paths", {"scene": None, "M paths/s": ".2f", "Embree, M bounced rays/s": ".2f", "wanted at that rate": ".2f", "of it": ".2f",
                                              "relative variance": ".3g", "+-": ".1g", "efficiency": ".3g", "at least": ".3g", "at most": ".3g"})
        for scene, rate in wanted:
            before = embree_rate(o.traversal_bench)
            figures = bench(o.program, scene, folder, "--spp", o.samples, "--repeats", o.repeats, "--efficiency")
            embree = (before + embree_rate(o.traversal_bench)) / 2
            ours = figures["pathsPerSecond"] * 1e-6
            target = rate * embree / EMBREE_RATE if rate else None
            add(f"{scene.parent.name if scene.parent != folder else 'generated'}/{scene.name}", ours, embree, target, ours / target if target else None,
                figures["relativeVariance"], figures["relativeVarianceStandardError"], figures["efficiency"], *figures["efficiencyInterval"])


if __name__ == "__main__":
    main()
