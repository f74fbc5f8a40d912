#!/usr/bin/env python3
"""Writes the tables of docs/hard-light.md from the figures that hard_light.py has kept in results/hard-light.json."""

import json
import sys

from hard_light import OURS, PEERS, SCENES
from paths import ROOT

sys.path.insert(0, str(ROOT / "tests" / "accuracy"))
from page import put  # noqa: E402

PAGE, FIGURES = ROOT / "docs" / "hard-light.md", ROOT / "tests" / "bench" / "results" / "hard-light.json"


def begin(name):
    return f"<!-- {name}: made by tests/bench/hard_light_page.py -->\n"


def significant(value):
    """Two digits, without an exponent."""
    digits = f"{value:.2g}"
    return digits if "e" not in digits else f"{float(digits):,.0f}" if value >= 1 else f"{value:.1g}"


def by_scene(rows):
    found = {}
    for row in rows:
        found.setdefault(row["scene"], {})[row.get("method")] = row
    return {scene: found[scene] for scene in sorted(found, key=SCENES.index)}


def best(rows):
    return max(rows, key=lambda row: row["efficiency"])


def split(methods):
    """The rows of ours, and those of the peers."""
    return [row for name, row in methods.items() if name in OURS], [row for name, row in methods.items() if name not in OURS]


def scenes(tables):
    """A row for each scene: efficiencies, the best of each side in bold type."""
    peers = [f"pbrt-v4 {name}" for name in ("volpath", "bdpt", "sppm", "mlt")]
    columns = ["scene", "theirs off, %", *OURS, *peers, "best of ours over best peer", "its FLIP", "the peer's"]
    lines = ["| " + " | ".join(columns) + " |\n|---|" + "--:|" * (len(columns) - 1)]
    apart = by_scene(tables["references"])
    for scene, methods in by_scene(tables["efficiency"]).items():
        ours, theirs = (best(side) for side in split(methods))
        off = next(iter(apart[scene].values()))
        cells = [scene, "-" if off["+-"] is None else f"{off['theirs off, %']:+.1f} +- {off['+-']:.1f}"]
        for name in [*OURS, *peers]:
            row = methods.get(name)
            cells.append("-" if row is None else f"**{significant(row['efficiency'])}**" if row in (ours, theirs) else significant(row["efficiency"]))
        lines.append("| " + " | ".join([*cells, significant(ours["efficiency"] / theirs["efficiency"]), f"{ours['FLIP']:.3f}", f"{theirs['FLIP']:.3f}"]) + " |")
    return "\n".join(lines) + "\n"


def others(tables):
    """The scene that LuxCore and Cycles render: a row for each method, the most efficient first."""
    rows = sorted(by_scene(tables["efficiency"]).get(PEERS, {}).values(), key=lambda row: -row["efficiency"])
    lines = ["| method | samples | relMSE | FLIP | efficiency | mean off, % |\n|---|--:|--:|--:|--:|--:|"]
    lines += [f"| {r['method']} | {r['samples']} | {r['relMSE']:.2g} | {r['FLIP']:.3f} | {significant(r['efficiency'])} | {r['mean off, %']:+.1f} |" for r in rows]
    return "\n".join(lines) + "\n"


def settings(kept):
    s = kept["settings"]
    return (f"{s['width']} pixels wide, {s['seconds']:g} s for each method, {s['reference_seconds']:g} s for each of the two references, median of {s['rounds']}, "
            f"{s['threads']} threads, {kept['processor']}, {kept['date']}.\n")


def main():
    kept = json.loads(FIGURES.read_text())
    for name, make in (("settings", lambda: settings(kept)), ("scenes", lambda: scenes(kept["tables"])), ("others", lambda: others(kept["tables"]))):
        put(PAGE, begin(name), make(), f"<!-- end of {name} -->\n")


if __name__ == "__main__":
    main()
