#!/usr/bin/env python3
"""What a frame costs beside its rendering: frames in one call, and in a call for each.

    tests/bench/frames.py

Makes a scene of 2 M triangles in a binary PLY and eight images of 2048 x 2048 pixels, with a file for each frame, in which only the camera
moves; renders few samples of a small image; and prints seconds of a frame that are not rendering: of single calls, of the first frame of
a call and of the later ones, with the share of reading and packing. Medians. Nothing else should run on the machine.
"""

import argparse
import array
import json
import pathlib
import random
import statistics
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIDE = 1000  # squares of the terrain
TEXTURES, PIXELS = 8, 2048


def write_ply(path):
    """A terrain of 2 x SIDE x SIDE triangles."""
    points, n = array.array("f"), SIDE + 1
    for y in range(n):
        for x in range(n):
            points.extend((x / SIDE, 0.02 * ((x * 7 + y * 13) % 11) / 11, y / SIDE))
    faces = bytearray()
    for y in range(SIDE):
        for x in range(SIDE):
            a = y * n + x
            faces += struct.pack("<B3iB3i", 3, a, a + 1, a + n, 3, a + 1, a + n + 1, a + n)
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {n * n}\nproperty float x\nproperty float y\nproperty float z\nelement face {2 * SIDE * SIDE}\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_bytes(head.encode() + points.tobytes() + bytes(faces))


def write_png(path, seed):
    numbers = random.Random(seed)
    row = lambda: b"\0" + numbers.randbytes(3 * PIXELS)
    rows = [row() for _ in range(16)]
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    data = zlib.compress(b"".join(rows[y // 8 % 16] for y in range(PIXELS)), 1)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", PIXELS, PIXELS, 8, 2, 0, 0, 0)) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def write_scene(folder, frame):
    text = f"""LookAt {0.5 + 0.01 * frame} 0.6 -0.8  0.5 0 0.5  0 1 0
Camera "perspective" "float fov" 45
Sampler "zsobol" "integer pixelsamples" 4
Film "rgb" "integer xresolution" 160 "integer yresolution" 90
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Material "diffuse" "rgb reflectance" [0.5 0.5 0.5]
Shape "plymesh" "string filename" "terrain.ply"
"""
    for i in range(TEXTURES):
        text += f"""Texture "t{i}" "spectrum" "imagemap" "string filename" "t{i}.png"
AttributeBegin Translate {i / TEXTURES} 0.1 0.5 Material "diffuse" "texture reflectance" "t{i}" Shape "sphere" "float radius" 0.05 AttributeEnd
"""
    (folder / f"s.{frame:04}.pbrt").write_text(text)


def render(program, folder, *words):
    """(seconds of the call, the lines of --json)"""
    begin = time.monotonic()
    done = subprocess.run([program, "render", *words, "--json", "--quiet"], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"frames: {words} failed:\n{done.stderr}")
    return time.monotonic() - begin, [json.loads(line) for line in done.stdout.splitlines()]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--frames", type=int, default=5)
    Report.add_to(options)
    o = options.parse_args()
    program = o.program.resolve()
    add = Report(o.json).table("frames", {"frame": None, "beside rendering, s": ".2f", "read, s": ".2f", "pack, s": ".2f", "build, s": ".2f"})
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_ply(folder / "terrain.ply")
        for i in range(TEXTURES):
            write_png(folder / f"t{i}.png", i)
        for frame in range(o.frames):
            write_scene(folder, frame)
        render(program, folder, "s.0000.pbrt", "-o", "warm.exr")  # compiles the kernels

        def row(title, lines, seconds):
            beside = [all_ - line["seconds"]["render"] for all_, line in zip(seconds, lines)]
            add(title, statistics.median(beside), *(statistics.median(line["seconds"][step] for line in lines) for step in ("read", "pack", "build")))

        single = [render(program, folder, f"s.{frame:04}.pbrt", "-o", "a.exr") for frame in range(o.frames)]
        row("in a call of its own", [lines[0] for _, lines in single], [seconds for seconds, _ in single])
        _, lines = render(program, folder, "s.####.pbrt", "--frames", f"0-{o.frames - 1}", "-o", "b.####.exr")
        row("the first of a call", lines[:1], [lines[0]["seconds"]["all"]])
        row("a later one", lines[1:], [line["seconds"]["all"] for line in lines[1:]])


if __name__ == "__main__":
    main()
