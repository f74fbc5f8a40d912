#!/usr/bin/env python3
"""Eikonal against other renderers on the same scenes and machine: error per second.

    tests/bench/peers.py --harness ../shared/peers [SCENE ...] [--renderers mi-llvm,cycles] [--samples 64] [--rounds 3] [--json FILE]

The harness says where the other renderers are (its README.md) and starts them. Scenes are those of peer_scenes.py; --list prints their names. All
renderers take turns, with the same samples a pixel, a seed for each round and one round that does not count. relMSE is the variance between the rounds, as
`eikonal bench --efficiency` takes it, relative to the mean of all images of all renderers: no reference is rendered. Efficiency is 1 / (relMSE x seconds).
Seconds are of rendering, without loading and compiling; "wall" is the whole process, "CPU" its processor time less that of a render of one sample, which other
work on the machine hurts less. Ratios are medians over the rounds, with the least and the largest. "mean off" is how far the mean radiance is from ours, with
the standard error that the rounds show: where models are equal it is noise. pbrt-v4 renders at wavelengths, so its rows compare it with Eikonal at wavelengths.
"""

import argparse
import importlib
import math
import os
import pathlib
import re
import statistics
import sys
import types

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent

NAMES = {"eikonal": "Eikonal", "eikonal-spectral": "Eikonal, at wavelengths", "mi-llvm": "Mitsuba llvm_ad_rgb", "mi-scalar": "Mitsuba scalar_rgb", "cycles": "Cycles", "lux": "LuxCore PATHCPU",
         "pbrt": "pbrt-v4", "pbrt-wf": "pbrt-v4 --wavefront"}
COLOR = {"eikonal": "rgb", "eikonal-spectral": "spectral"}
DEPENDENT = {"pbrt": "eikonal-spectral", "pbrt-wf": "eikonal-spectral"}
CLOCKS = ("render", "wall", "cpu")
COLUMNS = {"scene": None, "renderer": None, "samples": "d", "render, s": ".2f", "wall, s": ".2f", "CPU, s": ".2f", "relMSE": ".3g", "our efficiency / theirs": ".2f", "least": ".2f", "largest": ".2f",
           "by wall": ".2f", "by CPU": ".2f", "mean off, %": "+.2f", "+-": ".2f"}


class Peers:
    """The renderers that the harness finds here."""

    def __init__(self, o):
        sys.path.insert(0, str(o.harness))
        self.harness = importlib.import_module("run")   # starts this script again in the environment that has numpy and OpenEXR, if need be
        self.read = importlib.import_module("exr").read
        self.program, self.threads = str(o.program.resolve()), o.threads
        self.options = types.SimpleNamespace(threads=o.threads, eikonal=self.program, eikonal_args="")

    def has(self, renderer):
        return self.harness.available(renderer.removesuffix("-spectral"), self.options)

    def render(self, renderer, folder, samples, seed, image):
        """Seconds of rendering, of the whole process and of processor time, and the pixels."""
        if renderer in COLOR:
            command, environment = [self.program, "render", folder / "scene.pbrt", "--spp", samples, "--seed", seed, "--color", COLOR[renderer], "--stats", "--nthreads", self.threads, "-o", image], {}
        elif renderer == "cycles":
            command, environment = [self.harness.BPY, HERE / "peer_cycles.py", folder / "scene.json", samples, seed, image, self.threads], {}
        else:
            command, environment = self.harness.command(renderer, str(folder), samples, seed, str(image), self.options)
        image.unlink(missing_ok=True)
        done = self.harness.launch([str(word) for word in command], environment, 3600, b"Rendering:" if renderer.startswith("pbrt") else None)
        text = done["text"]
        if done["rc"] or not image.exists():
            raise RuntimeError(text[-600:])
        ours = re.findall(r"^  render +([0-9.]+) s", text, re.MULTILINE)
        render = float(ours[-1]) if renderer in COLOR else self.harness.split(renderer, done, samples)["render"]
        return {"render": render or done["wall"], "wall": done["wall"], "cpu": done["cpu"]}, self.read(image)


def relative_variance(images, reference):
    """Of some renders with different seeds: host/image/seed_variance.h."""
    import numpy as np
    return float((np.var(images, axis=0, ddof=1, dtype=float) / (reference**2 + 0.01 * reference.mean() ** 2)).mean())


def difference(theirs, ours):
    """Of the means of rounds: theirs off ours, and its standard error, in percent."""
    ratio = theirs.mean() / ours.mean()
    return 100 * (ratio - 1), 100 * ratio * math.sqrt(sum(m.var(ddof=1) / len(m) / m.mean() ** 2 for m in (theirs, ours)))


def measure(o, peers, scene, folder, add):
    """Renders a scene with all who can, and adds their rows."""
    import numpy as np
    renderers = [r for r in o.renderers if peers.has(r)]
    renderers = list(dict.fromkeys(["eikonal", *(DEPENDENT[r] for r in renderers if r in DEPENDENT), *renderers]))
    times, images, idle = {r: [] for r in renderers}, {r: [] for r in renderers}, {}
    for turn in range(-2, o.rounds):   # the first fills caches, the second shows what a render of one sample takes
        for r in list(renderers):
            try:
                seconds, image = peers.render(r, folder, o.samples if turn >= 0 else 1, max(turn, -1) + 1, folder / f"{r}.exr")
            except RuntimeError as error:
                print(f"peers: {NAMES[r]} fails on {scene}: {error}", file=sys.stderr)
                renderers.remove(r)
                continue
            if turn < 0:
                idle[r] = seconds["cpu"]
                continue
            times[r].append(seconds | {"cpu": seconds["cpu"] - idle[r]})
            images[r].append(np.nan_to_num(image, posinf=0, neginf=0))

    reference = np.mean([image for r in renderers for image in images[r]], axis=0, dtype=float)
    error = {r: relative_variance(images[r], reference) for r in renderers}
    mean = {r: np.mean(images[r], axis=(1, 2, 3), dtype=float) for r in renderers}   # of each round
    for r in renderers:
        ours = DEPENDENT.get(r, "eikonal")
        ratios = {clock: [error[r] / error[ours] * theirs[clock] / mine[clock] for theirs, mine in zip(times[r], times[ours])] for clock in CLOCKS}
        middle = {clock: statistics.median(ratios[clock]) for clock in CLOCKS}
        compared = (None,) * 5 if r in COLOR else (middle["render"], min(ratios["render"]), max(ratios["render"]), middle["wall"], middle["cpu"])
        add(scene, NAMES[r], o.samples, *(statistics.median(seconds[clock] for seconds in times[r]) for clock in CLOCKS), error[r], *compared, *difference(mean[r], mean[ours]))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="*")
    options.add_argument("--harness", type=pathlib.Path, required=True, metavar="FOLDER")
    options.add_argument("--list", action="store_true", help="print the names of the scenes")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--renderers", type=lambda text: text.split(","), default=[r for r in NAMES if r not in COLOR], help="of: " + " ".join(r for r in NAMES if r not in COLOR))
    options.add_argument("--samples", type=int, default=64)
    options.add_argument("--rounds", type=int, default=3, help="at least 2")
    options.add_argument("--size", type=int, default=512, help="pixels across")
    options.add_argument("--threads", type=int, default=os.cpu_count())
    options.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("/tmp/eikonal-peers"), help="scenes and images stay here")
    Report.add_to(options)
    o = options.parse_args()
    peers = Peers(o)
    import peer_formats
    import peer_scenes
    sys.path.insert(0, str(o.harness / "clay"))
    scenes = peer_scenes.generators(importlib.import_module("convert").read_ply)
    if o.list:
        print("\n".join(scenes))
        return
    unknown = [name for name in o.scenes if name not in scenes]
    if unknown:
        options.error(f"no scene {unknown[0]}; there are {', '.join(scenes)}")
    for absent in (r for r in o.renderers if not peers.has(r)):
        print(f"peers: {NAMES[absent]} is not here", file=sys.stderr)
    add = Report(o.json).table("efficiency", COLUMNS)
    for scene in o.scenes or scenes:
        peer_formats.write(scenes[scene](), o.folder / scene, o.size)
        measure(o, peers, scene, o.folder / scene, add)


if __name__ == "__main__":
    main()
