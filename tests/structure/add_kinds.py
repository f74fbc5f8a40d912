#!/usr/bin/env python3
"""Adds a kind of each family out of tree, as docs/recipes.md says, and compares its image with that of the kind that it copies.

Copies the sources to a temporary folder. For each family it copies a kind's files under a new name and adds a line to the family's list;
nothing else. It builds that program, renders a scene with the original and with the copy, and expects the same bits. Takes some minutes.
"""
import argparse
import hashlib
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

BOX = """
LookAt 0 1 -4  0 0.6 0  0 1 0
Camera "perspective" "float fov" 45
Film "rgb" "integer xresolution" 48 "integer yresolution" 48
Sampler "independent" "integer pixelsamples" 4
WorldBegin
LightSource "distant" "point3 from" [2 4 -3] "rgb L" [2 2 2]
"""
FLOOR = 'Shape "trianglemesh" "point3 P" [-4 0 -4  4 0 -4  4 0 4  -4 0 4] "integer indices" [0 1 2 0 2 3]\n'

# kind: (its new name, its files, its lines in the lists, a scene in which @ stands for its name)
KINDS = {
    "goniometric": ("echo", ["kernels/light/goniometric.clh", "host/kinds/light/goniometric.cpp"], ["include/eikonal/lights.h"],
                    BOX + 'Translate 0 2 0\nLightSource "@" "rgb I" [8 6 4] "string filename" "directions.png"\nTranslate 0 -2 0\n' + FLOOR),
    "cylinder": ("tube", ["kernels/shape/cylinder.clh", "kernels/light/cylinder.clh", "host/kinds/shape/cylinder.cpp"],
                 ["include/eikonal/shapes.h", "include/eikonal/lights.h"],
                 BOX + FLOOR + 'Rotate -90 1 0 0\nShape "@" "float radius" 0.5 "float phimax" 250 "float zmin" 0 "float zmax" 1\n'
                 'AreaLightSource "diffuse" "rgb L" [3 2 1]\nTranslate 1.2 0 0\nShape "@" "float radius" 0.2 "float zmin" 0 "float zmax" 1\n'),
    "spherical": ("dome", ["kernels/camera/spherical.clh", "host/kinds/camera/spherical.cpp"], ["include/eikonal/cameras.h"],
                  BOX.replace('Camera "perspective" "float fov" 45', 'Camera "@" "string mapping" "equirectangular"') + FLOOR),
    "cloud": ("haze", ["kernels/medium/cloud.clh", "host/kinds/medium/cloud.cpp"], ["include/eikonal/media.h"],
              BOX + FLOOR + 'MakeNamedMedium "m" "string type" "@" "point3 p0" [-1 0 -1] "point3 p1" [1 2 1] "float density" 2\n'
              'MediumInterface "m" ""\nMaterial "interface"\nTranslate 0 1 0\nShape "sphere" "float radius" 0.9\n'),
    "wrinkled": ("crumpled", ["kernels/texture/wrinkled.clh", "host/kinds/texture/wrinkled.cpp"], ["include/eikonal/textures.h"],
                 BOX + 'Texture "t" "float" "@" "integer octaves" 5\nTexture "c" "spectrum" "mix" "rgb tex1" [0.9 0.2 0.1] "texture amount" "t"\n'
                 'Material "diffuse" "texture reflectance" "c"\n' + FLOOR),
    "diffuse": ("chalk", ["kernels/bsdf/diffuse.clh", "host/kinds/material/diffuse.cpp"],
                ["include/eikonal/bsdfs.h", "include/eikonal/materials.h"],
                BOX + 'Material "@" "rgb reflectance" [0.7 0.3 0.1]\n' + FLOOR + 'Shape "sphere" "float radius" 0.7\n'),
}


def write_png(path, side):
    """A square of colours that differ everywhere."""
    rows = b"".join(b"\0" + bytes(v for x in range(side) for v in (40 + 200 * x // side, 40 + 200 * y // side, (x * y * 37) % 256)) for y in range(side))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def renamed(text, kind, new):
    return text.replace(kind, new).replace(kind.upper(), new.upper())


def add_kind(tree, kind, new, files, lists):
    for file in files:
        source = tree / file
        target = source.with_name(source.name.replace(kind, new))
        target.write_text(renamed(source.read_text(encoding="utf-8"), kind, new), encoding="utf-8")
    for file in lists:
        path = tree / file
        text = path.read_text(encoding="utf-8")
        line = re.search(rf"^    \w\({kind}[,)].*\n", text, re.MULTILINE)[0]
        # The last line of a list has no backslash: the new line goes before the one that it copies
        new_line = renamed(line, kind, new).split("/*")[0].rstrip().removesuffix("\\").rstrip() + " \\\n"
        text = text.replace(line, new_line + line)
        # The parameters of a BSDF are a list of their own
        parameters = re.search(rf"^#define {kind.upper()}_PARAMETERS(.*\\\n)*.*\n", text, re.MULTILINE)
        if parameters:
            text = text.replace(parameters[0], parameters[0] + "\n" + renamed(parameters[0], kind, new))
        path.write_text(text, encoding="utf-8")


def pixels(program, kernels, scene):
    """A hash of the image's pixels; the metadata of the file hold its command line."""
    image = scene.with_suffix(".pfm")
    environment = dict(os.environ, EIKONAL_KERNELS=str(kernels))
    subprocess.run([program, "render", scene, "-o", image, "--log-level", "error"], check=True, env=environment)
    return hashlib.sha256(image.read_bytes()).hexdigest()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=Path, help="work in this folder and keep it (default: a temporary one)")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    options = parser.parse_args()
    folder = options.folder or Path(tempfile.mkdtemp(prefix="eikonal-kinds-"))
    tree = folder / "tree"
    try:
        for name in ("host", "kernels", "include", "cmake", "scenes", "docs"):
            if (ROOT / name).exists():
                shutil.copytree(ROOT / name, tree / name, dirs_exist_ok=True)
        for file in ROOT.glob("*"):
            if file.is_file():
                shutil.copy2(file, tree)
        for kind in options.kinds:
            new, files, lists, _ = KINDS[kind]
            add_kind(tree, kind, new, files, lists)
            print(f"{kind} as {new}: {len(files)} files, {len(lists)} lines", flush=True)
        build = folder / "build"
        subprocess.run(["cmake", "-S", tree, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DEIKONAL_TESTS=OFF", "-DEIKONAL_BENCH=OFF"],
                       check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", build, "--target", "eikonal", "-j", str(os.cpu_count())], check=True, stdout=subprocess.DEVNULL)
        write_png(folder / "directions.png", 8)
        differ = 0
        for kind in options.kinds:
            hashes = []
            for name in (kind, KINDS[kind][0]):
                scene = folder / f"{name}.pbrt"
                scene.write_text(KINDS[kind][3].replace("@", name), encoding="utf-8")
                hashes.append(pixels(build / "eikonal", tree, scene))
            same = hashes[0] == hashes[1]
            differ += not same
            print(f"{kind}: {'same bits' if same else 'DIFFERS'}", flush=True)
        return int(differ > 0)
    finally:
        if not options.folder:
            shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    sys.exit(main())
