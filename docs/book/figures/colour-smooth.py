"""Prints colour-smooth.svg: four spectra, a sigmoid of quadratics."""
from math import sqrt
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import line, polyline, svg, text  # noqa: E402

SPECTRA = (("slope", 0, 9, -4), ("hill", -40, 40, -8), ("valley", 80, -64, 10), ("narrow hill", -200, 180, -38))

elements = []
for at, (name, *coefficients) in enumerate(SPECTRA):
    assert all(abs(c) <= 200 for c in coefficients)
    left, curve = 14 + 122 * at, []
    for i in range(101):
        x = (coefficients[0] * i / 100 + coefficients[1]) * i / 100 + coefficients[2]
        curve.append((left + i, 112 - 90 * (0.5 + x / (2 * sqrt(1 + x * x)))))
    elements += [f'<path d="M{left} 22V112H{left + 100}" stroke-width="0.8"/>', line(left, 22, left + 100, 22, 0.5, ' stroke-dasharray="2 3"'),
                 polyline(curve, 1.6), text(left + 50, 128, name, "middle")]
elements += [text(2, 26, "1"), text(2, 116, "0")]
print(svg(500, 138, "Four smooth spectra: a slope, a hill, a valley and a narrow hill", elements))
