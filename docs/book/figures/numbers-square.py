"""Prints numbers-square.svg: parallels and meridians in the equal-area map of the sphere."""
from math import cos, pi, radians, sin, sqrt
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import dot, polyline, svg, text  # noqa: E402

CENTRE, HALF = 130, 110


def place(latitude, azimuth):
    """Of a direction, both in degrees, in the figure."""
    z, quarter = sin(radians(latitude)), azimuth % 360 / 90
    r, part = sqrt(1 - abs(z)), quarter % 1
    u, v = r * (1 - part), r * part
    if z < 0:
        u, v = 1 - v, 1 - u  # the corner: folded over the side of the diamond
    for _ in range(int(quarter)):
        u, v = -v, u
    return CENTRE + HALF * u, CENTRE - HALF * v


elements = [f'<rect x="{CENTRE - HALF}" y="{CENTRE - HALF}" width="{2 * HALF}" height="{2 * HALF}" stroke-width="1.2"/>']
for latitude in range(-60, 90, 30):
    style = (1.4, "") if latitude == 0 else (0.6, ' opacity="0.6"')
    for quarter in range(4):
        azimuths = [90 * (quarter + i / 12 * 0.999999) for i in range(13)]
        elements.append(polyline([place(latitude, azimuth) for azimuth in azimuths], *style))
for azimuth in range(0, 360, 30):
    elements.append(polyline([place(latitude, azimuth) for latitude in range(90, -1, -5)], 0.6, ' opacity="0.6"'))
    elements.append(polyline([place(latitude - 1e-6, azimuth) for latitude in range(0, -91, -5)], 0.6, ' opacity="0.6"'))
elements += [dot(CENTRE, CENTRE)] + [dot(CENTRE + x * HALF, CENTRE + y * HALF) for x in (-1, 1) for y in (-1, 1)]
elements += [text(140, 122, "N"), text(246, 24, "S"), text(246, 134, "+x"), text(130, 14, "+y", "middle")]
elements += [text(270, y, words) for y, words in ((90, "centre: north pole"), (110, "thick: equator"), (130, "corners: south pole"),
                                                  (156, "thin: latitudes 30 degrees"), (174, "and longitudes 30 degrees apart"))]
print(svg(470, 260, "The sphere of directions in a square, with parallels and meridians", elements))
