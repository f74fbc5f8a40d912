#!/usr/bin/python3
"""Whether the error that is asked for (--max-error) is the error that is delivered, and the error that is reported is the true one: the table of docs/accuracy.md.

    tests/accuracy/error_asked.py --seeds 20                   in full: ten scenes, three targets; some hours on two cores
    tests/accuracy/error_asked.py --scenes light-many --print  one scene, and write nothing
    tests/accuracy/error_asked.py --held-out a.pbrt b.pbrt     other scenes than those listed below, at 96 x 96 pixels

Scenes of ../shared that are missing are left out. For each scene, target and seed: a render with --max-error, of at most --most samples. Its true error is the root of the
mean, over the pixels, of (x - r)^2 / (r^2 + 0.01): x is the luminance of a pixel, r that of the mean of two renders of --reference-samples samples and other seeds, whose own
noise, a fourth of their squared distance, is subtracted from (x - r)^2. Each run is kept in --results (JSON) at once, and those that are there are not done again; a changed program
needs a new file. A run is flagged if the program says that its estimate is not reliable.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio

import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "accuracy.md"
BEGIN, END = "<!-- table: made by tests/accuracy/error_asked.py -->\n", "<!-- end of the table of errors asked for -->\n"
SHARED = ROOT.parent / "shared"
# Scene, resolution, samples of each reference; further options of the references, where another unbiased integrator has less noise.
SCENES = {
    "cornell-box": (SHARED / "scenes/cornell-box/scene-v4.pbrt", "96x96", 16384),
    "veach-mis": (SHARED / "scenes/veach-mis/scene-v4.pbrt", "112x63", 16384),
    "coffee": (SHARED / "scenes/coffee/scene-v4.pbrt", "80x100", 4096),
    "light-many": (SHARED / "gallery/light-many.pbrt", "96x96", 8192),
    "classroom": (SHARED / "scenes/classroom/scene-v4.pbrt", "96x54", 16384),
    "veach-bidir": (SHARED / "scenes/veach-bidir/scene-v4.pbrt", "80x80", 4096, "--integrator", "bdpt"),
    "staircase2": (SHARED / "scenes/staircase2/scene-v4.pbrt", "80x80", 8192),
    "peer-cornell": (SHARED / "scenes/peer-cornell/scene.pbrt", "96x96", 8192),
    "materials": (ROOT / "scenes/materials.pbrt", "96x96", 8192),
    "environment": (ROOT / "scenes/environment.pbrt", "96x96", 8192),
}


def render(o, scene, resolution, seed, *more):
    """The luminance of the pixels, and the file's attributes."""
    image = o.renders / "image.exr"
    command = [o.program, "render", scene, "--quiet", "--resolution", resolution, "--seed", seed, "-o", image, *more]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"error_asked.py: {' '.join(map(str, command))} failed:\n{done.stderr}")
    # Not by ImageBuf, whose cache takes a file of the same second for the last one
    file = oiio.ImageInput.open(str(image))
    attributes = {a.name: a.value for a in file.spec().extra_attribs}
    pixels = np.array(file.read_image(oiio.FLOAT))[:, :, :3].astype(float)
    file.close()
    return pixels @ np.array([0.2126, 0.7152, 0.0722]), attributes


def reference(o, name, scene, resolution, samples, *more):
    """The mean of two renders, and the squared error of that mean."""
    files = [o.renders / f"{name}-{resolution}-{samples}-{seed}.npy" for seed in (1001, 1002)]
    for seed, file in zip((1001, 1002), files):
        if not file.exists():
            np.save(file, render(o, scene, resolution, seed, "--spp", samples, *more)[0])
    a, b = (np.load(file) for file in files)
    return (a + b) / 2, (a - b) ** 2 / 4


def measure(o, name, scene, resolution, samples, more, target, seed):
    r, noise = reference(o, name, scene, resolution, samples, *more)
    x, attributes = render(o, scene, resolution, seed, "--spp", o.most, "--max-error", target)
    true = max((((x - r) ** 2 - noise) / (r ** 2 + 0.01)).mean(), 0) ** 0.5
    taken = attributes.get("meanSamplesPerPixel", attributes["samplesPerPixel"])
    return {"true": true, "reported": attributes["errorEstimate"], "low": attributes["errorLow"], "high": attributes["errorHigh"],
            "doubt": attributes.get("errorDoubt", ""), "samples": float(taken)}


def table(results, names, targets):
    lines = ["| scene | asked | runs | samples a pixel | reported / asked | true / asked | true / reported | worst | within 20 % | within the interval | flagged |",
             "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"]
    good = []
    for name in names:
        for target in targets:
            runs = [run for key, run in results.items() if re.fullmatch(re.escape(f"{name} {target} ") + r"\d+", key)]
            if not runs:
                continue
            sure = [run for run in runs if not run["doubt"]]
            good += sure
            ratios = [run["true"] / run["reported"] for run in sure]
            share = lambda test: f"{100 * np.mean([test(run) for run in sure]):.0f} %" if sure else "-"
            middle = lambda values: f"{np.median(values):.2f}"
            lines.append(f"| {name} | {target:g} | {len(runs)} | {np.median([run['samples'] for run in runs]):.0f} | {middle([run['reported'] / target for run in runs])} | "
                         f"{middle([run['true'] / target for run in runs])} | {middle(ratios) if sure else '-'} | {f'{max(ratios):.2f}' if sure else '-'} | "
                         f"{share(is_near)} | {share(lambda run: run['low'] <= run['true'] <= run['high'])} | {len(runs) - len(sure)} |")
    if not good:
        return "\n".join(lines) + "\n"
    near, worst = 100 * np.mean([is_near(run) for run in good]), max(run["true"] / run["reported"] for run in good)
    head = f"{len(good)} runs without a flag: the true error is within 20 % of the reported one in {near:.0f} % of them, and at most {worst:.2f} times it.\n\n"
    return head + "\n".join(lines) + "\n"


def is_near(run):
    return 0.8 <= run["true"] / run["reported"] <= 1.2


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--scenes", nargs="*", default=list(SCENES))
    options.add_argument("--held-out", nargs="*", type=pathlib.Path, help="these scene files instead")
    options.add_argument("--targets", nargs="*", type=float, default=[0.2, 0.1, 0.05])
    options.add_argument("--seeds", type=int, default=20)
    options.add_argument("--most", type=int, default=4096, help="samples that a pixel gets at most")
    options.add_argument("--reference-samples", type=int, help="instead of each scene's own")
    options.add_argument("--renders", type=pathlib.Path, default=ROOT / "build" / "accuracy-error", help="where references go")
    options.add_argument("--results", type=pathlib.Path, help="where runs are kept (default: results.json in --renders)")
    options.add_argument("--print", action="store_true", help="print the table, write nothing into docs/accuracy.md")
    o = options.parse_args()
    o.renders.mkdir(parents=True, exist_ok=True)
    o.results = o.results or o.renders / "results.json"
    results = json.loads(o.results.read_text()) if o.results.exists() else {}
    scenes = {file.stem: (file.resolve(), "96x96", 8192) for file in o.held_out} if o.held_out else {name: SCENES[name] for name in o.scenes}
    scenes = {name: scene for name, scene in scenes.items() if scene[0].exists()}
    # Seed by seed, so that a table of fewer seeds has all scenes
    for seed in range(o.seeds):
        for name, (scene, resolution, samples, *more) in scenes.items():
            for target in o.targets:
                key = f"{name} {target} {seed}"
                if key in results:
                    continue
                results[key] = measure(o, name, scene, resolution, o.reference_samples or samples, more, target, seed)
                o.results.write_text(json.dumps(results, indent=1))
                run = results[key]
                print(f"{key}: true {run['true']:.4f} reported {run['reported']:.4f} ratio {run['true'] / run['reported']:.2f} samples {run['samples']:.0f} {run['doubt']}",
                      file=sys.stderr, flush=True)
    text = table(results, list(scenes), o.targets)
    page.put(PAGE, BEGIN, text, END, only_print=o.print)


if __name__ == "__main__":
    main()
