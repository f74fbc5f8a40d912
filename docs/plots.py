#!/usr/bin/env python3
"""Draws the plots of docs/performance.md, docs/accuracy.md and docs/hard-light.md from the figures that are kept: docs/pictures/NAME.svg.

    docs/plots.py            draws them
    docs/plots.py --check    status 1 if one is not what the figures give now

The figures are those of tests/bench/results, and the tables in docs/accuracy.md that tests/accuracy/gallery.py and error_asked.py write.
"""
import argparse
import json
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "docs" / "book" / "tool"))
from drawing import line, svg, text  # noqa: E402

PICTURES, RESULTS, ACCURACY = ROOT / "docs" / "pictures", ROOT / "tests" / "bench" / "results", ROOT / "docs" / "accuracy.md"


class LogAxis:
    """Maps values in [low, high] to [start, end] by their logarithm."""

    def __init__(self, low, high, start, end):
        self.low, self.high, self.start, self.end = low, high, start, end

    def __call__(self, value):
        share = math.log(max(value, self.low) / self.low) / math.log(self.high / self.low)
        return self.start + (self.end - self.start) * share


def mark(shape, x, y, r=4.5):
    """A symbol around (x, y): filled or hollow, round, square, a diamond or a triangle."""
    fill = 'fill="currentColor" stroke="none"' if shape.startswith("full") else 'stroke-width="1.3"'
    form = shape.split()[1]
    if form == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" {fill}/>'
    corners = {"square": [(-.8, -.8), (.8, -.8), (.8, .8), (-.8, .8)], "diamond": [(0, -1.2), (1.2, 0), (0, 1.2), (-1.2, 0)],
               "triangle": [(0, -1.1), (1.1, .9), (-1.1, .9)]}[form]
    return f'<path d="M{"L".join(f"{x + r * dx:.1f} {y + r * dy:.1f}" for dx, dy in corners)}Z" {fill}/>'


def legend(entries, x, y, step):
    return [part for i, (shape, words) in enumerate(entries)
            for part in (mark(shape, x + step * i, y - 4), text(x + 9 + step * i, y, words))]


def efficiency():
    """Our efficiency over that of the other renderers: a row for each scene, a symbol for each renderer."""
    peers = {"Mitsuba llvm_ad_rgb": ("full circle", "Mitsuba, LLVM"), "Cycles": ("full square", "Cycles"),
             "Mitsuba scalar_rgb": ("hollow circle", "Mitsuba, scalar"), "LuxCore PATHCPU": ("hollow diamond", "LuxCore"),
             "pbrt-v4": ("hollow triangle", "pbrt-v4")}
    ratios = {}
    for file in ("peers", "peers-others"):
        for row in json.loads((RESULTS / f"{file}.json").read_text())["tables"]["efficiency"]:
            if row["renderer"] in peers:
                ratios.setdefault(row["scene"], {})[row["renderer"]] = row["our efficiency / theirs"]
    top, step = 48, 24
    axis, bottom = LogAxis(0.8, 32, 130, 640), top + step * len(ratios)
    elements = legend(peers.values(), 60, 18, 122)
    for tick in (1, 2, 4, 8, 16, 32):
        style = (1.6, "") if tick == 1 else (0.5, ' stroke-opacity="0.4"')
        elements += [line(axis(tick), top - 8, axis(tick), bottom - 8, *style),
                     text(axis(tick), bottom + 8, f"{tick} x" if tick > 1 else "equal", "middle")]
    for i, (scene, row) in enumerate(ratios.items()):
        y = top + step * i + 4
        elements += [text(122, y + 4, scene, "end"),
                     line(axis(min(row.values())), y, axis(max(row.values())), y, 0.8, ' stroke-opacity="0.5"')]
        elements += [mark(peers[name][0], axis(ratio), y) for name, ratio in row.items()]
    elements.append(text(385, bottom + 28, "our efficiency over theirs", "middle"))
    return svg(680, bottom + 36, "Efficiency of Eikonal over that of four other renderers, on nine scenes", elements)


def table(script):
    """The cells of the rows of a table of docs/accuracy.md, without its head, of the script that makes it."""
    block = ACCURACY.read_text(encoding="utf-8").split(f"<!-- table: made by tests/accuracy/{script} -->")[1].split("<!-- end")[0]
    rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in block.splitlines() if row.startswith("|")]
    return rows[2:]


def deviations(script):
    """In %, of the scenes of the gallery: how far the mean of the worst channel is from that of the reference that counts, in order."""
    found = []
    for cells in table(script):
        better = re.search(r": ([\d.]+ [\d.]+ [\d.]+)", cells[4])
        found.append(max(abs(float(mean) - 1) * 100 for mean in (better.group(1) if better else cells[1]).split()))
    return sorted(found)


def gallery():
    """All scenes of the gallery in the order of their deviation, in RGB and at wavelengths."""
    kinds = [("hollow circle", "in RGB where it suffices (the default)", "gallery.py", 1),
             ("full circle", "all at wavelengths", "gallery.py --wavelengths", 0.5)]
    axis = LogAxis(0.01, 3, 230, 40)
    elements = legend([kind[:2] for kind in kinds], 80, 18, 270)
    for tick in (0.01, 0.03, 0.1, 0.3, 1, 3):
        elements += [line(60, axis(tick), 650, axis(tick), 0.5, ' stroke-opacity="0.4"'), text(52, axis(tick) + 4, f"{tick} %", "end")]
    for shape, _, script, limit in kinds:
        values = deviations(script)
        elements += [mark(shape, 68 + 574 * i / (len(values) - 1), axis(value), 2.8) for i, value in enumerate(values)]
        elements += [line(60, axis(limit), 650, axis(limit), 1.2, ' stroke-dasharray="6 4"'), text(66, axis(limit) - 5, f"limit {limit} %")]
    words = f"{len(values)} scenes, in the order of how far the mean of their worst channel is from pbrt-v4's"
    elements.append(text(355, 252, words, "middle"))
    return svg(680, 262, "Difference of the means of the gallery's images from pbrt-v4's", elements)


def error_asked():
    """The true error of renders beside the one that was asked for: a group for each error asked, a mark for each scene."""
    x, y = LogAxis(0.04, 0.25, 70, 640), LogAxis(0.03, 0.3, 240, 20)
    elements = []
    for tick in (0.03, 0.05, 0.1, 0.2, 0.3):
        elements += [line(70, y(tick), 640, y(tick), 0.5, ' stroke-opacity="0.4"'), text(62, y(tick) + 4, f"{100 * tick:.0f} %", "end")]
    rows = table("error_asked.py")
    scenes = list(dict.fromkeys(row[0] for row in rows))
    half = 9 * (len(scenes) - 1) / 2
    for asked in (0.05, 0.1, 0.2):
        elements += [line(x(asked) - half - 14, y(asked), x(asked) + half + 14, y(asked), 1.6),
                     text(x(asked), 262, f"{100 * asked:.0f} % asked for", "middle")]
    for scene, asked, _, _, _, true_over_asked, *_ in rows:
        place = x(float(asked)) + 9 * scenes.index(scene) - half
        elements.append(mark("full circle", place, y(float(asked) * float(true_over_asked)), 3.4))
    elements.append(text(355, 284, f"true error of {len(scenes)} scenes, side by side in the order of the table", "middle"))
    return svg(680, 294, "True error of renders beside the error that was asked for", elements)


def hard_light():
    """The efficiency of each of our methods over that of the best of the peers': a row for each scene."""
    ours = {"volpath": "hollow circle", "guided": "hollow diamond", "bdpt": "full square", "sppm": "hollow triangle", "vcm": "full circle"}
    scenes = {}
    for row in json.loads((RESULTS / "hard-light.json").read_text())["tables"]["efficiency"]:
        scenes.setdefault(row["scene"], {})[row["method"]] = row["efficiency"]
    ratios = {scene: {name: found[name] / max(v for k, v in found.items() if k not in ours) for name in ours if name in found} for scene, found in scenes.items()}
    top, step = 48, 24
    low, high = 1e-3, 100
    axis, bottom = LogAxis(low, high, 150, 640), top + step * len(ratios)
    elements = legend([(shape, name) for name, shape in ours.items()], 150, 18, 98)
    for tick in (1e-3, 1e-2, 0.1, 1, 10, 100):
        style = (1.6, "") if tick == 1 else (0.5, ' stroke-opacity="0.4"')
        elements += [line(axis(tick), top - 8, axis(tick), bottom - 8, *style), text(axis(tick), bottom + 8, f"{tick:g} x" if tick != 1 else "equal", "middle")]
    for i, (scene, row) in enumerate(sorted(ratios.items(), key=lambda found: -max(found[1].values()))):
        y = top + step * i + 4
        elements += [text(142, y + 4, scene, "end"), line(axis(min(row.values())), y, axis(max(row.values())), y, 0.8, ' stroke-opacity="0.5"')]
        elements += [mark(ours[name], axis(min(ratio, high)), y) for name, ratio in row.items()]
    elements.append(text(395, bottom + 28, "efficiency over that of the best method of the others", "middle"))
    return svg(680, bottom + 36, "Efficiency of each of Eikonal's methods over the best of the other renderers', on scenes of hard light", elements)


PLOTS = {"hard-light": hard_light, "efficiency": efficiency, "accuracy-gallery": gallery, "accuracy-error-asked": error_asked}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    old = []
    for name, draw in PLOTS.items():
        file, drawn = PICTURES / f"{name}.svg", draw() + "\n"
        if not options.check:
            file.write_text(drawn, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != drawn:
            old.append(f"{file.relative_to(ROOT)} is not what its figures give: docs/plots.py")
    print("\n".join(old))
    return int(bool(old))


if __name__ == "__main__":
    sys.exit(main())
