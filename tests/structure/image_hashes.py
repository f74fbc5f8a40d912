#!/usr/bin/env python3
"""A table of hashes of images: what a change of structure must leave as it is.

    image_hashes.py --program OLD --write before.csv SCENE_OR_FOLDER...
    image_hashes.py --program NEW --check before.csv SCENE_OR_FOLDER...

Renders every scene in RGB and at wavelengths, small and with few samples, and hashes the pixels of an uncompressed image
of floats. Hashes hold for one machine and one OpenCL implementation: compare programs, not machines. --kernels names the
folder that has `kernels/` of the program, where it is not the one that it was built in.
"""
import argparse
import csv
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

MODES = ("rgb", "spectral")


def scenes_in(paths):
    for path in map(pathlib.Path, paths):
        if path.is_dir():
            yield from sorted(p for p in path.iterdir() if p.suffix in (".pbrt", ".obj"))
        else:
            yield path


def hash_of(program, kernels, scene, mode, options):
    with tempfile.TemporaryDirectory() as folder:
        image = pathlib.Path(folder) / "image.pfm"
        environment = dict(os.environ, **({"EIKONAL_KERNELS": kernels} if kernels else {}))
        command = [program, "render", str(scene), "--color", mode, "--log-level", "error", "-o", str(image), *options]
        run = subprocess.run(command, env=environment, capture_output=True, text=True)
        if run.returncode:
            return "error: " + (run.stderr.strip().splitlines() or ["no message"])[0].replace(str(scene), scene.name)
        return hashlib.sha256(image.read_bytes()).hexdigest()[:24]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", help="scenes, or folders of them")
    parser.add_argument("--program", default="build/eikonal")
    parser.add_argument("--kernels", help="folder with kernels/ and include/")
    parser.add_argument("--resolution", default="64x48")
    parser.add_argument("--spp", default="4")
    parser.add_argument("--write", metavar="CSV")
    parser.add_argument("--check", metavar="CSV", help="exit status 1 where a hash is another than there")
    arguments = parser.parse_args()
    options = ["--resolution", arguments.resolution, "--spp", arguments.spp, "--seed", "1"]

    expected = {}
    if arguments.check:
        with open(arguments.check, newline="") as file:
            expected = {(row["scene"], row["color"]): row["hash"] for row in csv.DictReader(file)}
    rows, differing = [], 0
    for scene in scenes_in(arguments.scenes):
        for mode in MODES:
            found = hash_of(arguments.program, arguments.kernels, scene, mode, options)
            name = f"{scene.absolute().parent.name}/{scene.name}"
            rows.append((name, mode, found))
            known = expected.get((name, mode))
            if arguments.check and found != known:
                differing += 1
                print(f"{name} {mode}: {found}, was {known or 'not in the table'}", flush=True)
    if arguments.write:
        with open(arguments.write, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(("scene", "color", "hash"))
            writer.writerows(rows)
    print(f"{len(rows)} images, {differing} differ" if arguments.check else f"{len(rows)} images hashed")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
