"""LuxCore and Cycles for hard_light.py: a Cornell box with a ball of glass and a small lamp, as each of them reads it (peer_formats.py), and what renders it.

All is grey, so that RGB and wavelengths give the same image. The ball has flat triangles, the same in every program. After MOST_SCATTERS surfaces too little light
is left to tell how each program counts the length of a path: 0.1 %.
"""

import json
import pathlib
import re

import numpy as np

import peer_formats
import peer_scenes
from hard_light_renderers import run

HERE = pathlib.Path(__file__).resolve().parent
MOST_SCATTERS = 12
WALLS = peer_scenes.Diffuse((0.5, 0.5, 0.5))
LUXCORE = {
    "bidir": {"renderengine.type": "BIDIRCPU", "path.maxdepth": MOST_SCATTERS + 1, "light.maxdepth": MOST_SCATTERS + 1,
              "path.russianroulette.depth": peer_formats.ROULETTE_NEVER},   # with it images are 6 % too bright
    "path": {},
    "light tracing": {"path.hybridbackforward.enable": 1, "path.hybridbackforward.partition": 0.8, "path.hybridbackforward.glossinessthreshold": 0.05},
    "photon cache": {"path.photongi.caustic.enabled": 1, "path.photongi.photon.maxcount": 100000, "path.photongi.caustic.lookup.radius": 0.02},
}
CYCLES = {"path": False, "guided": True}


def ball(centre, radius, steps):
    """Points and triangles of a ball: the faces of an octahedron, each split into steps^2 triangles."""
    points, triangles, number = [], [], {}

    def corner(p):
        if p not in number:
            number[p] = len(points)
            points.append(np.array(centre) + radius * np.array(p) / np.linalg.norm(p))
        return number[p]

    for x, y, z in ((x, y, z) for x in (1, -1) for y in (1, -1) for z in (1, -1)):
        def at(i, j):
            return corner((x * i, y * j, z * (steps - i - j)))
        for i in range(steps):
            for j in range(steps - i):
                faces = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                if i + j + 1 < steps:
                    faces.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
                triangles += [face if x * y * z > 0 else face[::-1] for face in faces]
    return points, triangles


def write(folder, size):
    """The scene for images of size x size pixels, in the formats of all. Returns the file that pbrt-v4 and Eikonal read."""
    box = peer_scenes.cornell(tall=WALLS)
    meshes = [peer_scenes.mesh(m.name, m.points, m.triangles, WALLS) for m in box.meshes if m.name not in ("short", "lamp")]
    tip, side, up = np.array((0.35, 1.9, 1.25)), np.array((0.02, 0, 0)), np.array((0, 0.014, -0.014))   # tilted; the camera sees its back
    meshes.append(peer_scenes.mesh("ball", *ball((0.35, 0.36, 0.35), 0.34, 96), peer_scenes.Glass()))
    meshes.append(peer_scenes.quad("lamp", *(tip + x * side + y * up for x, y in ((-1, -1), (-1, 1), (1, 1), (1, -1))), peer_scenes.Lamp((3000, 3000, 3000))))
    scene = peer_scenes.Scene(box.eye, box.target, box.up, box.fov, meshes, scatters=MOST_SCATTERS)
    peer_formats.write(scene, folder, size)
    return folder / "scene.pbrt"


class LuxCore:
    """One of LUXCORE. Its caches are made in the time that counts."""
    suffix = "exr"

    def __init__(self, venv, threads, name, folder):
        libraries = sorted((venv / "lib").glob("python3*/site-packages/pyluxcore.libs/libtbbmalloc_proxy-*"))
        self.command = ["env", *(f"LD_PRELOAD={file}" for file in libraries[:1]), venv / "bin" / "python", HERE / "peer_luxcore.py", folder / "scene.cfg", threads]
        self.properties = [f"{key}={value}" for key, value in LUXCORE[name].items()]

    def render(self, _, samples, seed, image):
        told = run(*self.command, samples, seed, image, *self.properties)
        return float(re.findall(r"^@@ ([\d.]+)", told, re.MULTILINE)[-1])


class Cycles:
    """With path guiding or without."""
    suffix = "exr"

    def __init__(self, venv, threads, name, folder):
        self.python, self.threads = venv / "bin" / "python", threads
        self.scene = folder / f"cycles-{name}.json"
        self.scene.write_text(json.dumps(json.loads((folder / "scene.json").read_text()) | {"guiding": CYCLES[name]}))

    def render(self, _, samples, seed, image):
        told = run(self.python, HERE / "peer_cycles.py", self.scene, samples, seed, image, self.threads)
        shown = [(60 * int(minutes) + float(seconds), rest) for minutes, seconds, rest in re.findall(r"Time: ?(\d+):(\d+\.\d+)([^\n]*)", told)]
        begin = next(i for i, (_, rest) in enumerate(shown) if "| Sample " in rest)
        return max(time for time, rest in shown[begin:] if "| Sample " in rest or "Finished" in rest) - shown[max(begin - 1, 0)][0]


def renderers(venv, threads, folder):
    """By name, those that the virtual environment has. write(folder, ...) has been called."""
    packages = {file.name for file in (venv / "lib").glob("python3*/site-packages/*")}
    found = {}
    if "pyluxcore" in packages:
        found |= {f"LuxCore {name}": LuxCore(venv, threads, name, folder) for name in LUXCORE}
    if "bpy" in packages:
        found |= {f"Cycles {name}": Cycles(venv, threads, name, folder) for name in CYCLES}
    return found
