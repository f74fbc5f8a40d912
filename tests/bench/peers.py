#!/usr/bin/env python3
"""Eikonal against other renderers on the same scenes and machine, by turns: paths a second, and efficiency 1 / (relMSE x seconds).

    tests/bench/peers.py SCENE.pbrt ... [--pbrt PBRT] [--mitsuba-python VENV/bin/python]

PBRT is pbrt-v4's program, which renders the same file; at wavelengths, as it always does, so its rows are beside ours at wavelengths. VENV has the
package `mitsuba` from PyPI; mode llvm_ad_rgb needs an LLVM that its drjit accepts (Debian's libllvm19; --llvm says where). It renders
SCENE.xml, the same scene for Mitsuba, where there is one. Seconds are of rendering alone: no loading, no compiling; every renderer renders
once before it is timed. relMSE is taken against a render of ours with --reference-samples a pixel, in RGB or at wavelengths as the renderer.
Prints medians of the repeats.
"""

import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Reads a line for each render that is wanted, "SAMPLES SEED FILE", and answers with its seconds.
SERVER = """
import os, sys, time
import mitsuba
mitsuba.set_variant(sys.argv[1])
mitsuba.set_log_level(mitsuba.LogLevel.Error)
import drjit
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
    color = "rgb"

    def __init__(self, python, variant, scene, llvm):
        self.name = f"Mitsuba {variant}"
        environment = {"DRJIT_LIBLLVM_PATH": llvm, "PATH": "/usr/bin:/bin", "HOME": tempfile.gettempdir()}
        self.server = subprocess.Popen([python, "-c", SERVER, variant, scene], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)

    def render(self, samples, seed, image):
        self.server.stdin.write(f"{samples} {seed} {image}\n")
        self.server.stdin.flush()
        answer = self.server.stdout.readline()
        if not answer:
            sys.exit(f"peers: {self.name} ended without an image")
        return float(answer)


class Program:
    """A renderer that is a command, whose output says how long it rendered: what `seconds` finds there last."""

    def __init__(self, name, color, command, image_option, seconds):
        self.name, self.color, self.command, self.image_option, self.seconds = name, color, command, image_option, seconds

    def render(self, samples, seed, image):
        command = [str(word) for word in [*self.command, "--spp", samples, "--seed", seed, self.image_option, image]]
        done = subprocess.run(command, capture_output=True, text=True)
        seconds = re.findall(self.seconds, done.stdout + done.stderr, re.MULTILINE)
        if done.returncode or not seconds:
            sys.exit(f"peers: {' '.join(command)} failed:\n{done.stderr}")
        return float(seconds[-1])


def eikonal(program, scene, color):
    name = "Eikonal" if color == "rgb" else "Eikonal, at wavelengths"
    return Program(name, color, [program, "render", scene, "--stats", "--color", color], "-o", r"^  render +([0-9.]+) s")


def pbrt(program, scene):
    return Program("pbrt-v4", "spectral", [program, scene], "--outfile", r"\(([0-9.]+)s\)")


def relative_error(program, image, reference):
    done = subprocess.run([str(program), "compare", "--json", str(image), str(reference)], capture_output=True, text=True)
    return json.loads(done.stdout)["relativeMse"]


def measure(o, scene, add):
    """Renders a scene with all who can, and adds their rows."""
    info = json.loads(subprocess.run([str(o.program), "info", "--json", str(scene)], capture_output=True, text=True, check=True).stdout)
    renderers = [eikonal(o.program, scene, "rgb")]
    if o.pbrt:
        renderers += [eikonal(o.program, scene, "spectral"), pbrt(o.pbrt, scene)]
    if o.mitsuba_python and scene.with_suffix(".xml").exists():
        renderers += [Mitsuba(o.mitsuba_python, v, str(scene.with_suffix(".xml")), o.llvm) for v in o.variants]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for color in {r.color for r in renderers}:
            eikonal(o.program, scene, color).render(o.reference_samples, 12345, folder / f"{color}.exr")
        image = folder / "image.exr"
        for r in renderers:
            r.render(1, 0, image)
            r.render(o.samples, 0, image)
        seconds, errors = {r.name: [] for r in renderers}, {r.name: [] for r in renderers}
        for repeat in range(o.repeats):
            for r in renderers:
                seconds[r.name].append(r.render(o.samples, repeat + 1, image))
                errors[r.name].append(relative_error(o.program, image, folder / f"{r.color}.exr"))

    for r in renderers:
        ours = next(x.name for x in renderers if x.color == r.color)
        time, error = statistics.median(seconds[r.name]), statistics.median(errors[r.name])
        speed = statistics.median(theirs / mine for theirs, mine in zip(seconds[r.name], seconds[ours]))
        add(f"{scene.parent.name}/{scene.name}", r.name, info["width"] * info["height"] * o.samples / time * 1e-6, error, speed, speed * error / statistics.median(errors[ours]))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="+", type=pathlib.Path)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--pbrt", type=pathlib.Path)
    options.add_argument("--mitsuba-python")
    options.add_argument("--llvm", default="/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1")
    options.add_argument("--variants", nargs="*", default=["llvm_ad_rgb", "scalar_rgb"])
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--reference-samples", type=int, default=4096)
    options.add_argument("--repeats", type=int, default=5)
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("peers", {"scene": None, "renderer": None, "M paths/s": ".2f", "relMSE": ".3g", "our speed / theirs": ".2f", "our efficiency / theirs": ".2f"})
    for scene in o.scenes:
        measure(o, scene, add)


if __name__ == "__main__":
    main()
