#!/usr/bin/env python3
"""Does what the book's chapter on adding a kind says: adds its worked example, the Oren-Nayar BSDF, out of tree, and tries it.

Copies the sources to a temporary folder, puts the blocks of the chapter in place (docs/book/tool/examples.py), builds that program, and
renders. Expected are: with sigma 0 the image of a diffuse surface; from other surfaces another image; and on a white plane under a white
sky the radiance that the chapter derives, nowhere above 1. Takes some minutes; with --build, only what the example reaches is compiled.

--dry-run compiles nothing but the syntax of the example's host file: it checks that each place where lines are inserted exists once.
"""
import array
import math
import re
import statistics
import sys
from pathlib import Path

import add_kinds
from add_kinds import ROOT, build_program, check_host, compile_flags, copy_tree, pixels
from incremental_build import build_changed, can_build_from

sys.path.insert(0, str(ROOT / "docs" / "book" / "tool"))
from examples import examples_of  # noqa: E402

PAGE = ROOT / "docs" / "book" / "16-adding-a-kind.md"
# Files of the host are compiled with the flags of this one.
SIBLING = "host/kinds/material/diffuse.cpp"

PLANE = """
LookAt {x} 0 {z}  0 0 0  0 1 0
Camera "perspective" "float fov" 0.5
Film "rgb" "integer xresolution" 16 "integer yresolution" 16
Sampler "independent" "integer pixelsamples" 1024
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Material "orennayar" "rgb reflectance" [1 1 1] "float sigma" {sigma}
Shape "disk" "float radius" 100
"""


# ---- put the blocks in place ------------------------------------------------------------------------------------------------------------

def place(tree, example):
    """Writes or inserts one block; what is wrong, or nothing."""
    target, block = tree / example.path, "\n".join(example.lines) + "\n"
    if not example.after:
        if target.exists():
            return f"{example.path} is already there"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(block, encoding="utf-8")
        return ""
    lines = target.read_text(encoding="utf-8").splitlines(keepends=True) if target.exists() else []
    at = [i for i, line in enumerate(lines) if example.after in line]
    if len(at) != 1:
        return f"{len(at)} lines of {example.path} contain {example.after!r}, instead of one"
    lines.insert(at[0] + 1, block)
    target.write_text("".join(lines), encoding="utf-8")
    return ""


def place_all(tree, examples):
    return [f"{PAGE.relative_to(ROOT)}:{e.first_line - 1}: {problem}" for e in examples if (problem := place(tree, e))]


def dry_run(tree, examples, flags):
    return [message for e in examples if e.path.endswith(".cpp") and (message := check_host(tree, SIBLING, e.path, flags))]


# ---- try the program --------------------------------------------------------------------------------------------------------------------

def image_of(program, tree, name, text):
    """The channels of all pixels of a scene."""
    scene = tree.parent / f"{name}.pbrt"
    scene.write_text(text, encoding="utf-8")
    found, message = pixels(program, tree, scene)
    if not found:
        raise SystemExit(f"{name} does not render: {message}")
    data = scene.with_suffix(".pfm").read_bytes()
    header = re.match(rb"PF\s+\d+\s+\d+\s+(\S+)\s", data)
    channels = array.array("f", data[header.end():])
    if (float(header[1]) < 0) != (sys.byteorder == "little"):
        channels.byteswap()
    return channels


def as_diffuse(text):
    """A scene with diffuse surfaces in place of those of the example."""
    return re.sub(r' *"float sigma" \S+', "", text.replace('"orennayar"', '"diffuse"'))


def predicted_radiance(sigma, theta):
    """Of a white plane under a white sky, by the chapter's formulas. Degrees."""
    variance, angle = math.radians(sigma) ** 2, math.radians(theta)
    ratio = 0.45 * variance / (variance + 0.09) / (1 - 0.5 * variance / (variance + 0.33))
    s, c = math.sin(angle), math.cos(angle)
    return (1 + ratio * 2 * s / math.pi * ((angle - s * c) / 2 + (1 - s ** 3) / (3 * c))) / (1 + ratio / 2)


def check(what, holds, figures):
    print(f"{'as expected' if holds else 'WRONG'}: {what} ({figures})", flush=True)
    return not holds


def try_program(program, tree, scene):
    """How many expectations fail."""
    failed = 0
    smooth = add_kinds.BOX + 'Material "orennayar" "rgb reflectance" [0.7 0.3 0.1] "float sigma" 0\n' + add_kinds.FLOOR + add_kinds.BALL
    first, second = image_of(program, tree, "smooth", smooth), image_of(program, tree, "diffuse", as_diffuse(smooth))
    off = max(abs(a - b) / max(abs(b), 1e-6) for a, b in zip(first, second))
    failed += check("sigma 0 is a diffuse surface", off <= 1e-5, f"largest relative difference {off:.1e}")

    first, second = image_of(program, tree, "example", scene), image_of(program, tree, "example-diffuse", as_diffuse(scene))
    off = sum(abs(a - b) for a, b in zip(first, second)) / sum(second)
    failed += check("rough surfaces are not", off > 1e-2, f"mean difference {100 * off:.1f} % of the mean")

    for sigma in (0, 10, 20, 90):
        for theta in (0, 60, 85):
            x, z = 50 * math.sin(math.radians(theta)), 50 * math.cos(math.radians(theta))
            image = image_of(program, tree, f"plane-{sigma}-{theta}", PLANE.format(x=x, z=z, sigma=sigma))
            mean, error = statistics.fmean(image), statistics.pstdev(image) / math.sqrt(len(image) / 3)   # the channels are equal
            wanted = predicted_radiance(sigma, theta)
            failed += check(f"a white plane, sigma {sigma}, seen at {theta} degrees", abs(mean - wanted) <= 4 * error + 1e-3 and mean <= 1 + 1e-3,
                            f"radiance {mean:.4f} +- {error:.4f}, derived {wanted:.4f}")
    return failed


def main():
    parser = add_kinds.parser_for(__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, help="a build folder of this checkout, whose objects are used where the example changes nothing")
    options = parser.parse_args()
    with add_kinds.working_tree(options.folder) as tree:
        copy_tree(tree, [])
        examples = examples_of(PAGE)
        scenes = [e for e in examples if e.path.endswith(".pbrt")]
        problems = place_all(tree, [e for e in examples if e not in scenes])
        if len(scenes) != 1:
            problems.append(f"{PAGE.relative_to(ROOT)} has {len(scenes)} scenes, instead of one")
        if options.dry_run and not problems:
            problems = dry_run(tree, examples, compile_flags(options.flags))
        if problems or options.dry_run:
            print("\n".join(problems) or f"{len(examples)} blocks are in place; the host file compiles")
            return int(bool(problems))
        incremental = options.build and can_build_from(options.build)
        program = build_changed(tree, options.build.resolve(), SIBLING) if incremental else build_program(tree)
        return int(try_program(program, tree, "\n".join(scenes[0].lines) + "\n") > 0)


if __name__ == "__main__":
    sys.exit(main())
