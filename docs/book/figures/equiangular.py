"""Prints equiangular.svg: distances at equal angles from the light."""
from math import atan, tan
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import dot, line, svg, text  # noqa: E402

LIGHT_X, LIGHT_Y, FIRST, LAST, RAY_Y, COUNT = 250, 60, 40, 410, 170, 10
distance = RAY_Y - LIGHT_Y
angles = [atan((x - LIGHT_X) / distance) for x in (FIRST, LAST)]
places = [LIGHT_X + distance * tan(angles[0] + (i + 0.5) / COUNT * (angles[1] - angles[0])) for i in range(COUNT)]

elements = [dot(LIGHT_X, LIGHT_Y, 5), text(262, 58, "light"), line(FIRST, RAY_Y, LAST, RAY_Y, 2),
            line(LIGHT_X, LIGHT_Y, LIGHT_X, RAY_Y, 1.5, ' stroke-dasharray="4 3"')]
elements += [line(LIGHT_X, LIGHT_Y, x, RAY_Y, 1, ' opacity="0.5"') for x in places] + [dot(x, RAY_Y) for x in places]
elements += [text(36, 190, "0"), text(396, 190, '<tspan font-style="italic">t</tspan><tspan font-size="9" dy="3">max</tspan>'),
             text(246, 190, '<tspan font-style="italic">t</tspan><tspan font-size="9" dy="3">0</tspan>'), text(256, 130, '<tspan font-style="italic">D</tspan>')]
print(svg(440, 210, "Distances at equal angles from a light", elements))
