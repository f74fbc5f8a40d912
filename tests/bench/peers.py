#!/usr/bin/env python3
"""Eikonal against Mitsuba 3 on the same scene and machine, by turns: paths a second, and efficiency 1 / (relMSE x seconds).

    tests/bench/peers.py --mitsuba-python VENV/bin/python ../shared/scenes/peer-cornell/scene.pbrt

Beside SCENE.pbrt lies SCENE.xml, the same scene for Mitsuba. VENV has the package `mitsuba` from PyPI; mode llvm_ad_rgb needs an LLVM that
its drjit accepts (Debian's libllvm19; --llvm says where). Seconds are of rendering alone: no loading, no compiling; Mitsuba renders once
before it is timed. relMSE is taken against a render of ours with --reference-samples a pixel. Prints the median of the repeats.
"""

import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Reads a line for each render that is wanted, "SAMPLES SEED FILE", and answers with its seconds.
SERVER = """
import os, sys, time
import mitsuba
mitsuba.set_variant(sys.argv[1])
mitsuba.set_log_level(mitsuba.LogLevel.Error)
import drjit
if len(sys.argv) > 3: drjit.set_thread_count(int(sys.argv[3]))
scene = mitsuba.load_file(sys.argv[2])
for line in sys.stdin:
    samples, seed, file = line.split()
    start = time.perf_counter()
    image = mitsuba.render(scene, spp=int(samples), seed=int(seed))
    drjit.eval(image); drjit.sync_thread()
    seconds = time.perf_counter() - start
    mitsuba.Bitmap(image).write(file)
    print(seconds, flush=True)
"""


class Mitsuba:
    def __init__(self, python, variant, scene, llvm):
        self.name = f"mitsuba {variant}"
        environment = {"DRJIT_LIBLLVM_PATH": llvm, "PATH": "/usr/bin:/bin", "HOME": tempfile.gettempdir()}
        self.server = subprocess.Popen([python, "-c", SERVER, variant, scene], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)

    def render(self, samples, seed, image):
        self.server.stdin.write(f"{samples} {seed} {image}\n")
        self.server.stdin.flush()
        answer = self.server.stdout.readline()
        if not answer:
            sys.exit(f"peers: {self.name} ended without an image")
        return float(answer)


class Eikonal:
    name = "eikonal"

    def __init__(self, program, scene):
        self.program, self.scene = program, scene

    def render(self, samples, seed, image):
        command = [self.program, "render", self.scene, "--spp", samples, "--seed", seed, "--stats", "-o", image]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        seconds = re.search(r"^  render +([0-9.]+) s", done.stdout + done.stderr, re.MULTILINE)
        if done.returncode or not seconds:
            sys.exit(f"peers: {' '.join(map(str, command))} failed:\n{done.stderr}")
        return float(seconds[1])


def relative_error(program, image, reference):
    done = subprocess.run([str(program), "compare", "--json", str(image), str(reference)], capture_output=True, text=True)
    return json.loads(done.stdout)["relativeMse"]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scene", type=pathlib.Path)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--mitsuba-python", required=True)
    options.add_argument("--llvm", default="/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1")
    options.add_argument("--variants", nargs="*", default=["llvm_ad_rgb", "scalar_rgb"])
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--reference-samples", type=int, default=4096)
    options.add_argument("--repeats", type=int, default=5)
    options.add_argument("--width", type=int, default=512)
    options.add_argument("--height", type=int, default=512)
    options.add_argument("--json", type=pathlib.Path)
    o = options.parse_args()

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        ours = Eikonal(o.program, o.scene)
        reference = folder / "reference.exr"
        ours.render(o.reference_samples, 12345, reference)
        renderers = [ours] + [Mitsuba(o.mitsuba_python, v, str(o.scene.with_suffix(".xml")), o.llvm) for v in o.variants]
        for r in renderers:
            r.render(1, 0, folder / "warm.exr")
            r.render(o.samples, 0, folder / "warm.exr")
        seconds, errors = {r.name: [] for r in renderers}, {r.name: [] for r in renderers}
        for repeat in range(o.repeats):
            for r in renderers:
                image = folder / "image.exr"
                seconds[r.name].append(r.render(o.samples, repeat + 1, image))
                errors[r.name].append(relative_error(o.program, image, reference))

    paths = o.width * o.height * o.samples
    rows = {}
    for r in renderers:
        time, error = statistics.median(seconds[r.name]), statistics.median(errors[r.name])
        ratios = [theirs / mine for theirs, mine in zip(seconds[r.name], seconds[ours.name])]
        rows[r.name] = {"seconds": time, "Mpaths/s": paths / time * 1e-6, "relMSE": error, "efficiency": 1 / (time * error),
                        "our speed / theirs": statistics.median(ratios)}
        rows[r.name]["our efficiency / theirs"] = rows[r.name]["our speed / theirs"] * error / statistics.median(errors[ours.name])
    print(f"{o.scene}, {o.samples} samples, median of {o.repeats} by turns")
    print("| renderer | seconds | M paths/s | relMSE | our speed / theirs | our efficiency / theirs |\n|---|--:|--:|--:|--:|--:|")
    for name, row in rows.items():
        print(f"| {name} | {row['seconds']:.2f} | {row['Mpaths/s']:.2f} | {row['relMSE']:.3g} | {row['our speed / theirs']:.2f} | {row['our efficiency / theirs']:.2f} |")
    if o.json:
        o.json.write_text(json.dumps(rows, indent=2) + "\n")


if __name__ == "__main__":
    main()
