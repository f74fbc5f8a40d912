#!/usr/bin/env python3
"""Renders random scenes (random_scene.py) in two ways that should agree, and lists those that do not.

    tests/accuracy/random_scenes.py FOLDER --pbrt PROGRAM [--first 0] [--count 50]      beside pbrt-v4, at wavelengths
    tests/accuracy/random_scenes.py FOLDER --options "--integrator bdpt"                beside ourselves with other options

A scene agrees if no block of 8 x 8 pixels is further off than 5 % and four standard errors (eikonal compare --scatter). Light that only
one of two methods finds (a point light through smooth glass) is a difference, too. FOLDER keeps scenes, images and messages. Exits with 1
if a scene does not agree.
"""
import argparse
import pathlib
import shlex
import subprocess
import sys

import gallery
import random_scene

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(command, log):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    return "" if done.returncode == 0 else f"{command[0]} ended with status {done.returncode}: {log}"


def images_of(scene):
    return scene.with_suffix(".ours.exr"), scene.with_suffix(".theirs.exr")


def render_both(o, scene):
    """What failed; empty if both images are there."""
    ours, theirs = images_of(scene)
    common = [o.program, "render", scene, "--spp", o.samples, "--quiet"]
    first = [*common, *(["--color", "spectral"] if o.pbrt else []), "-o", ours]
    second = ([o.pbrt, "--quiet", "--spp", o.samples, "--seed", 7, "--outfile", theirs, scene] if o.pbrt else
              [*common, "--seed", 7, *shlex.split(o.options), "-o", theirs])
    return run(first, ours.with_suffix(".log")) or run(second, theirs.with_suffix(".log"))


def difference(o, scene):
    """How the images differ; empty if they agree."""
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
    differ = 0
    for seed in range(o.first, o.first + o.count):
        made = random_scene.Scene(seed, without_coats=bool(o.pbrt))
        scene = o.folder / f"{seed:05}.pbrt"
        scene.write_text(made.text(o.samples))
        problem = render_both(o, scene) or difference(o, scene)
        differ += bool(problem)
        if problem: print(f"{scene.name}: {problem}; {', '.join(sorted(set(made.tags)))}", flush=True)
    print(f"{o.count - differ} of {o.count} scenes agree")
    sys.exit(1 if differ else 0)


if __name__ == "__main__":
    main()
