"""Prints numbers-net.svg: 16 points of the default sampler's code, compiled from kernels/math/random.clh."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import dot, line, run, svg  # noqa: E402
from fragments import ROOT  # noqa: E402

SEED, DIMENSION = 3, "camera_dimensions + dimension_direction"
SIZE = 160

random_code = (ROOT / "kernels/math/random.clh").read_text(encoding="utf-8").replace('#include "math/vector.clh"', "")
numbers = run(f'''#include <cstdio>
typedef unsigned uint;
#define FN static inline
enum {{ HAS_SOBOL = 1, HAS_JOINT_PAIRS = 1 }};
#define PORTABLE_CLH  /* of which nothing is needed */
#include "eikonal/dimensions.h"
using namespace eikonal;
static vec2 make_vec2(float x, float y) {{ return {{x, y}}; }}
{random_code}
int main() {{
    for (uint sample = 0; sample < 16; ++sample) {{
        const vec2 p = sample_2d({SEED}, sample, {DIMENSION});
        std::printf("%.9g %.9g ", p.x, p.y);
    }}
}}''')
points = list(zip(numbers[::2], numbers[1::2]))

elements = []
for at, (columns, rows) in enumerate(((16, 1), (4, 4), (1, 16))):
    # Each cell has one point
    assert len({(int(x * columns), int(y * rows)) for x, y in points}) == 16
    left, top = 10 + 180 * at, 10
    elements.append(f'<rect x="{left}" y="{top}" width="{SIZE}" height="{SIZE}" stroke-width="1.2"/>')
    elements += [line(left + SIZE * i / columns, top, left + SIZE * i / columns, top + SIZE, 0.5, ' opacity="0.5"') for i in range(1, columns)]
    elements += [line(left, top + SIZE * i / rows, left + SIZE, top + SIZE * i / rows, 0.5, ' opacity="0.5"') for i in range(1, rows)]
    elements += [dot(left + SIZE * x, top + SIZE * (1 - y)) for x, y in points]
print(svg(540, 180, "Sixteen points under three grids of sixteen cells", elements))
