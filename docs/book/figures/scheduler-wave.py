"""Prints scheduler-wave.svg: the rays of each bounce, if three of four go on after each: one batch at a time, and a wave that is refilled."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tool"))
from drawing import svg, text  # noqa: E402

GO_ON, BOUNCES, STEP, HEIGHT, LEFT = 0.75, 26, 20, 120, 40
BATCH, BATCHES = 1, 6  # paths of a batch, in waves; batches of the refilled wave
SHADES = (0.55, 0.15, 0.3, 0.08)


def area(below, above, first, base, shade):
    """The steps between two lists of heights, from bounce `first` on."""
    points = []
    for side, heights in ((1, above), (-1, below)):
        steps = [(LEFT + STEP * (first + i + end), base - HEIGHT * height) for i, height in enumerate(heights) for end in (0, 1)]
        points += steps[::side]
    return (f'<polygon points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" fill="currentColor" fill-opacity="{shade}"/>')


elements = []
for batch in range(2):  # each as large as the wave
    heights = [GO_ON ** k for k in range(BOUNCES // 2)]
    elements.append(area([0] * len(heights), heights, batch * BOUNCES // 2, 145, SHADES[batch]))

batches = []  # rays of each batch in each bounce
left = BATCH
for bounce in range(BOUNCES):
    for rays in batches:
        rays.append(rays[-1] * GO_ON)
    room = 1 - sum(rays[-1] for rays in batches)
    while room > 1e-9 and (left > 1e-9 or len(batches) < BATCHES):
        if not batches or left < 1e-9:
            left = BATCH
            batches.append([0.0] * (bounce + 1))
        begun = min(room, left)
        batches[-1][-1] += begun
        room, left = room - begun, left - begun
below = [0.0] * BOUNCES
for number, rays in enumerate(batches):
    above = [low + high for low, high in zip(below, rays)]
    first = next(bounce for bounce, height in enumerate(rays) if height > 0)
    elements.append(area(below[first:], above[first:], first, 325, SHADES[number % len(SHADES)]))
    below = above
for top in (20, 200):
    elements.append(f'<path d="M{LEFT} {top}V{top + 125}H{LEFT + STEP * BOUNCES}" stroke-width="1.6"/>')
    elements += [text(500, top + 143, "bounce"), f'<g transform="translate(28 {top + 80}) rotate(-90)">{text(0, 0, "rays", "middle")}</g>']
elements += [text(140, 40, "one batch at a time"), text(190, 194, "refilled: one shade for each batch")]
print(svg(580, 350, "Rays in each bounce: one batch at a time, and a wave that is refilled", elements))
