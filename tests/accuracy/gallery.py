#!/usr/bin/env python3
"""Renders the feature gallery, compares each image with pbrt-v4's own, and writes the table of docs/accuracy.md.

    ./dev accuracy                           all of ../shared/gallery
    ./dev accuracy --only film               the scenes with "film" in their name, printed instead of written
    ./dev accuracy --renders DIR --keep      compare the images that are in DIR already
    ./dev accuracy --wavelengths             all of them at four wavelengths a path: the second table
    ./dev accuracy FOLDER --print --scatter  other scenes, whose references are noisy

A scene agrees if each channel's mean is within 1 % (at wavelengths 0.5 %) of the reference's and no block of 8 x 8 pixels is further off than 5 % and four
standard errors; or if it does so with a better image that pbrt-v4 made (references/README.md), which its row says. Exits with 1 if a scene differs for no reason that REASONS knows, or further than that reason explains, or cannot be rendered.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "accuracy.md"
BEGIN, END = "<!-- table: made by tests/accuracy/gallery.py -->\n", "<!-- end of table -->\n"
BETTER_REFERENCES = pathlib.Path(__file__).with_name("references")
BEGIN_WAVELENGTHS, END_WAVELENGTHS = "<!-- table: made by tests/accuracy/gallery.py --wavelengths -->\n", "<!-- end of the table at wavelengths -->\n"
MEAN_LIMIT, MEAN_LIMIT_AT_WAVELENGTHS = 0.01, 0.005

# Why a scene differs that is rendered: found out by hand, shown in docs/accuracy.md. And how far off the mean of a channel and the worst
# block may be for that reason: what was found, and half as much again.
REASONS = {
    "material-dielectric-dispersive": ("colour noise of the reference, see below", 0.005, 1.5),
}


def render(program, scene, image, samples, color="auto"):
    """Renders a scene into `image`, and what the program says into a .log beside it."""
    command = [program, "render", scene, "--spp", samples, "--color", color, "--aov", "variance", "--stats", "-o", image]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    image.with_suffix(".log").write_text(done.stdout + done.stderr)
    return done.returncode == 0


def compare(program, image, reference, *options):
    done = subprocess.run([str(program), "compare", "--json", *options, str(image), str(reference)], capture_output=True, text=True)
    return json.loads(done.stdout) if done.returncode == 0 else None


def compare_better(program, image, name):
    """With pbrt-v4's better image; nothing if there is none."""
    if name not in BETTER:
        return None
    reference = BETTER_REFERENCES / (name + ".exr")
    return compare(program, image, reference, *["--scatter"] * (name in NOISY_REFERENCES)) or sys.exit(f"gallery.py: {reference} cannot be compared with {image}")


def ratio(value, reference):
    return value / reference if reference else 1.0 if value == 0 else float("inf")


# What pbrt-v4's better images are, where references/ has one.
BETTER = {
    "light-infinite-portal": "of 16384 samples",
    "medium-camera-inside": "of 8192 samples",
    "material-subsurface": "of 8192 samples",
    "material-coatedconductor": "without light sampling",
}

# Where even those are noisier than our image: the reference's noise is what its pixels scatter, not what ours do.
NOISY_REFERENCES = ["light-infinite-portal", "medium-camera-inside"]


def explanation(name, worst_mean, worst_block):
    """Why a scene may differ so far; nothing if no reason is known, and that it is too far if one is."""
    if name not in REASONS:
        return None, ""
    reason, mean_bound, block_bound = REASONS[name]
    if worst_mean <= mean_bound and worst_block <= block_bound:
        return reason, ""
    return None, f": more than explained by \"{reason}\" (mean within {mean_bound:.1%}, worst block {block_bound})"


def distances(numbers):
    """Of the means of the three channels, as ratios."""
    return [ratio(*pair) for pair in zip(numbers["mean"], numbers["referenceMean"])]


def agrees(numbers, mean_limit):
    return max(abs(r - 1) for r in distances(numbers)) <= mean_limit and numbers["blocksOff"] == 0 and numbers["invalidPixels"] == 0


def judge(name, log, numbers, better=None, mean_limit=MEAN_LIMIT):
    """The cells of a scene's row, its kind (agrees, differs, unexplained, missing, failed) first. `better`: the numbers of a better reference."""
    seconds = re.search(r"^  render +([0-9.]+) s", log, re.MULTILINE)
    seconds = f"{float(seconds[1]):.1f}" if seconds else ""
    missing = [f"{found[1]} ({found[2]})" for found in re.finditer(r"warning: (.*) (?:is|are) not rendered yet; (.*)", log)]
    if not numbers:
        return "failed", name, "", "", "", "**failed**: " + (log.strip().splitlines() or ["?"])[-1], seconds

    ratios, block = distances(numbers), numbers["worstBlock"]
    worst_mean = max(abs(r - 1) for r in ratios)
    reason, beyond = explanation(name, worst_mean, block["distance"]) if numbers["invalidPixels"] == 0 else (None, ": not finite")
    if missing:
        kind, verdict = "missing", "not rendered yet: " + ", ".join(missing)
    elif agrees(numbers, mean_limit):
        kind, verdict = "agrees", "agrees"
    elif better and agrees(better, mean_limit):
        kind = "agrees"
        verdict = f"agrees with pbrt-v4's image {BETTER[name]}: {' '.join(f'{r:.4f}' for r in distances(better))}, worst block {better['worstBlock']['distance']:.2f}"
    elif reason:
        kind, verdict = "differs", "differs: " + reason
    else:
        kind, verdict = "unexplained", "**differs**" + beyond
    return (kind, name, " ".join(f"{r:.4f}" for r in ratios), f"{block['distance']:.2f} at {block['x']}, {block['y']}",
            f"{numbers['blocksOff']} of {numbers['blocks']}", verdict, seconds)


def table(rows, samples):
    count = lambda kind: sum(row[0] == kind for row in rows)
    wrong = count("unexplained") + count("failed")
    lines = [f"**{count('agrees')} of {len(rows)} scenes agree**, {count('differs')} differ for a known reason, "
             f"{count('missing')} need features that are not rendered, {wrong} are wrong. {samples} samples per pixel.", "",
             "| scene | mean / reference: R G B | worst block | blocks off | verdict | seconds |", "|---|---|---|---|---|--:|"]
    lines += ["| " + " | ".join(row[1:]) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("gallery", nargs="?", type=pathlib.Path, default=ROOT.parent / "shared" / "gallery",
                         help="folder of scenes with their references in reference/ (../shared/gallery)")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--spp", type=int, default=1024)
    options.add_argument("--color", default="auto", help="auto, rgb or spectral (auto)")
    options.add_argument("--only", metavar="WORD", default="", help="scenes with this in their name; prints the table, writes nothing")
    options.add_argument("--renders", type=pathlib.Path, default=ROOT / "build" / "accuracy", help="where images and logs go (build/accuracy)")
    options.add_argument("--wavelengths", action="store_true", help="rendered as spectra; asks for means within 0.5 %%")
    options.add_argument("--print", action="store_true", help="prints the table, writes nothing")
    options.add_argument("--scatter", action="store_true", help="standard errors from how pixels scatter about the reference's")
    options.add_argument("--keep", action="store_true", help="do not render what is there already")
    o = options.parse_args()

    scenes = sorted(scene for scene in o.gallery.glob("*.pbrt") if o.only in scene.stem)
    limit, begin, end = MEAN_LIMIT, BEGIN, END
    if o.wavelengths:
        limit, begin, end, o.color, o.renders = MEAN_LIMIT_AT_WAVELENGTHS, BEGIN_WAVELENGTHS, END_WAVELENGTHS, "spectral", o.renders / "wavelengths"
    if not scenes:
        sys.exit(f"gallery.py: no scene *{o.only}*.pbrt in {o.gallery}")
    o.renders.mkdir(parents=True, exist_ok=True)
    rows = []
    for scene in scenes:
        image, log = o.renders / (scene.stem + ".exr"), o.renders / (scene.stem + ".log")
        rendered = (o.keep and image.exists() and log.exists()) or render(o.program, scene, image, o.spp, o.color)
        numbers = compare(o.program, image, o.gallery / "reference" / (scene.stem + ".exr"), *["--scatter"] * o.scatter) if rendered else None
        better = compare_better(o.program, image, scene.stem) if rendered else None
        rows.append(judge(scene.stem, log.read_text(), numbers, better, limit))
        print("  ".join(cell for cell in rows[-1][1:] if cell), file=sys.stderr, flush=True)

    text = table(rows, o.spp)
    if o.only or o.print:
        print(text, end="")
    else:
        page.put(PAGE, begin, text, end)
        print(text.splitlines()[0])
    sys.exit(any(row[0] in ("unexplained", "failed") for row in rows))


if __name__ == "__main__":
    main()
