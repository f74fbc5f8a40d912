#!/usr/bin/env python3
"""What options of OpenCL's compiler bring, stage by stage, and what they cost: speed and error, from which those that ship were chosen.

    tests/bench/flags.py [--options=-cl-mad-enable,-cl-fast-relaxed-math] SCENE ...

Runs the shipped kernels and those with each option by turns. Prints a table for each scene: the time of each stage over that of the shipped
one (the median of the ratios of neighbouring runs), and how far the image is from the shipped one with the same seed: relative MSE, and the
ratio of the means.
"""

import argparse
import json
import pathlib
import statistics
import tempfile

from paths import ROOT, bench, run

# Without contraction; denormals as zero; anything that rounds less carefully; all of that, and arithmetic reordered
OPTIONS = ["--contraction=off", "-cl-denorms-are-zero", "-cl-mad-enable", "-cl-unsafe-math-optimizations", "-cl-fast-relaxed-math"]


def argument(option):
    return option if option.startswith("--") else f"--build-options={option}"


def stage_times(program, scene, folder, samples, *options):
    figures = bench(program, scene, folder, "--spp", samples, "--repeats", 1, *options)
    return {stage["stage"]: stage["nanosecondsPerSlot"] for stage in figures["stages"]} | {"all": 1e9 / figures["pathsPerSecond"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--options", default=",".join(OPTIONS), help="separated by commas")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--samples", type=int, default=8)
    parser.add_argument("--rounds", type=int, default=3)
    o = parser.parse_args()
    options = o.options.split(",")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in o.scenes:
            image = ["render", scene, "--spp", o.samples, "--quiet", "-o"]
            run([o.program, *image, folder / "shipped.exr"])
            distance = {}
            for option in options:
                run([o.program, *image, folder / "other.exr", argument(option)])
                distance[option] = json.loads(run([o.program, "compare", folder / "other.exr", folder / "shipped.exr", "--json"]))
            ratios = {option: {} for option in options}
            for _ in range(o.rounds):
                for option in options:
                    shipped = stage_times(o.program, scene, folder, o.samples)
                    for stage, time in stage_times(o.program, scene, folder, o.samples, argument(option)).items():
                        ratios[option].setdefault(stage, []).append(time / shipped[stage])
            print(f"\n| {scene.parent.name} | {' | '.join(options)} |\n|---|{'--:|' * len(options)}")
            for stage in ratios[options[0]]:
                print(f"| {stage} | " + " | ".join(f"{statistics.median(ratios[option][stage]):.2f}" for option in options) + " |")
            print("| relative MSE to the shipped | " + " | ".join(f"{distance[option]['relativeMse']:.1g}" for option in options) + " |")
            print("| worst channel's mean, % off | " + " | ".join(f"{100 * distance[option]['worstMean']:.2g}" for option in options) + " |", flush=True)


if __name__ == "__main__":
    main()
