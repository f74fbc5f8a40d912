#!/usr/bin/env python3
"""Open Job Description: `openjd run` renders and merges an image in chunks of tiles and ranges of samples.

    tests/farm/openjd.py [--program build/eikonal]

Installs openjd-cli of PyPI into a folder of its own; skipped without it.
"""

import json
import os
import pathlib
import re

from farm_test import SCENE, environment_with, expect, pixels_of, program, run, scratch


def main():
    eikonal = program()
    with scratch() as name:
        top = pathlib.Path(name)
        environment = os.environ | {"PATH": environment_with(top / "venv", "openjd-cli") + ":" + os.environ["PATH"]}
        settings = ["--spp", "64", "--resolution", "96x64", "--aov", "depth"]
        folder = top / "a job"

        # As it is handed over, with its progress
        text = run(eikonal, "submit", SCENE, "--engine", "openjd", "--tiles", 3, "--sample-ranges", 2, "--folder", folder, *settings, "-o",
                   top / "the image.exr", "-o", top / "all.film", env=environment)
        progress = [float(value) for value in re.findall(r"openjd_progress: ([0-9.]+)", text)]
        expect(progress.count(100.0) == 6 and all(0 <= value <= 100 for value in progress), "each part says when it is whole")
        expect("openjd_status: rendering" in text, "parts say what they do")
        expect("merged 6 parts into" in text and (top / "the image.exr").exists(), "the merge ran after the parts")
        run(eikonal, "render", SCENE, *settings, "-o", top / "whole.film")
        expect(pixels_of(top / "all.film") == pixels_of(top / "whole.film"), "all sums have the bits of one run")

        # The template by itself, with chunks of two tiles
        template, parameters = folder / "eikonal.yaml", f"file://{folder / 'parameters.json'}"
        run("openjd", "check", template, env=environment)
        other = ["-p", f"Parts={top / 'chunked'}", "-p", "TilesPerTask=2", "-p", "ImageOptions=-o chunked.film"]
        text = run("openjd", "run", template, "-p", parameters, *other, env=environment, cwd=top)
        expect(re.findall(r"Tiles\(CHUNK\[INT\]\) = (\S+)", text) == ["1-2", "1-2", "3-3", "3-3"], "a task renders a chunk of tiles")
        expect(len(list((top / "chunked").glob("*.film"))) == 6, "a chunk leaves a part for each of its tiles")

        # An animation: tasks of frames, whose images are those of single renders; once more, nothing is rendered
        (top / "frames").mkdir()
        job, words = top / "animation", ["--fps", 24, "--spp", 16, "--resolution", "48x32"]
        run(eikonal, "submit", SCENE, "--engine", "openjd", "--frames", "0-4,9", "--frames-per-task", 4, "--folder", job, *words, "-o",
            top / "frames" / "f.##.exr", env=environment)
        run(eikonal, "render", SCENE, "--frames", 9, *words, "-o", top / "single.##.exr")
        expect(len(list((top / "frames").glob("*.exr"))) == 6, "all frames are there")
        compared = json.loads(run(eikonal, "compare", top / "frames" / "f.09.exr", top / "single.09.exr", "--json"))
        expect(compared["relativeMse"] == 0, "a frame is that of a single render")
        again = run("bash", job / "submit.sh", env=environment)
        expect(again.count("skipped frame") == 6, "frames that are whole are skipped")

        # A part that fails, fails the job, and says why
        text = run("openjd", "run", template, "-p", parameters, "-p", "Scene=missing.pbrt", "-p", f"Parts={top / 'none'}", status=None, env=environment)
        expect(re.search(r"openjd_fail: .*missing\.pbrt", text) and "merged" not in text, "an error is told, and nothing is merged")


if __name__ == "__main__":
    main()
