#!/usr/bin/env python3
"""Renders mattes and decodes them with a program that is not ours: cryptomatte-api from PyPI (pip install cryptomatte-api).

It must find the names of the scene, each with some pixel that it covers, and coverages that sum to at most 1. Exits with 77 if it is not
installed. --keep FOLDER keeps the image and a PNG of each mask, to be looked at; --scene FILE takes another scene than the one written here.
"""
import argparse
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SCENE = """
LookAt 0 2 -6  0 .8 0  0 1 0
Camera "perspective" "float fov" 40
Film "rgb" "integer xresolution" 96 "integer yresolution" 64
Sampler "zsobol" "integer pixelsamples" 32
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
MakeNamedMaterial "glass über \\"alles\\"" "string type" "dielectric"
ObjectBegin "ball"
  Material "diffuse" Shape "sphere" "float radius" .5
ObjectEnd
AttributeBegin NamedMaterial "glass über \\"alles\\"" Translate 0 1 0 Shape "sphere" AttributeEnd
AttributeBegin Translate -1.8 .5 0 ObjectInstance "ball" AttributeEnd
AttributeBegin Translate 1.5 .5 .3 ActiveTransform EndTime Translate .6 0 0 ActiveTransform All ObjectInstance "ball" AttributeEnd
AttributeBegin Rotate -90 1 0 0 Shape "disk" "float radius" 4 AttributeEnd
"""
GLASS = 'glass über "alles"'
NAMES = {"CryptoObject": {"ball", "sphere@scene.pbrt:12", "disk@scene.pbrt:15"}, "CryptoMaterial": {"default", "diffuse@scene.pbrt:10", GLASS}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--scene", type=pathlib.Path)
    args = parser.parse_args()
    try:
        import cryptomatte_api
        import numpy
    except ImportError as missing:
        print(f"skipped: {missing}; pip install cryptomatte-api")
        return 77

    with tempfile.TemporaryDirectory() as temporary:
        folder = args.keep or pathlib.Path(temporary)
        folder.mkdir(exist_ok=True)
        scene = args.scene or folder / "scene.pbrt"
        if not args.scene:
            scene.write_text(SCENE, encoding="utf-8")
        image = folder / "image.exr"
        subprocess.run([args.program, "render", scene, "--aov", "cryptomatte", "-o", image, "--quiet"], check=True)
        layers = cryptomatte_api.Cryptomatte.load(str(image))
        names = sorted(layer.metadata().name() for layer in layers)
        if names != ["CryptoMaterial", "CryptoObject"]:
            sys.exit(f"the decoder found the layers {names}")
        for layer in layers:
            name = layer.metadata().name()
            masks = {key: numpy.asarray(mask) for key, mask in layer.masks().items()}
            print(name, {key: round(float(mask.mean()), 4) for key, mask in masks.items()}, "levels", layer.num_levels())
            total = sum(masks.values())
            if not args.scene and set(masks) != NAMES[name]:
                sys.exit(f"{name}: the decoder found {sorted(masks)}, not {sorted(NAMES[name])}")
            if not args.scene and min(mask.max() for mask in masks.values()) < .999:
                sys.exit(f"{name}: a name covers no pixel")
            if total.max() > 1 + 1e-5 or total.max() < .999:
                sys.exit(f"{name}: the masks of a pixel sum to {total.max()}")
            for key, mask in masks.items() if args.keep else []:
                picture = folder / f"{name}-{''.join(c if c.isalnum() else '_' for c in key)}.png"
                picture.write_bytes(grey_png((numpy.clip(mask, 0, 1) * 255 + .5).astype(numpy.uint8)))
    return 0


def grey_png(pixels):
    """An image of bytes as a PNG."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    height, width = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


if __name__ == "__main__":
    sys.exit(main())
