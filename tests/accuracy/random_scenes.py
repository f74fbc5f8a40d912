#!/usr/bin/env python3
"""Renders random scenes (random_scene.py) in two ways that should agree, and lists those that do not.

    tests/accuracy/random_scenes.py FOLDER --pbrt PROGRAM [--first 0] [--count 50]      beside pbrt-v4, at wavelengths
    tests/accuracy/random_scenes.py FOLDER --options "--integrator bdpt"                beside ourselves with other options

A scene agrees if no block of 8 x 8 pixels is further off than 5 % and four standard errors (eikonal compare --scatter), or none is with
eight times the samples. Light that only one of two methods finds (a point light through smooth glass) is a difference, too. Scenes that
pbrt-v4 fails to render, or where it finds values that are not numbers, are counted apart. FOLDER keeps scenes, images and messages. Exits
with 1 if a scene does not agree.
"""
import argparse
import pathlib
import shlex
import subprocess
import sys

import gallery
import random_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Fails(Exception):
    """A program did not render a scene. `is_ours`: ours."""

    def __init__(self, why, is_ours):
        super().__init__(why)
        self.is_ours = is_ours


def run(command, log, is_ours):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    if done.returncode != 0: raise Fails(f"{command[0]} ended with status {done.returncode}: {log}", is_ours)
    if not is_ours and "Not-a-number" in log.read_text():
        raise Fails(f"{command[0]} found values that are not numbers: {log}", is_ours)


def images_of(scene):
    return scene.with_suffix(".ours.exr"), scene.with_suffix(".theirs.exr")


def render_both(o, scene, samples):
    ours, theirs = images_of(scene)
    common = [o.program, "render", scene, "--spp", samples, "--quiet"]
    first = [*common, *(["--color", "spectral"] if o.pbrt else []), "-o", ours]
    second = ([o.pbrt, "--quiet", "--spp", samples, "--seed", 7, "--outfile", theirs, scene] if o.pbrt else
              [*common, "--seed", 7, *shlex.split(o.options), "-o", theirs])
    run(first, ours.with_suffix(".log"), is_ours=True)
    run(second, theirs.with_suffix(".log"), is_ours=not o.pbrt)


def difference(o, scene, samples):
    """How the images differ; empty if they agree."""
    render_both(o, scene, samples)
    numbers = gallery.compare(o.program, *images_of(scene), "--scatter")
    if not numbers: return "the images cannot be compared"
    if numbers["blocksOff"] == 0: return ""
    return f"means {' '.join(f'{r:.4f}' for r in gallery.distances(numbers))}, {numbers['blocksOff']} of {numbers['blocks']} blocks off"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    other = options.add_mutually_exclusive_group(required=True)
    other.add_argument("--pbrt", type=pathlib.Path, help="pbrt-v4's program")
    other.add_argument("--options", help="of eikonal render, for the second image")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--first", type=int, default=0, help="number of the first scene (default: %(default)s)")
    options.add_argument("--count", type=int, default=50, help="default: %(default)s")
    options.add_argument("--samples", type=int, default=256, help="per pixel (default: %(default)s)")
    o = options.parse_args()
    o.folder = o.folder.resolve()
    o.folder.mkdir(parents=True, exist_ok=True)
    differ = failed = 0
    for seed in range(o.first, o.first + o.count):
        made = random_scene.Scene(seed, without_coats=bool(o.pbrt))
        scene = o.folder / f"{seed:05}.pbrt"
        scene.write_text(made.text(o.samples))
        try:
            problem = difference(o, scene, o.samples) and difference(o, scene, 8 * o.samples)
            differ += bool(problem)
        except Fails as why:
            problem = str(why)
            differ += why.is_ours
            failed += not why.is_ours
        if problem: print(f"{scene.name}: {problem}; {', '.join(sorted(set(made.tags)))}", flush=True)
    print(f"{o.count - failed - differ} of {o.count - failed} scenes agree" + (f"; pbrt-v4 failed in {failed}" if failed else ""))
    sys.exit(1 if differ else 0)


if __name__ == "__main__":
    main()
