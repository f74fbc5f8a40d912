"""Prints interval-pieces.svg: bounds of a function over seven pieces of a ray."""
from math import cos
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import line, polyline, svg, text  # noqa: E402

PIECES, LEFT, WIDTH, AXIS, HEIGHT = 7, 40, 546, 130, 70


def value(t):
    """Of F at t in [0, 1], in heights of the figure above its axis."""
    return cos(5.8 * t + 0.1) + 0.3 - 0.25 * t


def bounds(a, b):
    """Like interval arithmetic, too wide: those of the cosine and of the rest are added."""
    ends = [cos(5.8 * t + 0.1) for t in (a, b)]
    low = -1 if 5.8 * a + 0.1 <= 3.14159265 <= 5.8 * b + 0.1 else min(ends)
    return low + 0.3 - 0.25 * b, max(ends) + 0.3 - 0.25 * a


elements = []
for piece in range(PIECES):
    a, b = piece / PIECES, (piece + 1) / PIECES
    low, high = bounds(a, b)
    assert all(low <= value(a + (b - a) * i / 50) <= high for i in range(51))
    dark = low <= 0 <= high
    elements.append(f'<rect x="{LEFT + WIDTH * a:.1f}" y="{AXIS - HEIGHT * high:.1f}" width="{WIDTH / PIECES:.1f}" height="{HEIGHT * (high - low):.1f}" '
                    f'stroke-width="0.8" stroke-opacity="0.7" fill="currentColor" fill-opacity="{0.2 if dark else 0.05}"/>')
elements += [line(30, AXIS, 620, AXIS, 1.4), polyline([(LEFT + WIDTH * i / 140, AXIS - HEIGHT * value(i / 140)) for i in range(141)], 2.2),
             text(625, 135, "t"), text(32, 22, "F along the ray"), text(40, 225, "start"), text(560, 225, "end"), text(230, 225, "dark: may contain a root")]
print(svg(660, 240, "A function along a ray, with a box that bounds it over each of seven pieces", elements))
