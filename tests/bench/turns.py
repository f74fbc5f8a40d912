#!/usr/bin/env python3
"""Two builds of the program by turns: rates, memory and starts, as ratios new / old.

    tests/bench/turns.py --old OLD/build/eikonal --new build/eikonal SCENE ... [--cold]

Each round benches every scene with both programs, one after the other, in an order that alternates; a row has the median of the rounds'
ratios, and their least and greatest. "Paths" above 1 and "first ray" below 1 are better. --cold: also the seconds until the first ray with
an empty cache. Each program uses the kernels of the folder that it was built in. Nothing else should run on the machine.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

from report import Report
from starts import start


def bench(program, scene, samples):
    """(paths per second, KiB of peak memory) of one render."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "bench", scene, "--spp", samples, "--repeats", 1, "--quiet", "--json", f"{folder}/bench.json"]
        child = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status:
            sys.exit(f"turns: {' '.join(map(str, command))} failed")
        return json.loads(pathlib.Path(folder, "bench.json").read_text())["pathsPerSecond"], usage.ru_maxrss


def cold_start(program, scene):
    with tempfile.TemporaryDirectory() as cache:
        return start(program, scene, cache)[2]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", type=pathlib.Path, nargs="+")
    options.add_argument("--old", type=pathlib.Path, required=True)
    options.add_argument("--new", type=pathlib.Path, required=True)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--samples", type=int, default=8)
    options.add_argument("--cold", action="store_true")
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("turns", {"scene": None, "figure": None, "new / old": ".3f", "least": ".3f", "greatest": ".3f"})
    for scene in o.scenes:
        bench(o.old, scene, 1), bench(o.new, scene, 1)
        ratios = {"paths": [], "memory": []} | ({"first ray, cold": []} if o.cold else {})
        for round_ in range(o.rounds):
            order = (o.old, o.new) if round_ % 2 == 0 else (o.new, o.old)
            figures = {program: bench(program, scene, o.samples) for program in order}
            if o.cold:
                figures = {program: (*figures[program], cold_start(program, scene)) for program in order}
            for name, new, old in zip(ratios, figures[o.new], figures[o.old]):
                ratios[name].append(new / old)
        for name, values in ratios.items():
            add(f"{scene.parent.name}/{scene.name}", name, statistics.median(values), min(values), max(values))


if __name__ == "__main__":
    main()
