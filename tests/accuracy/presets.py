#!/usr/bin/env python3
"""Measures the presets of --quality on a set of scenes, and prints what a trade of the same scenes offers instead.

    tests/accuracy/presets.py SCENE[@WxH] ... [--studies FOLDER] [--only draft preview final]

Error: the root of relMSE against two independent references of the preset `reference` with fewer samples (--reference-samples), whose noise is
subtracted. Time: of rendering, over that of 64 samples with the scene's own options beside it. --studies: the JSON files of `eikonal trade`, of
which the table lists the least error that any setting had in the preset's time. Prints a Markdown table; --json keeps the figures.
"""
import argparse
import json
import math
import pathlib
import statistics
import tempfile

from trade_check import ROOT, name_of, relative_mse, run


def render(o, scene, size, image, *options):
    return json.loads(run([o.program, "render", scene, *size, *options, "--json", "--quiet", "-o", image]).splitlines()[-1])["seconds"]["render"]


def measure(o, scene, size, folder):
    rows = []
    pair = [folder / f"reference-{seed}.exr" for seed in (1001, 1002)]
    for seed, image in zip((1001, 1002), pair):
        render(o, scene, size, image, "--quality", "reference", "--spp", o.reference_samples, "--seed", seed)
    between = relative_mse(o.program, *pair)
    for preset in o.only:
        usual = render(o, scene, size, folder / "usual.exr", "--spp", 64)
        squares, seconds = [], []
        for seed in range(o.seeds):
            image = folder / "image.exr"
            seconds.append(render(o, scene, size, image, "--quality", preset, "--seed", seed))
            squares.append((sum(relative_mse(o.program, image, r) for r in pair) - between) / 2)
        rows.append({"scene": name_of(scene), "preset": preset, "error": math.sqrt(max(statistics.mean(squares), 0)),
                     "seconds": statistics.median(seconds), "usualSeconds": usual})
    return rows


def geometric_mean(values):
    return math.exp(statistics.mean(math.log(max(v, 1e-9)) for v in values))


def table(rows, presets):
    text = "| scene | " + " | ".join(f"{p}: error | time" for p in presets) + " |\n|---|" + "--:|--:|" * len(presets) + "\n"
    for scene in dict.fromkeys(r["scene"] for r in rows):
        of = {r["preset"]: r for r in rows if r["scene"] == scene}
        text += f"| {scene} | " + " | ".join(f"{100 * of[p]['error']:.2g} % | {of[p]['seconds'] / of[p]['usualSeconds']:.2f}" for p in presets) + " |\n"
    means = [(geometric_mean([r["error"] for r in rows if r["preset"] == p]),
              geometric_mean([r["seconds"] / r["usualSeconds"] for r in rows if r["preset"] == p])) for p in presets]
    return text + "| geometric mean | " + " | ".join(f"{100 * e:.2g} % | {t:.2f}" for e, t in means) + " |\n"


def front(studies):
    """The settings that are on the front of most studies, by their samples."""
    counts = {}
    for file in studies:
        for point in json.loads(file.read_text())["points"]:
            if point["isOnFront"]:
                key = (point["setting"].partition(":")[0], round(point["samples"]))
                counts[key] = counts.get(key, 0) + 1
    return sorted(counts.items(), key=lambda item: (item[0][1], -item[1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--only", nargs="*", default=["draft", "preview", "final"])
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--reference-samples", type=int, default=2048)
    parser.add_argument("--studies", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    o = parser.parse_args()
    rows = []
    for word in o.scenes:
        path, _, size = word.partition("@")
        with tempfile.TemporaryDirectory() as name:
            rows += measure(o, pathlib.Path(path), ["--resolution", size] if size else [], pathlib.Path(name))
        print(table(rows, o.only), flush=True)
        if o.json:
            o.json.write_text(json.dumps(rows, indent=1) + "\n")
    if o.studies:
        for (setting, samples), count in front(sorted(o.studies.glob("*.json"))):
            print(f"{setting} with {samples} samples is on the front of {count} scenes")


if __name__ == "__main__":
    main()
