#!/usr/bin/env python3
"""Renders random scenes (random_scene.py), or given ones, in two ways that should agree, and lists those that do not.

    tests/accuracy/random_scenes.py FOLDER --pbrt PROGRAM [--first 0] [--count 50]      beside pbrt-v4, at wavelengths
    tests/accuracy/random_scenes.py FOLDER --options "--integrator bdpt"                beside ourselves with other options
    tests/accuracy/random_scenes.py FOLDER --pbrt PROGRAM --scenes FILE ...             given scenes

A scene agrees if no block of 8 x 8 pixels is further off than 5 % and four standard errors (eikonal compare --scatter), or none is with
eight times the samples. Light that only one of two methods finds (a point light through smooth glass) is a difference, too. Scenes that
pbrt-v4 fails to render, or where it finds values that are not numbers, are counted apart, and so are given scenes that neither of us
renders. FOLDER keeps scenes, images and messages. Exits with 1 if a scene does not agree.
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


class Scene:
    """A scene file, the name of its images in the folder, and what is in it, as far as known."""

    def __init__(self, path, name, tags=()):
        self.path, self.name, self.tags = path, name, sorted(set(tags))


def run(command, log, is_ours):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    log.write_text(done.stdout + done.stderr)
    if done.returncode != 0: raise Fails(f"{command[0]} ended with status {done.returncode}: {log}", is_ours)
    if not is_ours and "Not-a-number" in log.read_text():
        raise Fails(f"{command[0]} found values that are not numbers: {log}", is_ours)


def render_both(o, scene, samples, ours, theirs):
    common = [o.program, "render", scene.path, "--spp", samples, "--quiet"]
    first = [*common, *(["--color", "spectral"] if o.pbrt else []), "-o", ours]
    second = ([o.pbrt, "--quiet", "--spp", samples, "--seed", 7, "--outfile", theirs, scene.path] if o.pbrt else
              [*common, "--seed", 7, *shlex.split(o.options), "-o", theirs])
    try:
        run(first, ours.with_suffix(".log"), is_ours=True)
    except Fails:
        if o.scenes: run(second, theirs.with_suffix(".log"), is_ours=not o.pbrt)
        raise
    run(second, theirs.with_suffix(".log"), is_ours=not o.pbrt)


def difference(o, scene, samples):
    """How the images differ; empty if they agree."""
    images = [o.folder / f"{scene.name}.{whose}.exr" for whose in ("ours", "theirs")]
    render_both(o, scene, samples, *images)
    numbers = gallery.compare(o.program, *images, "--scatter")
    if not numbers: return "the images cannot be compared"
    if numbers["blocksOff"] == 0: return ""
    return f"means {' '.join(f'{r:.4f}' for r in gallery.distances(numbers))}, {numbers['blocksOff']} of {numbers['blocks']} blocks off"


def random_scenes(o):
    for seed in range(o.first, o.first + o.count):
        made = random_scene.Scene(seed, without_coats=bool(o.pbrt))
        path = o.folder / f"{seed:05}.pbrt"
        path.write_text(made.text(o.samples))
        yield Scene(path, path.stem, made.tags)


def given_scenes(o):
    for path in o.scenes: yield Scene(path.resolve(), f"{path.resolve().parent.name}-{path.name.partition('.')[0]}")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    other = options.add_mutually_exclusive_group(required=True)
    other.add_argument("--pbrt", type=pathlib.Path, help="pbrt-v4's program")
    other.add_argument("--options", help="of eikonal render, for the second image")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--scenes", type=pathlib.Path, nargs="+", help="files to render instead of random scenes")
    options.add_argument("--first", type=int, default=0, help="number of the first scene (default: %(default)s)")
    options.add_argument("--count", type=int, default=50, help="default: %(default)s")
    options.add_argument("--samples", type=int, default=256, help="per pixel (default: %(default)s)")
    o = options.parse_args()
    o.folder = o.folder.resolve()
    o.folder.mkdir(parents=True, exist_ok=True)
    count = differ = failed = 0
    for scene in given_scenes(o) if o.scenes else random_scenes(o):
        count += 1
        try:
            problem = difference(o, scene, o.samples) and difference(o, scene, 8 * o.samples)
            differ += bool(problem)
        except Fails as why:
            problem = str(why)
            differ += why.is_ours
            failed += not why.is_ours
        if problem: print(f"{scene.path.name}: {problem}" + (f"; {', '.join(scene.tags)}" if scene.tags else ""), flush=True)
    print(f"{count - failed - differ} of {count - failed} scenes agree" + (f"; pbrt-v4 failed in {failed}" if failed else ""))
    sys.exit(1 if differ else 0)


if __name__ == "__main__":
    main()
