#!/usr/bin/env python3
"""Makes all but ring.nvdb (which make_ring.cpp makes) in scenes/gallery/assets/ from nothing: python3 scenes/gallery/make_assets.py

Only Python's own library is needed; the same files come out every time.
"""
import math
import pathlib
import random
import struct
import sys

sys.dont_write_bytecode = True  # scenes/ is installed as it is
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import make_assets as shared  # noqa: E402

FOLDER = pathlib.Path(__file__).parent / "assets"


def curve(points, width0, width1, kind="cylinder"):
    numbers = "  ".join(" ".join(f"{c:.3g}" for c in p) for p in points)
    return f'Shape "curve" "string type" "{kind}" "point3 P" [ {numbers} ] "float width0" {width0:.3g} "float width1" {width1:.3g}'


def write(name, comment, lines):
    (FOLDER / name).write_text(f"# Made by make_assets.py: {comment}\n" + "\n".join(lines) + "\n")


def make_tuft(count=260):
    """Blades that stand in a disk and bend outwards."""
    rng, lines = random.Random(5), []
    for _ in range(count):
        r, angle, lean, height = .55 * math.sqrt(rng.random()), 2 * math.pi * rng.random(), .15 + .85 * rng.random(), .8 + .8 * rng.random()
        x, z = r * math.cos(angle), r * math.sin(angle)
        dx, dz = lean * math.cos(angle + rng.uniform(-.6, .6)), lean * math.sin(angle + rng.uniform(-.6, .6))
        lines.append(curve([(x, 0, z), (x + .1 * dx, .4 * height, z + .1 * dz), (x + .45 * dx, .85 * height, z + .45 * dz),
                            (x + dx, height * (1 - .25 * lean), z + dz)], .05, .004, "flat"))
    write("tuft.pbrt", "blades of grass.", lines)


def make_lock(count=700):
    """Fibres of a lock that hangs in a wave: a disk, moved along a curve, in which each fibre has its place."""
    rng, lines = random.Random(6), []
    for _ in range(count):
        r, angle, stray = math.sqrt(rng.random()), 2 * math.pi * rng.random(), rng.gauss(0, .03)
        u, v = r * math.cos(angle), r * math.sin(angle)

        def place(t):
            wide = .34 * (1 - .45 * t) * (1 + 3 * abs(stray) * t)
            turn = 2.2 * t
            return (-.75 + 1.5 * t + .28 * math.sin(5.5 * t) + wide * (u * math.cos(turn) - v * math.sin(turn)) + stray * t,
                    1.75 - 1.55 * t + .14 * math.sin(7 * t + 1) + wide * v * .9, .1 + wide * (u * math.sin(turn) + v * math.cos(turn)))
        for k in range(3):  # pieces of a smooth curve, from Hermite's to Bezier's form
            a, b, d = k / 3, (k + 1) / 3, 1e-3
            p0, p3 = place(a), place(b)
            s0, s3 = ([(q - p) / (2 * d) / 9 for p, q in zip(place(t - d), place(t + d))] for t in (a, b))
            lines.append(curve([p0, [p + s for p, s in zip(p0, s0)], [p - s for p, s in zip(p3, s3)], p3], .015, .015))
    write("lock.pbrt", "a lock of hair.", lines)


def make_lamps(count=400):
    """Little lamps on the floor and in the air around what is lit, of random hues."""
    rng, lines = random.Random(9), []
    while len(lines) < count:
        x, y, z = rng.uniform(-4, 4), .05 + 1.6 * rng.random() ** 3, rng.uniform(-1.9, 6)
        if math.hypot(x, z) < 1.6 and y < 1.7:
            continue
        hue, power = rng.random(), 120 * rng.random() ** 2 + 20
        rgb = [power * (.15 + max(0, math.cos(2 * math.pi * (hue - k / 3))) ** 1.5) for k in range(3)]
        radiance = " ".join(f"{c:.2f}" for c in rgb)
        lines.append(f'AttributeBegin AreaLightSource "diffuse" "rgb L" [ {radiance} ] Translate {x:.2f} {y:.2f} {z:.2f} '
                     'Shape "sphere" "float radius" .035 AttributeEnd')
    write("lamps.pbrt", "four hundred lamps.", lines)


def grid(n, value):
    return [value((i + .5) / n, (j + .5) / n, (k + .5) / n) for k in range(n) for j in range(n) for i in range(n)]


def cube(n):
    """The parameters of a grid of n values along each side of the unit cube."""
    return [f'    "integer nx" {n} "integer ny" {n} "integer nz" {n} "point3 p0" [ 0 0 0 ] "point3 p1" [ 1 1 1 ]']


def make_colours(n=20):
    """Scattering of a hue that turns around the cube's axis, in a ball with bands."""
    def value(x, y, z):
        x, y, z = 2 * x - 1, 2 * y - 1, 2 * z - 1
        inside = shared.smooth(0, .25, .95 - math.sqrt(x * x + y * y + z * z)) * (.55 + .45 * math.cos(9 * y + 2 * math.atan2(z, x)))
        hue = math.atan2(z, x) / (2 * math.pi) + .3 * y
        return " ".join(f"{inside * (.06 + .94 * max(0, math.cos(2 * math.pi * (hue - k / 3)))):.2f}" for k in range(3))
    write("colours.pbrt", "a grid of colours in the unit cube.",
          ['MakeNamedMedium "colours" "string type" "rgbgrid"', *cube(n),
           '    "float scale" 9 "rgb sigma_s" [', *grid(n, value), "    ]", '    "rgb sigma_a" [', *["0 0 0 " * n] * n ** 2, "    ]"])


def make_fire(n=24):
    """Temperature and density of a flame in the unit cube: narrower towards its tip, ragged by noise that rises."""
    noise = shared.value_noise(random.Random(4))

    def heat(x, y, z):
        ragged = sum(noise(f * x * 3, f * y * 2, f * z * 3) / f for f in (1, 2, 4)) - .87
        sway = .1 * math.sin(5 * y)
        r = math.hypot(x - .5 - sway * y, z - .5) / (.36 * (1.02 - y) ** .75 * shared.smooth(-.12, .2, y) + 1e-3)
        return shared.smooth(0, .8, 1 - r + .7 * ragged) * shared.smooth(1, .55, y + .3 * ragged)
    values = grid(n, heat)

    def text(scale):
        return [" ".join(f"{scale * v:.3g}" for v in values[i:i + n]) for i in range(0, n ** 3, n)]
    write("fire.pbrt", "a flame in the unit cube; temperature in units of 100 K.",
          ['MakeNamedMedium "fire" "string type" "uniformgrid"', *cube(n),
           '    "rgb sigma_a" [ 1.6 1.6 1.6 ] "rgb sigma_s" [ .4 .4 .4 ] "float temperaturescale" 100',
           '    "float density" [', *text(1), "    ]", '    "float Lescale" [', *text(.15), "    ]",
           '    "float temperature" [', *text(21), "    ]"])


def make_beams(size=256):
    """Intensity by direction, in the equal-area mapping: seven beams around the axis, and one along it."""
    def pixel(x, y):
        d = shared.equal_area_direction((x + .5) / size, (y + .5) / size)
        tilt, turn = math.degrees(math.acos(max(-1, min(1, d[2])))), math.atan2(d[1], d[0])
        beam = shared.smooth(.55, .9, math.cos(7 * turn)) * shared.smooth(20, 26, tilt) * shared.smooth(62, 50, tilt)
        value = max(.03, beam, shared.smooth(13, 10, tilt))
        return value, value * .85, value * .6
    shared.FOLDER = FOLDER
    shared.write_png("beams.png", size, size, pixel)


def make_measured(alpha=.25, facets=32, thetas=7, color=5):
    """GGX facets of a metal that does not exist: blue light is mirrored at small angles, and red at large ones."""
    def density(m):
        return 1 / (math.pi * alpha ** 2 * (math.cos(m) ** 2 + math.sin(m) ** 2 / alpha ** 2) ** 2)

    def area(t):
        return (math.cos(t) + math.sqrt(math.cos(t) ** 2 + alpha ** 2 * math.sin(t) ** 2)) / 2

    def angle(x):
        return (x / (facets - 1)) ** 2 * math.pi / 2

    theta = [math.pi / 2 * i / (thetas - 1) for i in range(thetas)]
    waves = list(range(360, 831, 47))
    ndf, sigma = ([f(angle(x)) for _ in range(2) for x in range(facets)] for f in (density, area))
    vndf, spectra = [], []
    for t in theta:
        for y in range(facets):
            for x in range(facets):
                m, turn = angle(x), 2 * math.pi * y / (facets - 1) - math.pi
                cosine = math.sin(m) * math.cos(turn) * math.sin(t) + math.cos(m) * math.cos(t)
                vndf.append(density(m) * max(cosine, 0) / area(t) * 2 * math.pi ** 2 * x / (facets - 1) * math.sin(m))
        for nm in waves:
            peak = 430 + 190 * (t / (math.pi / 2)) ** 1.2
            spectra += [.06 + .75 * math.exp(-((nm - peak) / 75) ** 2) + .3 * math.exp(-((nm - 690) / 60) ** 2)] * color ** 2
    text = b"GGX facets whose colour changes with the angle"
    arrays = {"phi_i": ([1], [0]), "theta_i": ([thetas], theta), "wavelengths": ([len(waves)], waves), "ndf": ([2, facets], ndf),
              "sigma": ([2, facets], sigma), "vndf": ([1, thetas, facets, facets], vndf),
              "luminance": ([1, thetas, color, color], [1] * thetas * color ** 2),
              "spectra": ([1, thetas, len(waves), color, color], spectra)}
    fields = {name: (10, shape, struct.pack(f"<{len(v)}f", *v)) for name, (shape, v) in arrays.items()}
    fields |= {"description": (1, [len(text)], text), "jacobian": (1, [1], b"\1")}
    offset = 18 + sum(13 + len(name) + 8 * len(field[1]) for name, field in fields.items())
    head, data = b"tensor_file\0\1\0" + struct.pack("<I", len(fields)), b""
    for name, (kind, shape, values) in fields.items():
        head += struct.pack("<H", len(name)) + name.encode()
        head += struct.pack("<HBQ", len(shape), kind, offset + len(data)) + struct.pack(f"<{len(shape)}Q", *shape)
        data += values
    (FOLDER / "violet.bsdf").write_bytes(head + data)


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / "lens.dat").write_text("# A biconvex lens and a stop behind it, in mm: radius, thickness, index of refraction, diameter\n"
                                     "35 6 1.5168 18\n-35 2 1 18\n0 30 0 10\n")
    for make in (make_tuft, make_lock, make_lamps, make_colours, make_fire, make_beams, make_measured):
        make()
