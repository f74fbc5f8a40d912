#!/usr/bin/env python3
"""What math flags of OpenCL's compiler do to each kernel: error in ulp, error of the image, and time. Those that ship are chosen from it.

    tests/accuracy/flags.py SCENE ... [--json FILE]           measures, prints tables; what FILE has of other scenes is kept
    tests/accuracy/flags.py --from FILE                       puts the tables of kept figures, but for times, into docs/numerics.md

Functions: each on 100,000 inputs, against long double and against the strict build. Stages: the first bounces of each scene, all stages on the
same queues, against the strict build (both by build/flag_ulps, which is built first). Images: a flag in one stage alone, all else strict,
against the strict image with the same seed; if a flag in all stages changes no bit, it is not tried in single ones. Times: of each stage, over
those of the shipped flags, in runs by turns (on a quiet machine).
"""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "bench"))
from page import put  # noqa: E402
from paths import bench, run  # noqa: E402
from report import processor  # noqa: E402

STRICT = "-DNO_CONTRACTION=1"
SHIPPED = "-cl-finite-math-only -cl-no-signed-zeros"
# On top of the strict build
ALONE = {"contraction": ""} | {flag: f"{STRICT} {flag}" for flag in (
    "-cl-no-signed-zeros", "-cl-finite-math-only", "-cl-denorms-are-zero", "-cl-mad-enable", "-cl-unsafe-math-optimizations",
    "-cl-fast-relaxed-math", "-cl-fp32-correctly-rounded-divide-sqrt")} | {"shipped": SHIPPED}
# Beside what ships
TIMED = {"strict": STRICT, "only contraction": "", "no contraction": f"{STRICT} {SHIPPED}", "no -cl-no-signed-zeros": "-cl-finite-math-only",
         "no -cl-finite-math-only": "-cl-no-signed-zeros"} | {f"and {flag}": f"{SHIPPED} {flag}" for flag in (
             "-cl-denorms-are-zero", "-cl-mad-enable", "-cl-unsafe-math-optimizations", "-cl-fast-relaxed-math",
             "-cl-fp32-correctly-rounded-divide-sqrt")}


def ulps(o, *words):
    """The rows of flag_ulps, by what they are of and the name of the flags."""
    names = {flags: name for name, flags in ALONE.items()}
    rows = json.loads(run([o.build / "flag_ulps", *words, STRICT, *ALONE.values()]))
    return {f"{r.get('function') or r.get('stage')}|{names.get(r['flags'], 'strict')}": r for r in rows}


def difference(o, scene, size, folder, flags):
    """relMSE, change of the mean and of the worst block of an image whose stages have these --math-flags, from the strict one."""
    options = [f"--math-flags={f}" for f in (STRICT, *flags)]
    run([o.program, "render", scene, *size, "--spp", o.samples, "--quiet", "-o", folder / "other.exr", *options])
    c = json.loads(run([o.program, "compare", folder / "other.exr", folder / "strict.exr", "--json"]))
    block = c["worstBlock"]
    off = max(abs(a - b) / max(b, 1e-2 * max(c["referenceMean"]), 1e-30) for a, b in zip(block["image"], block["reference"]))
    return {"relativeMse": c["relativeMse"], "mean": c["worstMean"], "block": off}


def stage_times(o, scene, size, folder, flags=SHIPPED):
    figures = bench(o.program, scene, folder, *size, "--spp", o.samples, "--repeats", 1, f"--math-flags={flags or 'none'}")
    return {stage["stage"]: stage["nanosecondsPerSlot"] for stage in figures["stages"]} | {"all": 1e9 / figures["pathsPerSecond"]}


def measure_images(o, scene, size, folder):
    run([o.program, "render", scene, *size, "--spp", o.samples, "--quiet", "-o", folder / "strict.exr", f"--math-flags={STRICT}"])
    rows = {}
    for name, flags in ALONE.items():
        every = rows[f"all|{name}"] = difference(o, scene, size, folder, [flags or "none"])
        if every["relativeMse"] > 0:
            for stage in stage_times(o, scene, size, folder):
                if stage != "all":
                    rows[f"{stage}|{name}"] = difference(o, scene, size, folder, [f"{stage}:{flags or 'none'}"])
    return rows


def measure_times(o, scene, size, folder):
    ratios = {}
    for round_ in range(o.rounds + 1):   # the first one compiles
        for name, flags in TIMED.items():
            shipped = stage_times(o, scene, size, folder)
            other = stage_times(o, scene, size, folder, flags)
            for stage in shipped:
                if round_ and shipped[stage]:
                    ratios.setdefault(f"{stage}|{name}", []).append(other[stage] / shipped[stage])
    return ratios


def cell(figure):
    return "0" if figure == 0 else f"{figure:.1g}" if figure < 0.1 or figure >= 1e4 else f"{figure:.2g}"


def rows_of(kinds):
    """The names before the bar, in their order."""
    return list(dict.fromkeys(key.partition("|")[0] for key in kinds))


def table(heads, rows):
    return f"| {' | '.join(heads)} |\n|---|{'--:|' * (len(heads) - 1)}\n" + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def table_of_flags(head, names, rows):
    """Without the flags that change nothing, which a sentence lists. rows: the name of each and its cells; the first flag is shown always."""
    changed = [i for i in range(len(names)) if i == 0 or any(row[1 + i] != "same" for row in rows)]
    text = table([head, *(f"`{names[i]}`" for i in changed)], [[row[0], *(row[1 + i] for i in changed)] for row in rows])
    same = [f"`{name}`" for i, name in enumerate(names) if i not in changed]
    return text + (f"\nNo bit changes with {', '.join(same)}.\n" if same else "")


def function_table(figures):
    names = ["strict", *ALONE]

    def difference_of(function, name):
        found = figures[f"{function}|{name}"]
        is_same = name != "strict" and found["first"]["largest"] == 0
        return "same" if is_same else f"{cell(found['twin']['largest'])}, {cell(found['twin']['rms'])}"
    return table_of_flags("function", names, [[f"`{f}`", *(difference_of(f, n) for n in names)] for f in rows_of(figures)])


def stage_table(scenes):
    """The worst scene of each stage: largest and rms difference in ulp, and the share of items that decide otherwise."""
    stages = list(dict.fromkeys(s for figures in scenes.values() for s in rows_of(figures["stages"])))

    def worst(stage, name):
        found = [figures["stages"][f"{stage}|{name}"] for figures in scenes.values() if f"{stage}|{name}" in figures["stages"]]
        largest, rms = (max(f["ulps"][k] for f in found) for k in ("largest", "rms"))
        decided = max(f["decided"] / max(f["items"], 1) for f in found)
        return "same" if largest == 0 and decided == 0 else f"{cell(largest)}, {cell(rms)}" + (f", {100 * decided:.1g} %" if decided else "")
    return table_of_flags("stage", list(ALONE), [[stage, *(worst(stage, n) for n in ALONE)] for stage in stages])


def image_table(scenes):
    """The worst scene: relMSE, change of the mean."""
    stages = list(dict.fromkeys(s for figures in scenes.values() for s in rows_of(figures["images"])))

    def worst(stage, name):
        found = [figures["images"][f"{stage}|{name}"] for figures in scenes.values() if f"{stage}|{name}" in figures["images"]]
        if not found or all(f["relativeMse"] == 0 for f in found):
            return "same"
        relative, mean, block = (max(f[k] for f in found) for k in ("relativeMse", "mean", "block"))
        return f"{relative:.0e}, {100 * mean:.0e} %, {100 * block:.0e} %"
    return table_of_flags("flag in", list(ALONE), [[stage, *(worst(stage, n) for n in ALONE)] for stage in stages])


def time_table(scenes):
    stages = list(dict.fromkeys(s for figures in scenes.values() for s in rows_of(figures.get("times", {}))))

    def middle(stage, name):
        medians = [statistics.median(figures["times"][f"{stage}|{name}"]) for figures in scenes.values() if f"{stage}|{name}" in figures.get("times", {})]
        return f"{math.exp(statistics.mean(math.log(m) for m in medians)):.2f}"
    return table(["stage", *(f"`{n}`" for n in TIMED)], [[stage, *(middle(stage, n) for n in TIMED)] for stage in stages])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--size", default="96x96")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", nargs="*", default=["functions", "stages", "images", "times"])
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--from", type=pathlib.Path, dest="kept")
    parser.add_argument("--print", action="store_true", dest="only_print")
    o = parser.parse_args()
    o.program = o.build / "eikonal"
    earlier = o.kept or (o.json if o.json and o.json.exists() else None)
    figures = json.loads(earlier.read_text()) if earlier else {"processor": processor(), "functions": {}, "scenes": {}}
    if not o.kept:
        subprocess.run(["cmake", "--build", o.build, "--target", "flag_ulps", "eikonal"], check=True, stdout=sys.stderr)
        if "functions" in o.only and not figures["functions"]:
            figures["functions"] = ulps(o, "functions")
    for scene in o.scenes:
        with tempfile.TemporaryDirectory() as name:
            folder, size, found = pathlib.Path(name), ["--resolution", o.size], figures["scenes"].setdefault(scene.stem, {})
            if "stages" in o.only:
                found["stages"] = ulps(o, "stages", scene)
            if "images" in o.only:
                found["images"] = measure_images(o, scene, size, folder)
            if "times" in o.only:
                found["times"] = measure_times(o, scene, size, folder)
        if o.json:
            o.json.write_text(json.dumps(figures, indent=1) + "\n")
    tables = {"functions": lambda: function_table(figures["functions"])}
    tables |= {kind: (lambda make=make: make(figures["scenes"])) for kind, make in (("stages", stage_table), ("images", image_table), ("times", time_table))}
    for kind, make in tables.items():
        if kind == "times" and kind in o.only:
            print(make())
        elif kind in o.only:
            put(ROOT / "docs" / "numerics.md", f"<!-- {kind}: made by tests/accuracy/flags.py -->\n", make(), f"<!-- end of {kind} -->", o.only_print or not o.kept)


if __name__ == "__main__":
    main()
