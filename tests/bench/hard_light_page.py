#!/usr/bin/env python3
"""Writes the tables of docs/hard-light.md, and the sentence that sums them up there and in docs/integrators.md, from results/hard-light.json, where hard_light.py
has kept the figures."""

import json
import sys

from hard_light import OURS, PEERS, SCENES
from paths import ROOT

sys.path.insert(0, str(ROOT / "tests" / "accuracy"))
from page import put  # noqa: E402

PAGE, INTEGRATORS, FIGURES = ROOT / "docs" / "hard-light.md", ROOT / "docs" / "integrators.md", ROOT / "tests" / "bench" / "results" / "hard-light.json"


def begin(name):
    return f"<!-- {name}: made by tests/bench/hard_light_page.py -->\n"


def significant(value):
    """Two digits, without an exponent."""
    rounded = float(f"{value:.2g}")
    return f"{rounded:,.0f}" if rounded >= 10 else f"{rounded:.6f}".rstrip("0").rstrip(".")


def by_scene(rows):
    found = {}
    for row in rows:
        found.setdefault(row["scene"], {})[row.get("method")] = row
    return {scene: found[scene] for scene in sorted(found, key=SCENES.index)}


def efficiency(row):
    return row["efficiency"]


def trimmed(row):
    """Efficiency without the worst thousandth of the pixels."""
    return 1 / (row["trimmed"] * row["seconds"])


def best(rows, measure=efficiency):
    return max(rows, key=measure)


def ratio(methods, measure=efficiency):
    """The best of ours over the best of the peers'."""
    ours, theirs = (measure(best(side, measure)) for side in split(methods))
    return ours / theirs


def split(methods):
    """The rows of ours, and those of the peers."""
    return [row for name, row in methods.items() if name in OURS], [row for name, row in methods.items() if name not in OURS]


def scenes(tables):
    """A row for each scene: efficiencies, the best of each side in bold type."""
    peers = [f"pbrt-v4 {name}" for name in ("volpath", "bdpt", "sppm", "mlt")]
    columns = ["scene", "theirs off, %", *OURS, *peers, "best of ours over best peer", "without the worst pixels", "its FLIP", "the peer's"]
    lines = ["| " + " | ".join(columns) + " |\n|---|" + "--:|" * (len(columns) - 1)]
    apart = by_scene(tables["references"])
    for scene, methods in by_scene(tables["efficiency"]).items():
        ours, theirs = (best(side) for side in split(methods))
        off = next(iter(apart[scene].values()))
        cells = [scene, "-" if off["+-"] is None else f"{off['theirs off, %']:+.1f} +- {off['+-']:.1f}"]
        for name in [*OURS, *peers]:
            row = methods.get(name)
            cells.append("-" if row is None else f"**{significant(row['efficiency'])}**" if row in (ours, theirs) else significant(row["efficiency"]))
        lines.append("| " + " | ".join([*cells, significant(ratio(methods)), significant(ratio(methods, trimmed)), f"{ours['FLIP']:.3f}", f"{theirs['FLIP']:.3f}"]) + " |")
    return "\n".join(lines) + "\n"


def others(tables):
    """The scene that LuxCore and Cycles render: a row for each method, the most efficient first."""
    rows = sorted(by_scene(tables["efficiency"]).get(PEERS, {}).values(), key=lambda row: -row["efficiency"])
    lines = ["| method | samples | relMSE | FLIP | efficiency | mean off, % |\n|---|--:|--:|--:|--:|--:|"]
    lines += [f"| {r['method']} | {r['samples']} | {r['relMSE']:.2g} | {r['FLIP']:.3f} | {significant(r['efficiency'])} | {r['mean off, %']:+.1f} |" for r in rows]
    return "\n".join(lines) + "\n"


def listed(ratios):
    return ", ".join(f"{scene} ({significant(ratio)} x)" for scene, ratio in ratios.items())


def summary(tables):
    """What a reader should remember."""
    over_peers, over_volpath, most_pixels = {}, {}, {}
    for scene, methods in by_scene(tables["efficiency"]).items():
        ours = best(split(methods)[0])["efficiency"]
        over_peers[scene], most_pixels[scene], over_volpath[scene] = ratio(methods), ratio(methods, trimmed), ours / methods["volpath"]["efficiency"]
    less = {scene: ratio for scene, ratio in over_peers.items() if ratio < 1}
    twice, much = sum(ratio >= 2 for ratio in over_peers.values()), {scene: ratio for scene, ratio in over_volpath.items() if ratio >= 10}
    return (f"The best of our methods has at least twice the efficiency of the best method of the others on {twice} of {len(over_peers)} scenes"
            + (f", and less than theirs on {listed(less)}" if less else "") + ".\n"
            + f"Without the worst thousandth of the pixels: twice on {sum(r >= 2 for r in most_pixels.values())}, less on {listed({s: r for s, r in most_pixels.items() if r < 1}) or 'none'}.\n"
            + (f"It has at least ten times the efficiency of our own `volpath` on {listed(much)}.\n" if much else ""))


def settings(kept):
    s = kept["settings"]
    return (f"{s['width']} pixels wide, {s['seconds']:g} s for each method, {s['reference_seconds']:g} s for each of the two references, median of {s['rounds']}, "
            f"{s['threads']} threads, {kept['processor']}, load average {s['load']:.1f} when the last of them began, {kept['date']}.\n")


def main():
    kept = json.loads(FIGURES.read_text())
    tables = kept["tables"]
    for page, name, text in ((PAGE, "summary", summary(tables)), (INTEGRATORS, "summary", summary(tables)), (PAGE, "settings", settings(kept)),
                             (PAGE, "scenes", scenes(tables)), (PAGE, "others", others(tables))):
        put(page, begin(name), text, f"<!-- end of {name} -->\n")


if __name__ == "__main__":
    main()
