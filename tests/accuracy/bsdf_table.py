#!/usr/bin/python3
"""Measures every BSDF over roughness, index and angle, and writes the tables into docs/bsdfs.md.

    tests/accuracy/bsdf_table.py             about four minutes
    tests/accuracy/bsdf_table.py --print     prints the tables instead

The numbers are those of the device: tests/kernels/bsdf_table_test.cpp, which needs a build with tests (`./dev test`).
"""

import argparse
import csv
import os
import pathlib
import subprocess
import sys
import tempfile

import page

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "bsdfs.md"
BEGIN, END = "<!-- table: made by tests/accuracy/bsdf_table.py -->\n", "<!-- end of the table of BSDFs -->\n"
COSINES = ["0.999", "0.7", "0.2"]


def measure(program):
    """Rows: BSDF, index, alpha, then energy, p and reciprocity for each cosine."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "bsdfs.csv"
        done = subprocess.run([program, "--gtest_also_run_disabled_tests", "--gtest_filter=BsdfTable.*"],
                              env={**os.environ, "EIKONAL_BSDF_TABLE": str(file)}, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"bsdf_table.py: {program} failed:\n{done.stdout}{done.stderr}")
        return list(csv.reader(file.open()))


def table(rows):
    heads = ["BSDF", "index", "alpha"] + [f"{what} at {c}" for what in ("energy", "p", "reciprocity") for c in COSINES]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for name, index, alpha, *values in rows:
        cells = [f"{float(x):.3f}" for x in values[0::3]] + values[1::3] + values[2::3]
        lines.append("| " + " | ".join([f"`{name}`", index, alpha] + cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "kernel_tests")
    options.add_argument("--print", action="store_true", help="print the table instead of writing it")
    o = options.parse_args()
    made = table(measure(o.program))
    page.put(PAGE, BEGIN, made, END, only_print=o.print)


if __name__ == "__main__":
    main()
