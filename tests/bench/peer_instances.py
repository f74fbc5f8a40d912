#!/usr/bin/env python3
"""Scenes of many instances by Eikonal and by pbrt-v4, in turn.

    tests/bench/peer_instances.py PBRT [--rounds 3] [--only sponge,nested] [--program build/eikonal] [--json FILE]

PBRT is pbrt-v4's program. Makes the scenes of instances.py. An object of an object is nothing that pbrt-v4 reads, so its innermost level
is the object, and all levels around it are written out as instances; ours reads the same file. "render" is the time of the last 60 of 64
samples: that of the whole program at 64 samples, which is "whole", less that at 4. Medians over the rounds; ratios are of the same round,
least and largest those by CPU. Each program is run before, so that kernels are compiled and files in memory.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile

import instances
from paths import ROOT
from report import Report
from starts import measured

FEW, MANY = 4, 64
SCENES = {
    "sponge": ("sponge, 160,000 cubes", lambda f: instances.write_sponge(f, 4, 0)),
    "turned": ("sponge, turned by 25 degrees, 8,000 x 20 cubes", lambda f: instances.write_sponge(f, 4, 1, 25)),
    "nested": ("sponges within sponges, turned, 8,421 x 20 cubes", lambda f: instances.write_nested(f, 4, 1, 25)),
    "deep": ("sponge of 5 levels, 8,000 x 400 cubes", lambda f: instances.write_sponge(f, 5, 2)),
    "balls": ("10,000 balls of 100,000 triangles", lambda f: instances.write_copies(f, 100000, 10000)),
}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("pbrt", type=pathlib.Path)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--threads", type=int, default=2)
    options.add_argument("--only", type=lambda text: text.split(","), default=list(SCENES), help=f"of {', '.join(SCENES)}")
    Report.add_to(options)
    o = options.parse_args()
    report = Report(o.json)
    add = report.table("against pbrt-v4", {"scene": None, "renderer": None, "render, s": ".2f", "CPU": ".2f", "whole, s": ".2f", "whole CPU": ".2f",
                                           "theirs / ours": ".2f", "by CPU": ".2f", "least": ".2f", "largest": ".2f", "whole by CPU": ".2f", "mean off, %": "+.2f"})
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = folder / "scene.pbrt"
        shared = ["--nthreads", o.threads, scene, "--outfile"]
        programs = {"pbrt-v4": [o.pbrt, "--quiet", *shared], "Eikonal": [o.program, "render", "--quiet", *shared],
                    "Eikonal, at wavelengths": [o.program, "render", "--quiet", "--color", "spectral", *shared]}
        for key in o.only:
            label, write = SCENES[key]
            write(scene)
            images = {renderer: folder / f"{i}.exr" for i, renderer in enumerate(programs)}
            took = {renderer: [] for renderer in programs}
            for turn in range(o.rounds + 1):
                for renderer, command in programs.items():
                    few, many = (measured([*command, images[renderer], "--spp", n], os.environ) for n in (FEW, MANY))
                    if turn:
                        took[renderer].append((many[0] - few[0], many[1] - few[1], *many))
            for renderer, ours in took.items():
                ratios = [[b[k] / a[k] for a, b in zip(ours, took["pbrt-v4"])] for k in range(4)]
                of_clock, by_cpu, _, whole_by_cpu = (statistics.median(r) for r in ratios)
                medians = [statistics.median(t[k] for t in ours) for k in range(4)]
                if renderer == "pbrt-v4":
                    add(label, renderer, *medians, *[None] * 6)
                    continue
                told = json.loads(subprocess.run([str(o.program), "compare", str(images[renderer]), str(images["pbrt-v4"]), "--json"], check=True,
                                                 capture_output=True, text=True).stdout)
                off = 100 * (sum(told["mean"]) / sum(told["referenceMean"]) - 1)
                add(label, renderer, *medians, of_clock, by_cpu, min(ratios[1]), max(ratios[1]), whole_by_cpu, off)


if __name__ == "__main__":
    main()
