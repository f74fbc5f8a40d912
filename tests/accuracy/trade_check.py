#!/usr/bin/env python3
"""Whether `eikonal trade` keeps its promises: runs it on scenes, then runs the commands that it recommends, and compares time and error.

    tests/accuracy/trade_check.py SCENE ... [--budget 2m] [--resolution 320x240] [--most-seconds 60]

The time is that of the whole process. The true error comes from two independent references r and r' with at least as many samples, which the
script renders at full size with the options of the study's own references: relMSE(a, r) + relMSE(a, r') - relMSE(r, r') is twice that of a
(nan, and not counted, if the references are far noisier than a).
Prints a Markdown table; --json keeps the figures.
"""
import argparse
import json
import math
import pathlib
import shlex
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(command):
    words = [str(c) for c in command]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise SystemExit(f"{shlex.join(words)} failed with status {done.returncode}: {done.stderr}")
    return done.stdout


def relative_mse(program, image, reference):
    return json.loads(run([program, "compare", image, reference, "--json"]))["relativeMse"]


def name_of(scene):
    return f"{scene.resolve().parent.name}-{scene.name.partition('.')[0]}"


def study(o, scene, folder):
    page = folder / f"{name_of(scene)}.html"
    size = [f"--resolution={o.resolution}"] if o.resolution else []
    start = time.monotonic()
    run([o.program, "trade", scene, *size, "--budget", o.budget, "-o", page, "--quiet", *(w for f in o.wishes for w in ("--for", f))])
    return json.loads(page.with_suffix(".json").read_text()), size, time.monotonic() - start


def references(o, scene, size, figures, samples, folder):
    """Two images that share no samples with each other or with what is checked."""
    files = []
    for seed in (1001, 1002):
        files.append(folder / f"{name_of(scene)}-{seed}.exr")
        run([o.program, "render", scene, *size, *figures["reference"]["options"], "--spp", samples, "--seed", seed, "--quiet", "-o", files[-1]])
    return files


def check(o, scene, folder):
    figures, size, seconds = study(o, scene, folder)
    spent = seconds
    possible = [r for r in figures["recommendations"] if r["isPossible"] and r["seconds"] <= o.most_seconds]
    if not possible:
        return []
    pair = references(o, scene, size, figures, int(max(256, min(8192, 4 * max(r["samples"] for r in possible)))), folder)
    between = relative_mse(o.program, *pair)
    rows = []
    for r in possible:
        words = shlex.split(r["command"])
        image = folder / "checked.exr"
        start = time.monotonic()
        run([o.program, *words[1:], "--seed", 77, "--quiet", "-o", image])
        taken = time.monotonic() - start
        square = (sum(relative_mse(o.program, image, reference) for reference in pair) - between) / 2
        if square < 0.1 * between:   # the references are too noisy to tell
            square = math.nan
        rows.append({"scene": name_of(scene), "wish": r["wish"], "setting": r["setting"], "samples": r["samples"], "seconds": r["seconds"],
                     "secondsTaken": taken, "error": r["error"], "errorReached": square ** 0.5, "studySeconds": spent})
    return rows


def is_near(found, predicted, seconds=0.0):
    """Within 25 %, or within some seconds: the start of a process varies by a tenth."""
    return 0.8 <= found / predicted <= 1.25 or abs(found - predicted) <= seconds


def table(rows):
    text = "| scene | for | setting | samples | seconds: predicted | taken | ratio | error: predicted | true | ratio |\n"
    text += "|---|---|---|--:|--:|--:|--:|--:|--:|--:|\n"
    for r in rows:
        text += (f"| {r['scene']} | {r['wish']} | {r['setting']} | {r['samples']:.4g} | {r['seconds']:.3g} | {r['secondsTaken']:.3g} "
                 f"| {r['secondsTaken'] / r['seconds']:.2f} | {100 * r['error']:.2g} % | {100 * r['errorReached']:.2g} % "
                 f"| {r['errorReached'] / r['error']:.2f} |\n")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--budget", default="2m")
    parser.add_argument("--resolution", help="of every scene; default: its own")
    parser.add_argument("--most-seconds", type=float, default=60, help="do not check commands that are predicted to take longer")
    parser.add_argument("--wishes", nargs="*", default=["3s", "15s", "10%", "5%"])
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--print", type=pathlib.Path, dest="kept", help="print the table of figures that --json kept, instead")
    o = parser.parse_args()
    rows = json.loads(o.kept.read_text()) if o.kept else []
    with tempfile.TemporaryDirectory() as name:
        for scene in o.scenes:
            checked = check(o, scene, pathlib.Path(name))
            rows += checked
            print(table(checked), flush=True)
            if o.json:
                o.json.write_text(json.dumps(rows, indent=1) + "\n")
    print(table(rows))
    told = [r for r in rows if not math.isnan(r["errorReached"])]
    good = {s: all(is_near(r["secondsTaken"], r["seconds"], 0.1) and is_near(r["errorReached"], r["error"]) for r in told if r["scene"] == s)
            for s in {r["scene"] for r in told}}
    print(f"all commands within 25 % of the predicted time (or 0.1 s) and error: {sum(good.values())} of {len(good)} scenes; "
          f"{len(rows) - len(told)} commands had references too noisy to tell")
    for what, predicted, found in (("time", "seconds", "secondsTaken"), ("error", "error", "errorReached")):
        ratios = [r[found] / r[predicted] for r in rows if not math.isnan(r[found])]
        within = sum(is_near(r[found], r[predicted], 0.1 if what == "time" else 0) for r in rows if not math.isnan(r[found]))
        print(f"{what}: {within} of {len(ratios)} commands within that, median ratio {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main()
