"""Scenes for side-by-side renders, made here: triangles, materials that every renderer has, lamps or a sky. peer_formats.py writes them.

World space is right-handed. Images are square, filters are boxes of a pixel, and surfaces are flat. Of a path at most `scatters` surfaces scatter.
Lamps emit to the side that sees their vertices counter-clockwise, and reflect nothing.
"""

import dataclasses
import math
import pathlib
import random
import re

import numpy as np

SCENES = pathlib.Path(__file__).resolve().parents[3] / "shared" / "scenes"


@dataclasses.dataclass(frozen=True)
class Diffuse:
    reflectance: tuple = (0.6, 0.6, 0.6)


@dataclasses.dataclass(frozen=True)
class Metal:
    """A conductor of GGX microfacets, alpha across. The same index at all wavelengths, so that spectra and RGB are one model."""
    eta: float = 0.2
    k: float = 3.9
    alpha: float = 0.2


@dataclasses.dataclass(frozen=True)
class Glass:
    """A smooth boundary around glass of this index."""
    eta: float = 1.5


@dataclasses.dataclass(frozen=True)
class Lamp:
    radiance: tuple


@dataclasses.dataclass
class Mesh:
    name: str
    points: np.ndarray      # (n, 3), world space
    triangles: np.ndarray   # (m, 3)
    material: object


@dataclasses.dataclass
class Scene:
    eye: tuple
    target: tuple
    up: tuple
    fov: float              # degrees
    meshes: list
    sky: tuple | None = None   # radiance from all directions
    scatters: int = 5


def mesh(name, points, triangles, material):
    return Mesh(name, np.asarray(points, np.float32).reshape(-1, 3), np.asarray(triangles, np.int32).reshape(-1, 3), material)


def quad(name, a, b, c, d, material):
    return mesh(name, [a, b, c, d], [(0, 1, 2), (0, 2, 3)], material)


BOX_TRIANGLES = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]


def box_points(x, z, bottom, height, width, degrees):
    """Corners of a box turned about the y axis, its normals outwards with BOX_TRIANGLES."""
    c, s, r = math.cos(math.radians(degrees)), math.sin(math.radians(degrees)), width / 2
    ring = [(x + c * u - s * v, z + s * u + c * v) for u, v in ((-r, r), (r, r), (r, -r), (-r, -r))]
    return [(p, y, q) for y in (bottom, bottom + height) for p, q in ring]


def cornell(tall=Diffuse((0.725, 0.71, 0.68)), short=Diffuse((0.725, 0.71, 0.68))):
    """A room of 2 x 2 x 2 without its front wall, a lamp under its ceiling, and two boxes."""
    white, red, green = Diffuse((0.725, 0.71, 0.68)), Diffuse((0.63, 0.065, 0.05)), Diffuse((0.14, 0.45, 0.091))
    return Scene(eye=(0, 1, 6.8), target=(0, 1, 0), up=(0, 1, 0), fov=19.5, meshes=[
        quad("floor", (-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1), white),
        quad("ceiling", (-1, 2, -1), (1, 2, -1), (1, 2, 1), (-1, 2, 1), white),
        quad("back", (-1, 0, -1), (1, 0, -1), (1, 2, -1), (-1, 2, -1), white),
        quad("right", (1, 0, -1), (1, 0, 1), (1, 2, 1), (1, 2, -1), green),
        quad("left", (-1, 0, 1), (-1, 0, -1), (-1, 2, -1), (-1, 2, 1), red),
        mesh("tall", box_points(-0.33, -0.29, 0.01, 1.2, 0.6, -18), BOX_TRIANGLES, tall),
        mesh("short", box_points(0.33, 0.37, 0.01, 0.6, 0.6, 17), BOX_TRIANGLES, short),
        quad("lamp", (-0.24, 1.98, -0.2), (0.24, 1.98, -0.2), (0.24, 1.98, 0.2), (-0.24, 1.98, 0.2), Lamp((17, 12, 4)))])


def lamps(count=10000):
    """A plain with 400 boxes under so many small lamps, equal but for where they are, which shine downwards."""
    numbers = random.Random(1)
    blocks = [box_points(numbers.uniform(-10, 10), numbers.uniform(-10, 10), 0, numbers.uniform(0.1, 1), numbers.uniform(0.2, 0.6), numbers.uniform(0, 90)) for _ in range(400)]
    corners, size = [], 0.015
    for _ in range(count):
        x, y, z = numbers.uniform(-10, 10), numbers.uniform(0.2, 1.5), numbers.uniform(-10, 10)
        corners += [(x - size, y, z - size), (x + size, y, z - size), (x + size, y, z + size), (x - size, y, z + size)]
    return Scene(eye=(0, 7, 13), target=(0, 0, 1), up=(0, 1, 0), fov=45, meshes=[
        quad("plain", (-10, 0, 10), (10, 0, 10), (10, 0, -10), (-10, 0, -10), Diffuse()),
        mesh("blocks", sum(blocks, []), [tuple(8 * i + v for v in t) for i in range(len(blocks)) for t in BOX_TRIANGLES], Diffuse()),
        mesh("lamps", corners, [(4 * i, 4 * i + j, 4 * i + j + 1) for i in range(count) for j in (1, 2)], Lamp((30, 30, 30)))])


# ---- all-grey versions of pbrt scenes

WORD = re.compile(r'#[^\n]*|"[^"]*"|[\[\]]|[^\s\[\]"#]+')


def directives(text):
    """The directives of a pbrt file, each with the strings and numbers that follow it."""
    name, values = None, []
    for word in WORD.findall(text):
        if word[0].isalpha() and word not in ("true", "false"):
            if name:
                yield name, values
            name, values = word, []
        elif word[0] not in "#[]":
            values.append(word)
    yield name, values


def parameters(values):
    """{"fov": [...]} of the words after a directive; under "" what stands before the first parameter."""
    found, name = {"": []}, ""
    for value in values:
        if value.startswith('"') and " " in value:
            name = value[1:-1].split()[1]
            found[name] = []
        else:
            found[name].append(value.strip('"'))
    return found


def disk(radius, height, segments=64):
    """A disk around the z axis, its normals along it."""
    rim = [(radius * math.cos(a), radius * math.sin(a), height) for a in np.arange(segments) * 2 * math.pi / segments]
    return [(0, 0, height), *rim], [(0, 1 + i, 1 + (i + 1) % segments) for i in range(segments)]


def shape_of(kind, p, folder, read_ply):
    """Points and triangles, or None for a shape that is left out."""
    if kind == "plymesh":
        return read_ply(str(folder / p["filename"][0]))
    if kind == "trianglemesh":
        return np.array(p["P"], float).reshape(-1, 3), np.array(p["indices"], int).reshape(-1, 3)
    if kind == "disk":
        return disk(float(p.get("radius", [1])[0]), float(p.get("height", [0])[0]))
    return None


def matrix(values):
    return np.array([float(v) for v in values]).reshape(4, 4).T


def clay(path, read_ply, own_lamps, without=()):
    """The meshes of a pbrt scene, all grey, seen by its own camera: under its own area lights made grey, or without those under a white sky. Leaves out the PLY
    files named in `without`: walls that keep out the sky. Knows the directives that Bitterli's scenes have."""
    state, stack, meshes, camera, fov = (np.eye(4), None), [], [], None, 90.0
    for name, values in directives(pathlib.Path(path).read_text()):
        transform, radiance = state
        p = parameters(values) if name in ("Camera", "AreaLightSource", "Shape") else {}
        if name == "Transform":
            state = (matrix(values), radiance)
        elif name == "ConcatTransform":
            state = (transform @ matrix(values), radiance)
        elif name == "Camera":
            camera, fov = np.linalg.inv(transform), float(p["fov"][0])
        elif name == "WorldBegin":
            state = (np.eye(4), None)
        elif name in ("AttributeBegin", "TransformBegin"):
            stack.append(state)
        elif name in ("AttributeEnd", "TransformEnd"):
            state = stack.pop()
        elif name == "AreaLightSource":
            state = (transform, float(np.mean([float(v) for v in p["L"]])) * float(p.get("scale", [1])[0]))
        elif name == "Shape" and (own_lamps or radiance is None):
            file = p.get("filename", [""])[0]
            found = shape_of(p[""][0], p, pathlib.Path(path).parent, read_ply)
            if found and pathlib.Path(file).stem not in without:
                meshes.append(grey(f"mesh{len(meshes)}", *found, transform, radiance))
    eye, forwards, up = camera[:3, 3], camera[:3, 2], camera[:3, 1]
    return Scene(eye=tuple(eye), target=tuple(eye + forwards), up=tuple(up), fov=fov, meshes=[m for m in meshes if len(m.triangles)], sky=None if own_lamps else (1, 1, 1))


def grey(name, points, triangles, transform, radiance):
    """Without triangles that have no area, and with the orientation that pbrt gives it."""
    points = (np.asarray(points, float) @ transform[:3, :3].T + transform[:3, 3]).astype(np.float32)
    triangles = np.asarray(triangles)
    if np.linalg.det(transform[:3, :3]) < 0:
        triangles = triangles[:, ::-1]
    a, b, c = (points[triangles[:, i]].astype(float) for i in range(3))
    triangles = triangles[(np.cross(b - a, c - a) != 0).any(axis=1)]
    return Mesh(name, points, triangles.astype(np.int32), Diffuse() if radiance is None else Lamp((radiance,) * 3))


def generators(read_ply):
    """What makes each scene, by its name. read_ply(path) returns points and triangles."""
    staircase, coffee, classroom = (SCENES / folder / "scene-v4.pbrt" for folder in ("staircase2", "coffee", "classroom"))
    return {
        "cornell": cornell,
        "cornell-glossy": lambda: cornell(tall=Metal()),
        "cornell-glass": lambda: cornell(short=Glass()),
        "lamps-10000": lamps,
        "coffee-sky": lambda: clay(coffee, read_ply, own_lamps=False),
        "staircase2-sky": lambda: clay(staircase, read_ply, own_lamps=False, without=["Mesh000"]),   # the outer walls
        "classroom-sky": lambda: clay(classroom, read_ply, own_lamps=False),   # through its windows
        "coffee-lamps": lambda: clay(coffee, read_ply, own_lamps=True),
        "staircase2-lamps": lambda: clay(staircase, read_ply, own_lamps=True),
    }
