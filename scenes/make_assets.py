#!/usr/bin/env python3
"""Makes everything in scenes/assets/ from nothing: python3 scenes/make_assets.py

Only Python's own library is needed; the same files come out every time.
"""
import math
import pathlib
import random
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent / "assets"


def write_png(name, width, height, pixel):
    """An 8-bit PNG; pixel(x, y) gives 3 (RGB) or 4 (RGBA) values in [0, 1], as they are stored. Row 0 is the top."""
    channels = len(pixel(0, 0))
    rows = bytearray()
    for y in range(height):
        rows.append(0)  # no filter
        for x in range(width):
            rows += bytes(min(255, max(0, round(255 * v))) for v in pixel(x, y))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    (FOLDER / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def write_exr(name, width, height, pixel):
    """An EXR of halves, compressed line by line with zlib (ZIPS); pixel(x, y) gives linear R, G, B."""
    def attribute(key, kind, data):
        return key + b"\0" + kind + b"\0" + struct.pack("<i", len(data)) + data

    channels = b"".join(c + b"\0" + struct.pack("<iiii", 1, 0, 1, 1) for c in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += attribute(b"channels", b"chlist", channels) + attribute(b"compression", b"compression", b"\2")
    header += attribute(b"dataWindow", b"box2i", window) + attribute(b"displayWindow", b"box2i", window)
    header += attribute(b"lineOrder", b"lineOrder", b"\0") + attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    header += attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0)) + attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"

    lines = []
    for y in range(height):
        row = [pixel(x, y) for x in range(width)]
        raw = struct.pack(f"<{3 * width}e", *(p[c] for c in (2, 1, 0) for p in row))
        shuffled = raw[0::2] + raw[1::2]
        deltas = bytes([shuffled[0]]) + bytes((b - a + 128) & 255 for a, b in zip(shuffled, shuffled[1:]))
        packed = zlib.compress(deltas, 9)
        packed = packed if len(packed) < len(raw) else raw
        lines.append(struct.pack("<ii", y, len(packed)) + packed)
    offset = len(header) + 8 * height
    table = b""
    for line in lines:
        table += struct.pack("<Q", offset)
        offset += len(line)
    (FOLDER / name).write_bytes(header + table + b"".join(lines))


def equal_area_direction(u, v):
    """The direction of a point of the unit square in pbrt-v4's octahedral equal-area mapping (Clarberg 2008); +z is the middle."""
    u, v = 2 * u - 1, 2 * v - 1
    distance = 1 - (abs(u) + abs(v))
    r = 1 - abs(distance)
    phi = (1 if r == 0 else (abs(v) - abs(u)) / r + 1) * math.pi / 4
    s = r * math.sqrt(2 - r * r)
    return math.copysign(s * math.cos(phi), u), math.copysign(s * math.sin(phi), v), math.copysign(1 - r * r, distance)


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth(low, high, x):
    t = min(1, max(0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


# ---- the sky: an evening, the sun low in the east ---------------------------------------------------------------------------

def sky(d):
    """Radiance (linear sRGB) from a direction; z is up, the sun stands 20 degrees high towards +x -y."""
    high = mix((.95, .62, .38), (.13, .25, .52), 1 - (1 - max(0, d[2])) ** 3)
    base = mix((.12, .1, .09), high, smooth(-.5, 0, d[2]))  # no edge at the horizon: the mapping would make teeth of it
    sun = (math.cos(math.radians(20)) * .6, -math.cos(math.radians(20)) * .8, math.sin(math.radians(20)))
    angle = math.degrees(math.acos(max(-1, min(1, sum(a * b for a, b in zip(d, sun))))))
    glow = .8 * math.exp(-angle / 14)
    disk = 95 * (1 - smooth(4, 6, angle))
    return tuple(b + c * (glow + disk) for b, c in zip(base, (1, .78, .5)))


def make_sky(resolution=128, samples=3):
    def texel(x, y):
        total = [0, 0, 0]
        for j in range(samples):
            for i in range(samples):
                value = sky(equal_area_direction((x + (i + .5) / samples) / resolution, (y + (j + .5) / samples) / resolution))
                total = [a + b / samples ** 2 for a, b in zip(total, value)]
        return total
    write_exr("sky.exr", resolution, resolution, texel)


# ---- tiles: color, height and normals of the same wall ---------------------------------------------------------------------

def tile_height(x, y):
    """In [0, 1], for x and y in [0, 1): four by four bricks, every other row moved by half a brick, periodic."""
    row = math.floor(4 * y)
    u, v = (4 * x + (row % 2) / 2) % 1, 4 * y - row
    edge = min(u, 1 - u, v, 1 - v)
    return smooth(.03, .11, edge)


def make_tiles(size=128):
    rng = random.Random(7)
    shades = [mix((.72, .3, .2), (.87, .5, .32), rng.random()) for _ in range(16)]

    def color(x, y):
        px, py = (x + .5) / size, (y + .5) / size
        row = math.floor(4 * py)
        column = math.floor(4 * px + (row % 2) / 2) % 4
        return mix((.82, .8, .76), shades[4 * row + column], tile_height(px, py))

    def height(x, y):
        h = tile_height((x + .5) / size, (y + .5) / size)
        return h, h, h

    def normal(x, y):
        """Row 0 is v = 1. Slopes of a relief of 4 % of the image's side."""
        def h(i, j):
            return tile_height(((x + i + .5) / size) % 1, ((y + j + .5) / size) % 1)
        du, dv = .04 * size / 2 * (h(1, 0) - h(-1, 0)), -.04 * size / 2 * (h(0, 1) - h(0, -1))
        length = math.sqrt(du * du + dv * dv + 1)
        return (.5 - .5 * du / length, .5 - .5 * dv / length, .5 + .5 / length)

    write_png("tiles.png", size, size, color)
    write_png("tiles-height.png", size, size, height)
    write_png("tiles-normal.png", size, size, normal)


def make_leaf(size=128):
    """A leaf, cut out by its alpha."""
    def pixel(x, y):
        u, v = (x + .5) / size * 2 - 1, 1 - (y + .5) / size * 2
        width = .62 * math.sqrt(max(0, 1 - v * v)) * (.75 - .25 * v)
        inside = abs(u) < width and abs(v) < .97
        vein = min(abs(u) / .03, abs((5 * (v - .9 * abs(u))) % 1 - .5) / .06 + .4)
        green = mix((.55, .72, .3), (.2, .48, .14), smooth(.4, 1.4, vein))
        return (*green, 1. if inside else 0.)
    write_png("leaf.png", size, size, pixel)


# ---- a cloud on a grid -----------------------------------------------------------------------------------------------------

def value_noise(rng):
    values = [[[rng.random() for _ in range(16)] for _ in range(16)] for _ in range(16)]

    def noise(x, y, z):
        ix, iy, iz = math.floor(x), math.floor(y), math.floor(z)
        fx, fy, fz = (t * t * (3 - 2 * t) for t in (x - ix, y - iy, z - iz))
        total = 0
        for k, wz in ((0, 1 - fz), (1, fz)):
            for j, wy in ((0, 1 - fy), (1, fy)):
                for i, wx in ((0, 1 - fx), (1, fx)):
                    total += wx * wy * wz * values[(ix + i) % 16][(iy + j) % 16][(iz + k) % 16]
        return total
    return noise


def make_cloud(nx=32, ny=20, nz=24):
    """A flat-bottomed heap of five balls with ragged edges, in the box from (0, 0, 0) to (1, 1, 1)."""
    noise = value_noise(random.Random(3))
    balls = [(.5, .42, .5, .3), (.27, .3, .5, .2), (.74, .32, .48, .2), (.42, .36, .3, .2), (.58, .34, .72, .2)]
    values = []
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                x, y, z = (i + .5) / nx, (j + .5) / ny, (k + .5) / nz
                ragged = sum(noise(f * x * 4, f * y * 3, f * z * 4) / f for f in (1, 2, 4)) - .85
                inside = max(1 - math.dist((x, y, z), b[:3]) / b[3] for b in balls)
                density = smooth(0, .35, inside + .55 * ragged) * smooth(.08, .2, y)
                values.append(f"{density:.2f}".lstrip("0") if density >= .005 else "0")
    rows = "\n".join(" ".join(values[i:i + nx]) for i in range(0, len(values), nx))
    (FOLDER / "cloud.pbrt").write_text(
        "# Made by make_assets.py: a cloud in the unit cube. Extinction at its thickest: 12 a unit; it hardly absorbs.\n"
        'MakeNamedMedium "cloud" "string type" "uniformgrid" "rgb sigma_a" [ .02 .02 .02 ] "rgb sigma_s" [ 12 12 12 ] "float g" .5\n'
        f'    "integer nx" {nx} "integer ny" {ny} "integer nz" {nz} "point3 p0" [ 0 0 0 ] "point3 p1" [ 1 1 1 ]\n'
        f'    "float density" [\n{rows}\n]\n')


# ---- the hero's spheres ----------------------------------------------------------------------------------------------------

def make_spiral(count=400):
    """Balls on a floor, each turned by the golden angle from the one before, as the seeds of a sunflower (Vogel 1979)."""
    golden = math.pi * (3 - math.sqrt(5))
    kinds = {0: "gold", 5: "gold", 8: "glass", 2: "coral", 7: "coral", 10: "coral", 3: "night", 11: "night"}
    lines = ["# Made by make_assets.py: Vogel's spiral. Every thirteenth ball is of one kind, for Fibonacci's numbers are its arms."]
    for i in range(6, count):
        t = i / count
        r, angle, radius = 4.1 * math.sqrt(t), i * golden, .1 + .085 * math.sqrt(t)
        lines.append(f'AttributeBegin Translate {r * math.cos(angle):.4f} {radius:.4f} {r * math.sin(angle):.4f} '
                     f'Scale {radius:.4f} {radius:.4f} {radius:.4f} ObjectInstance "{kinds.get(i % 13, "pearl")}" AttributeEnd')
    (FOLDER / "spiral.pbrt").write_text("\n".join(lines) + "\n")


def make_waves(nx=48, nz=36, width=4.0, depth=3.0):
    """The surface of a pool: five waves of different directions, with the normals of their sum."""
    rng = random.Random(11)
    waves = [(6 + 5 * rng.random(), 2 * math.pi * rng.random(), 2 * math.pi * rng.random(), 0.012 + 0.008 * rng.random()) for _ in range(5)]
    points, normals = [], []
    for j in range(nz + 1):
        for i in range(nx + 1):
            x, z = width * (i / nx - 0.5), depth * (j / nz - 0.5)
            y = slope_x = slope_z = 0
            for k, angle, phase, height in waves:
                kx, kz = k * math.cos(angle), k * math.sin(angle)
                y += height * math.sin(kx * x + kz * z + phase)
                slope_x += height * kx * math.cos(kx * x + kz * z + phase)
                slope_z += height * kz * math.cos(kx * x + kz * z + phase)
            length = math.sqrt(slope_x ** 2 + 1 + slope_z ** 2)
            points.append(f"{x:.4f} {y:.4f} {z:.4f}")
            normals.append(f"{-slope_x / length:.3f} {1 / length:.3f} {-slope_z / length:.3f}")
    corners = [(j * (nx + 1) + i) for j in range(nz) for i in range(nx)]
    triangles = [f"{a} {a + nx + 1} {a + 1} {a + 1} {a + nx + 1} {a + nx + 2}" for a in corners]
    (FOLDER / "waves.pbrt").write_text(
        "# Made by make_assets.py: a sum of five waves.\nShape \"trianglemesh\"\n\"point3 P\" [\n" + "\n".join(points) + "\n]\n\"normal N\" [\n" + "\n".join(normals)
        + "\n]\n\"integer indices\" [\n" + "\n".join(triangles) + "\n]\n")


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    make_sky()
    make_tiles()
    make_leaf()
    make_cloud()
    make_spiral()
    make_waves()
