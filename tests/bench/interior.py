"""A furnished room as a pbrt-v4 scene: many binary PLY meshes of all sizes, a few of them objects that are instanced, grey and lit from everywhere."""

import array
import math
import random

HEADER = "ply\nformat binary_little_endian 1.0\nelement vertex {}\n{}element face {}\nproperty list uint8 int vertex_indices\nend_header\n"


def vase(numbers):
    ripples, waist = numbers.randrange(3, 12), numbers.uniform(0.3, 0.9)

    def point(u, v):
        radius = 0.3 + 0.2 * math.sin(6 * v * waist) + 0.02 * math.sin(ripples * math.tau * u)
        return radius * math.cos(math.tau * u), radius * math.sin(math.tau * u), v
    return point


def cushion(numbers):
    thickness, wrinkles = numbers.uniform(0.1, 0.3), numbers.randrange(2, 9)

    def point(u, v):
        swell = thickness * abs(math.sin(math.pi * u) * math.sin(math.pi * v)) ** 0.5
        return u - 0.5, v - 0.5, swell * (1 + 0.1 * math.sin(wrinkles * math.pi * (u + v)))
    return point


def curtain(numbers):
    folds = numbers.randrange(4, 20)
    return lambda u, v: (u - 0.5, 0.05 * math.sin(folds * math.tau * u) * (0.5 + v), v)


def board(_):
    return lambda u, v: (u - 0.5, v - 0.5, 0.02 * math.cos(8 * u * v))


def write_grid(file, point, size, has_normals, has_uvs):
    """A sheet of size x size squares, two triangles each. Returns how many triangles that is."""
    vertices, faces = array.array("f"), bytearray()
    for row in range(size + 1):
        for column in range(size + 1):
            u, v = column / size, row / size
            x, y, z = point(u, v)
            vertices.extend((x, y, z))
            if has_normals:
                step = 1e-3
                a = [q - p for p, q in zip((x, y, z), point(u + step, v))]
                b = [q - p for p, q in zip((x, y, z), point(u, v + step if v < 0.5 else v - step))]
                n = a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
                length = math.hypot(*n) or 1
                vertices.extend(c / length for c in n)
            if has_uvs:
                vertices.extend((u, v))
    corners = array.array("i", [0])
    for row in range(size):
        for column in range(size):
            first = row * (size + 1) + column
            for triangle in ((first, first + 1, first + size + 2), (first, first + size + 2, first + size + 1)):
                corners[:] = array.array("i", triangle)
                faces += b"\3" + corners.tobytes()
    names = ["x", "y", "z"] + ["nx", "ny", "nz"] * has_normals + ["u", "v"] * has_uvs
    header = HEADER.format((size + 1) ** 2, "".join(f"property float {name}\n" for name in names), 2 * size * size)
    file.write_bytes(header.encode() + vertices.tobytes() + bytes(faces))
    return 2 * size * size


def write_interior(folder, triangles):
    """Writes interior.pbrt and its meshes, about so many triangles, into a folder. Returns the scene's path."""
    numbers = random.Random(7)
    text = ['LookAt 4 -9 2.5  0 0 1.2  0 0 1\nCamera "perspective" "float fov" 60\nFilm "rgb" "integer xresolution" 1280 "integer yresolution" 720',
            'Sampler "independent" "integer pixelsamples" 64\nIntegrator "path" "integer maxdepth" 16\nWorldBegin\nLightSource "infinite" "rgb L" [1 1 1]']
    (folder / "meshes").mkdir(exist_ok=True)
    left, count = triangles, 0
    while left > 0:
        # Sizes spread as furniture's do: most meshes are small, most triangles in large ones
        size = min(max(int(math.exp(numbers.uniform(math.log(3), math.log(220)))), 2), max(int((left / 2) ** 0.5), 1))
        name = f"meshes/mesh{count:04}.ply"
        kind = numbers.choice((vase, cushion, curtain, board))
        left -= write_grid(folder / name, kind(numbers), size, numbers.random() < 0.6, numbers.random() < 0.5)
        grey = f'Material "diffuse" "rgb reflectance" [{" ".join([f"{numbers.uniform(0.2, 0.8):.3f}"] * 3)}]'
        shape = f'Shape "plymesh" "string filename" "{name}"'

        def place():
            return f"Translate {numbers.uniform(-5, 5):.3f} {numbers.uniform(-5, 5):.3f} {numbers.uniform(0, 2.5):.3f} Rotate {numbers.uniform(0, 360):.1f} 0 0 1 Scale {' '.join([f'{numbers.uniform(0.3, 2):.3f}'] * 3)}"
        if count % 8 == 7:
            text.append(f'ObjectBegin "object{count}"\n  {grey}\n  {shape}\nObjectEnd')
            text += [f'AttributeBegin {place()} ObjectInstance "object{count}" AttributeEnd' for _ in range(4)]
        else:
            text.append(f"AttributeBegin\n  {place()}\n  {grey}\n  {shape}\nAttributeEnd")
        count += 1
    for wall in ("Translate 0 0 0", "Translate 0 6 0 Rotate 90 1 0 0", "Translate -6 0 0 Rotate 90 0 1 0"):
        text.append(f'AttributeBegin {wall} Shape "bilinearmesh" "point3 P" [-10 -10 0  10 -10 0  -10 10 0  10 10 0] AttributeEnd')
    scene = folder / "interior.pbrt"
    scene.write_text("\n".join(text) + "\n")
    return scene
