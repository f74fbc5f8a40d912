#!/usr/bin/env python3
"""Chooses the presets of --quality from a Pareto front over a set of scenes, and measures them.

    tests/accuracy/presets.py trade SCENE[@WxH] ... --studies FOLDER [--budget 60s]   runs `eikonal trade` on each scene
    tests/accuracy/presets.py front --studies FOLDER [--samples 8,32] [--write]      the front of all studies: printed, or put into docs/trade.md
    tests/accuracy/presets.py measure SCENE[@WxH] ... [--only=draft,preview,final]  measures the presets, and options beside them

front: a study has a model of error and time for each setting. For each setting that most scenes have; in the others it has no effect
(RGB of a grey scene), and each power of two of samples: the geometric means, over the scenes, of the error, and of the time over that of 64
samples with the scene's own options. A point is on the front if no other has less of both, 10 % allowed for noise.
Settings whose options depend on the scene (clamping at multiples of its mean) are left out.
measure: the root of relMSE against two independent references of the preset `reference` with fewer samples (--reference-samples), whose noise
is subtracted. Time: of rendering, over that of 64 samples with the scene's own options beside it.
Prints Markdown tables; --json keeps the figures; `measure --from FILE` puts the table into docs/trade.md.
"""
import argparse
import json
import math
import pathlib
import shlex
import statistics
import tempfile

from page import put
from trade_check import ROOT, name_of, relative_mse, run

USUAL_SAMPLES = 64


def geometric_mean(values):
    return math.exp(statistics.mean(math.log(max(v, 1e-9)) for v in values))


def scenes_of(o):
    for word in o.scenes:
        path, _, size = word.partition("@")
        yield pathlib.Path(path), [f"--resolution={size}"] if size else []


def trade(o):
    o.studies.mkdir(parents=True, exist_ok=True)
    for scene, size in scenes_of(o):
        run([o.program, "trade", scene, *size, "--budget", o.budget, "--quiet", "-o", o.studies / f"{name_of(scene)}.html"])
        print(f"studied {scene}", flush=True)


def error_of(model, samples):
    return math.sqrt(model["biasSquare"] + model["varianceOfOneSample"] * samples ** model["slope"]["value"])


def candidates(studies):
    """(setting, samples, error, time) of each setting that is measured in more than half of the studies; in the others it is as given."""
    models = [{m["setting"]: m for m in study["settings"]} for study in studies]
    names = {name for of in models for name in of if not name.startswith(("clamping", "adaptive", "combination", "compiler", "unbiased"))}
    for name in sorted(names):
        if sum(name in of for of in models) * 2 <= len(models):
            continue
        for samples in (2 ** k for k in range(0, 13)):
            error = geometric_mean(error_of(of.get(name, of["as given"]), samples) for of in models)
            time = geometric_mean(of.get(name, of["as given"])["secondsPerSample"] * samples / (of["as given"]["secondsPerSample"] * USUAL_SAMPLES)
                                  for of in models)
            yield name, samples, error, time


def front(o):
    points = sorted(candidates([json.loads(f.read_text()) for f in sorted(o.studies.glob("*.json"))]), key=lambda p: p[3])
    text = "| samples | setting | error | time |\n|--:|---|--:|--:|\n"
    for name, samples, error, time in points:
        if samples not in o.samples:
            continue
        if not any(e <= error * 0.9 and t <= time for _, _, e, t in points) and not any(e < error and t < time * 0.9 for _, _, e, t in points):
            text += f"| {samples} | {name} | {100 * error:.2g} % | {time:.2g} |\n"
    put(ROOT / "docs" / "trade.md", "<!-- front: made by tests/accuracy/presets.py -->\n", text, "<!-- end of front -->", only_print=not o.write)


def render(o, scene, size, image, *options):
    return json.loads(run([o.program, "render", scene, *size, *options, "--json", "--quiet", "-o", image]).splitlines()[-1])["seconds"]["render"]


def measure_scene(o, scene, size, folder):
    rows = []
    pair = [folder / f"reference-{seed}.exr" for seed in (1001, 1002)]
    for seed, image in zip((1001, 1002), pair):
        render(o, scene, size, image, "--quality", "reference", "--spp", o.reference_samples, "--seed", seed)
    between = relative_mse(o.program, *pair)
    for preset in o.only:
        options = shlex.split(preset) if preset.startswith("--") else ["--quality", preset]
        ratios, squares = [], []
        for seed in range(o.seeds):
            image = folder / "image.exr"
            usual = render(o, scene, size, folder / "usual.exr", "--spp", USUAL_SAMPLES)
            ratios.append(render(o, scene, size, image, *options, "--seed", seed) / usual)
            squares.append((sum(relative_mse(o.program, image, r) for r in pair) - between) / 2)
        square = statistics.mean(squares)
        rows.append({"scene": name_of(scene), "preset": preset, "error": math.sqrt(square) if square > 0.1 * between else None,
                     "time": statistics.median(ratios)})
    return rows


def table(rows):
    presets = list(dict.fromkeys(r["preset"] for r in rows))
    text = "| scene | " + " | ".join(f"`{p}`: error | time" for p in presets) + " |\n|---|" + "--:|--:|" * len(presets) + "\n"
    for scene in dict.fromkeys(r["scene"] for r in rows):
        of = {r["preset"]: r for r in rows if r["scene"] == scene}
        text += f"| {scene} | " + " | ".join(f"{format_error(of[p]['error'])} | {of[p]['time']:.2g}" for p in presets) + " |\n"
    means = [(geometric_mean([r["error"] for r in rows if r["preset"] == p and r["error"]]),
              geometric_mean([r["time"] for r in rows if r["preset"] == p])) for p in presets]
    return text + "| geometric mean | " + " | ".join(f"{format_error(e)} | {t:.2g}" for e, t in means) + " |\n"


def format_error(error):
    return f"{100 * error:.2g} %" if error else "below the references'"


def measure(o):
    rows = json.loads(o.kept.read_text()) if o.kept else []
    for scene, size in scenes_of(o):
        with tempfile.TemporaryDirectory() as name:
            rows += measure_scene(o, scene, size, pathlib.Path(name))
        if o.json:
            o.json.write_text(json.dumps(rows, indent=1) + "\n")
    put(ROOT / "docs" / "trade.md", "<!-- presets: made by tests/accuracy/presets.py -->\n", table(rows), "<!-- end of presets -->", only_print=not o.kept)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=["trade", "front", "measure"])
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--studies", type=pathlib.Path, default=pathlib.Path("studies"))
    parser.add_argument("--budget", default="60s")
    parser.add_argument("--only", type=lambda text: text.split(","), default=["draft", "preview", "final"],
                        help="presets, or options in their place, separated by commas: 'draft,--spp=8 --max-depth=3'")
    parser.add_argument("--samples", type=lambda text: [int(n) for n in text.split(",")], default=[2 ** k for k in range(13)],
                        help="the rows of the front, powers of two separated by commas")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--reference-samples", type=int, default=2048)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--from", type=pathlib.Path, dest="kept")
    o = parser.parse_args()
    {"trade": trade, "front": front, "measure": measure}[o.task](o)


if __name__ == "__main__":
    main()
