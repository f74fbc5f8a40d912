"""Prints colour-density.svg: the density of sampled wavelengths (kernels/shade/wavelength.clh), and the observer's y (host/color/tables/cie1931.csv)."""
from math import sqrt
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import constants, dot, line, polyline, svg, table, text  # noqa: E402

SHORTEST, LONGEST, U = 360, 830, 0.17
values = constants("kernels/shade/wavelength.clh")
centre, width, first, last = (values[f"WAVE_{name}"] for name in ("CENTER", "WIDTH", "FIRST", "LAST"))


def sample(u):
    s = first + u * (last - first)
    return centre + width * (s - 0.5) / sqrt(s * (1 - s))


def relative_density(wavelength):
    return (1 + ((wavelength - centre) / width) ** 2) ** -1.5


def x_of(wavelength):
    return 40 + 420 * (wavelength - SHORTEST) / (LONGEST - SHORTEST)


def y_of(value):
    return 190 - 170 * value


assert abs(sample(0) - SHORTEST) < 0.01 and abs(sample(1) - LONGEST) < 0.1
observer = [(row[0], row[2]) for row in table("cie1931") if SHORTEST <= row[0] <= LONGEST]
highest = max(y for _, y in observer)
elements = ['<path d="M40 12V190H468"/>',
            polyline([(x_of(w), y_of(relative_density(w))) for w in range(SHORTEST, LONGEST + 1, 5)], 1.8),
            polyline([(x_of(w), y_of(y / highest)) for w, y in observer if w % 5 == 0], 1.2, ' stroke-dasharray="4 3"')]
for quarter in (1, 2, 3):
    wavelength = sample(quarter / 4)
    elements.append(line(x_of(wavelength), y_of(relative_density(wavelength)), x_of(wavelength), 190, 0.8, ' opacity="0.6"'))
elements += [dot(x_of(sample((U + i / 4) % 1)), 190, 3.5 if i else 5) for i in range(4)]
elements += [text(x_of(w), 210, w, "middle") for w in range(400, 801, 100)]
elements += [text(454, 226, "wavelength, nm", "end"), text(335, 84, "density p (solid)"), text(335, 104, "y of CIE 1931 (dashed)"),
             text(x_of(sample(U)), 180, "hero", "middle")]
print(svg(490, 235, "The density of sampled wavelengths and the eye's sensitivity", elements))
