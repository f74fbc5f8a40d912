#!/usr/bin/env python3
"""Scenes of many instances and of many triangles, for growth.py and for a look at traversal.

    tests/bench/instances.py sponge.pbrt --levels 4 --inner 1 --turn 25
    tests/bench/instances.py nested.pbrt --nested --levels 4 --inner 2

pbrt-v4 refuses an ObjectInstance inside an object, so a sponge is two levels: an object of 20^inner cubes, placed 20^(levels - inner) times.
"""

import argparse
import itertools
import math
import pathlib
import struct

HEAD = ('LookAt {eye}  0 0 0  0 0 1\nCamera "perspective" "float fov" {fov}\nFilm "rgb" "integer xresolution" 256 "integer yresolution" 256\n'
        'Integrator "path" "integer maxdepth" 5\nWorldBegin\nLightSource "infinite" "rgb L" [ 1 1 1 ]\nLightSource "distant" "point3 from" [ 2 -3 5 ] "rgb L" [ 2 2 2 ]\n'
        'Material "diffuse" "rgb reflectance" [ 0.6 0.5 0.4 ]\n')
CORNERS = list(itertools.product((-1, 1), repeat=3))
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def product(a, b):
    """Of maps x -> m x + t, as (rows of m, t): b first, then a."""
    m, t = a
    n, s = b
    return ([[sum(m[i][k] * n[k][j] for k in range(3)) for j in range(3)] for i in range(3)],
            [sum(m[i][k] * s[k] for k in range(3)) + t[i] for i in range(3)])


def places(levels, turn):
    """The 20^levels cubes of a Menger sponge that fills the cube [-1, 1]^3; each level is turned by `turn` degrees about z in the one above."""
    c, s = math.cos(math.radians(turn)) / 3, math.sin(math.radians(turn)) / 3
    steps = [([[c, -s, 0], [s, c, 0], [0, 0, 1 / 3]], [2 / 3 * x for x in cell])
             for cell in itertools.product((-1, 0, 1), repeat=3) if cell.count(0) < 2]
    found = [([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])]
    for _ in range(levels):
        found = [product(outer, inner) for outer in found for inner in steps]
    return found


def placed(what, place):
    m, t = place
    columns = [m[i][j] for j in range(3) for i in (0, 1, 2)]
    words = [*columns[:3], 0, *columns[3:6], 0, *columns[6:], 0, *t, 1]
    return f'TransformBegin\nConcatTransform [ {" ".join(f"{w:.7g}" for w in words)} ]\n{what}\nTransformEnd\n'


def instance(name, place):
    return placed(f'ObjectInstance "{name}"', place)


def cubes(where, size=1.):
    points = [[size * sum(m[i][k] * p[k] for k in range(3)) + t[i] for i in range(3)] for m, t in where for p in CORNERS]
    indices = [8 * n + corner for n in range(len(where)) for a, b, c, d in SIDES for corner in (a, b, c, a, c, d)]
    return (f'Shape "trianglemesh" "point3 P" [ {" ".join(f"{x:.7g}" for p in points for x in p)} ] '
            f'"integer indices" [ {" ".join(map(str, indices))} ]\n')


def write_sponge(file, levels, inner, turn=0.):
    """12 * 20^levels triangles are seen. inner = levels: one mesh, no instance."""
    with open(file, "w") as out:
        out.write(HEAD.format(eye="3 -4 2.6", fov=36))
        if inner == levels:
            out.write(cubes(places(levels, turn)))
            return file
        out.write('ObjectBegin "part"\n' + cubes(places(inner, turn)) + "ObjectEnd\n")
        for place in places(levels - inner, turn):
            out.write(instance("part", place))
    return file


def write_sponge_of_files(file, levels):
    """20^levels cubes, each an instance: the file of each level names that of the next smaller twenty times."""
    for level in range(1, levels + 1):
        inner = 'ObjectInstance "part"' if level == 1 else f'Include "level{level - 1}.pbrt"'
        file.with_name(f"level{level}.pbrt").write_text("".join(placed(inner, place) for place in places(1, 0.)))
    file.write_text(HEAD.format(eye="3 -4 2.6", fov=36) + 'ObjectBegin "part"\n' + cubes(places(0, 0.)) + f'ObjectEnd\nInclude "level{levels}.pbrt"\n')
    return file


def write_nested(file, levels, inner, turn=0., flat=False):
    """Sponges of small cubes within one another: the object of 20^inner cubes at each place of each level, so that the boxes of instances overlap.
    flat: the same triangles in one mesh."""
    within, own = [place for level in range(levels - inner + 1) for place in places(level, turn)], places(inner, turn)
    with open(file, "w") as out:
        out.write(HEAD.format(eye="3 -4 2.6", fov=36))
        if flat:
            out.write(cubes([product(outer, place) for outer in within for place in own], 0.3))
            return file
        out.write('ObjectBegin "part"\n' + cubes(own, 0.3) + "ObjectEnd\n")
        for place in within:
            out.write(instance("part", place))
    return file


def write_ball(file, quads, bump=0.):
    """A PLY of 2 quads^2 triangles: a sphere of radius 1, with waves of height `bump`."""
    n = quads + 1
    with open(file, "wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {n * n}\nproperty float x\nproperty float y\nproperty float z\n"
                  f"element face {2 * quads * quads}\nproperty list uchar int vertex_indices\nend_header\n".encode())
        for j in range(n):
            polar = math.pi * j / quads
            row = []
            for i in range(n):
                around = 2 * math.pi * i / quads
                r = 1 + bump * math.sin(40 * polar) * math.sin(31 * around)
                row += [r * math.sin(polar) * math.cos(around), r * math.sin(polar) * math.sin(around), r * math.cos(polar)]
            out.write(struct.pack(f"<{len(row)}f", *row))
        faces = struct.Struct("<B3iB3i")
        for j in range(quads):
            a = j * n
            out.write(b"".join(faces.pack(3, a + i, a + i + 1, a + i + n, 3, a + i + 1, a + i + n + 1, a + i + n) for i in range(quads)))
    return file


def write_balls(file, triangles, files):
    """`files` different balls of triangles / files triangles each."""
    with open(file, "w") as out:
        out.write(HEAD.format(eye="0 -9 6", fov=40))
        for k in range(files):
            ball = write_ball(file.with_name(f"ball-{k}.ply"), round(math.sqrt(triangles / files / 2)), 0.02 + 0.01 * k)
            out.write(f'TransformBegin\nTranslate {2.2 * (k % 2) - 1.1} {2.2 * (k // 2) - 1.1} 0\nShape "plymesh" "string filename" "{ball.name}"\nTransformEnd\n')
    return file


def write_copies(file, triangles, count):
    """`count` instances of a ball, on a grid, each turned in its own way."""
    side = math.ceil(math.sqrt(count))
    ball = write_ball(file.with_name("ball.ply"), round(math.sqrt(triangles / 2)), 0.02)
    with open(file, "w") as out:
        out.write(HEAD.format(eye="0 -3 2.5", fov=40))
        out.write(f'ObjectBegin "part"\nShape "plymesh" "string filename" "{ball.name}"\nObjectEnd\n')
        size = 1.2 / side
        for k in range(count):
            a = k * 2.399963
            m = [[size * math.cos(a), -size * math.sin(a), 0], [size * math.sin(a), size * math.cos(a), 0], [0, 0, size]]
            out.write(instance("part", (m, [2.4 * (k % side + .5) / side - 1.2, 2.4 * (k // side + .5) / side - 1.2, 0])))
    return file


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scene", type=pathlib.Path)
    options.add_argument("--levels", type=int, default=4)
    options.add_argument("--inner", type=int, default=1)
    options.add_argument("--turn", type=float, default=0, metavar="DEGREES")
    options.add_argument("--nested", action="store_true", help="sponges within sponges, whose boxes overlap")
    options.add_argument("--flat", action="store_true", help="one mesh, no instances")
    o = options.parse_args()
    if o.nested:
        write_nested(o.scene, o.levels, o.inner, o.turn, o.flat)
    else:
        write_sponge(o.scene, o.levels, o.levels if o.flat else o.inner, o.turn)


if __name__ == "__main__":
    main()
