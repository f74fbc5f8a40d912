"""What the scripts of figures share: SVG in the colours of the page, and values from the program's own source."""
import csv
import re
import subprocess
import tempfile
from pathlib import Path

from fragments import ROOT


def constants(path):
    """The numbers that a file of code defines as macros: name -> value."""
    found = re.findall(r"^#define (\w+) ([\d.]+)f\b", (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE)
    return {name: float(value) for name, value in found}


def table(name):
    """A table of host/color/tables: rows of numbers."""
    with open(ROOT / "host" / "color" / "tables" / f"{name}.csv", encoding="utf-8") as file:
        return [[float(value) for value in row] for row in list(csv.reader(file))[1:]]


def run(text):
    """The numbers that a C++ program prints; it may use files of kernels/ that are plain C."""
    with tempfile.TemporaryDirectory() as folder:
        source, program = Path(folder) / "figure.cpp", Path(folder) / "figure"
        source.write_text(text, encoding="utf-8")
        subprocess.run(["g++", "-O1", "-w", f"-I{ROOT}/kernels", f"-I{ROOT}/include", "-o", program, source], check=True)
        return [float(number) for number in subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()]


def svg(width, height, title, elements):
    """An SVG whose lines and texts have the colour of the page's text. Elements without a fill are lines."""
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" aria-label="{title}" '
            'fill="none" stroke="currentColor" font-family="sans-serif" font-size="12">\n' + "\n".join(elements) + "\n</svg>")


def polyline(points, width=1.5, more=""):
    return f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in points)}" stroke-width="{width}"{more}/>'


def line(x0, y0, x1, y1, width=1, more=""):
    return f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke-width="{width}"{more}/>'


def dot(x, y, radius=3):
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="currentColor" stroke="none"/>'


def text(x, y, words, anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="currentColor" stroke="none">{words}</text>'
