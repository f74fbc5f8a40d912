#!/usr/bin/env python3
"""Adds a kind of each family out of tree, as docs/book/16-adding-a-kind.md says, and compares its image with that of the kind that it copies.

Copies the sources to a temporary folder. For each family it copies a kind's files under a new name and adds a line to the family's list;
nothing else. Then it builds that program, once for all kinds, renders a scene with the original and with the copy, and expects the same
bits. What differs, or does not render, asks for a kind by its name somewhere outside of the kind's files. Takes some minutes.

--dry-run makes the copied tree and compiles nothing: it checks that each file and line was changed as intended, and that the compiler
accepts what was copied of the host. Takes half a minute, and needs a configured build folder for the flags.
"""
import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from contextlib import contextmanager
from dataclasses import dataclass, field
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
BALL = 'Shape "sphere" "float radius" 0.7\n'


@dataclass
class Copy:
    new: str                                     # the name of the copy
    scene: str                                   # @ stands for the kind's name in a scene file
    files: list = field(default_factory=list)    # files of the kind, which are copied
    lists: list = field(default_factory=list)    # files with a list that gets a line
    arrays: dict = field(default_factory=dict)   # file: suffix of variables. The kind is `kind_suffix` there and `&kind_suffix` in an array
    keeps: str = r"(?!)"                         # words with the kind's name in them that mean something else


KINDS = {
    "goniometric": Copy(
        new="echo", files=["kernels/light/goniometric.clh", "host/kinds/light/goniometric.cpp"], lists=["include/eikonal/lights.h"],
        scene=BOX + 'Translate 0 2 0\nLightSource "@" "rgb I" [8 6 4] "string filename" "directions.png"\nTranslate 0 -2 0\n' + FLOOR),
    "cylinder": Copy(
        new="tube", files=["kernels/shape/cylinder.clh", "kernels/light/cylinder.clh", "host/kinds/shape/cylinder.cpp"],
        lists=["include/eikonal/shapes.h", "include/eikonal/lights.h"],
        scene=BOX + FLOOR + 'Rotate -90 1 0 0\nShape "@" "float radius" 0.5 "float phimax" 250 "float zmin" 0 "float zmax" 1\n'
        'AreaLightSource "diffuse" "rgb L" [3 2 1]\nTranslate 1.2 0 0\nShape "@" "float radius" 0.2 "float zmin" 0 "float zmax" 1\n'),
    # Shadow rays of a curve begin beside it, so there is a light whose direction depends on where they begin
    "curve": Copy(
        new="strand", files=["kernels/shape/curve.clh", "host/kinds/shape/curve.cpp"], lists=["include/eikonal/shapes.h"],
        keeps=r"curves?|curve_segments|curve_(flat|cylinder|ribbon)|readCurve|curveSplits",
        scene=BOX + FLOOR + 'LightSource "point" "point3 from" [0.4 1.6 -1] "rgb I" [3 3 3]\n'
        'Shape "@" "string type" "cylinder" "point3 P" [-1 0 0  -0.5 2 0  0.5 0 0  1 1.5 0] "float width0" 0.5 "float width1" 0.1\n'
        'Shape "@" "string type" "flat" "point3 P" [-1 1 0.5  -0.5 0 0.5  0.5 2 0  1 0 0] "float width" 0.2\n'),
    "spherical": Copy(
        new="dome", files=["kernels/camera/spherical.clh", "host/kinds/camera/spherical.cpp"], lists=["include/eikonal/cameras.h"],
        scene=BOX.replace('Camera "perspective" "float fov" 45', 'Camera "@" "string mapping" "equirectangular"') + FLOOR),
    "cloud": Copy(
        new="haze", files=["kernels/medium/cloud.clh", "host/kinds/medium/cloud.cpp"], lists=["include/eikonal/media.h"],
        scene=BOX + FLOOR + 'MakeNamedMedium "m" "string type" "@" "point3 p0" [-1 0 -1] "point3 p1" [1 2 1] "float density" 2\n'
        'MediumInterface "m" ""\nMaterial "interface"\nTranslate 0 1 0\nShape "sphere" "float radius" 0.9\n'),
    "wrinkled": Copy(
        new="crumpled", files=["kernels/texture/wrinkled.clh", "host/kinds/texture/wrinkled.cpp"], lists=["include/eikonal/textures.h"],
        scene=BOX + 'Texture "t" "float" "@" "integer octaves" 5\n'
        'Texture "c" "spectrum" "mix" "rgb tex1" [0.9 0.2 0.1] "texture amount" "t"\n'
        'Material "diffuse" "texture reflectance" "c"\n' + FLOOR),
    "diffuse": Copy(
        new="chalk", files=["kernels/bsdf/diffuse.clh", "host/kinds/material/diffuse.cpp"],
        lists=["include/eikonal/bsdfs.h", "include/eikonal/materials.h"],
        scene=BOX + 'Material "@" "rgb reflectance" [0.7 0.3 0.1]\n' + FLOOR + BALL),
    "coated_conductor": Copy(
        new="lacquered_metal", files=["kernels/bsdf/coated_conductor.clh", "host/kinds/material/coated_conductor.cpp"],
        lists=["include/eikonal/bsdfs.h", "include/eikonal/materials.h"],
        scene=BOX + 'LightSource "infinite" "rgb L" [0.3 0.4 0.5]\n' + FLOOR +
        'Material "@" "float interface.roughness" 0.2 "float conductor.roughness" 0.3 "float thickness" 0.2 "rgb albedo" [0.5 0.7 0.9]\n' +
        BALL + 'Translate 1.5 0 0\nMaterial "@"\n' + BALL),
    "gaussian": Copy(
        new="bell", arrays={"host/kinds/filter_kind.cpp": "filter"},
        scene='PixelFilter "@" "float xradius" 2 "float sigma" 0.7\n' + BOX + FLOOR + BALL),
    "simplepath": Copy(
        new="plainpath", arrays={"host/kinds/integrator_kind.cpp": "integrator"},
        scene='Integrator "@" "integer maxdepth" 3 "bool samplebsdf" false\n' + BOX + FLOOR + BALL),
}


def write_png(path, side):
    """A square of colours that differ everywhere."""
    rows = b"".join(b"\0" + bytes(v for x in range(side) for v in (40 + 200 * x // side, 40 + 200 * y // side, (x * y * 37) % 256))
                    for y in range(side))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def in_scenes(kind):
    """Names in scene files have no underscores."""
    return kind.replace("_", "")


def renamed(text, kind, new, keeps=r"(?!)"):
    """The text with the kind's name replaced in every word but those that it keeps; in quotes, the whole name is always replaced."""
    def word(match):
        if re.fullmatch(keeps, match[0]):
            return match[0]
        return match[0].replace(kind, new).replace(kind.upper(), new.upper()).replace(in_scenes(kind), in_scenes(new))
    text = text.replace(f'"{in_scenes(kind)}"', f'"{in_scenes(new)}"')
    return re.sub(r"\w+", word, text)


def private_names(tree, file):
    """Functions and macros of a kernel file that no other kernel file mentions: a copy of the file needs names of its own for them."""
    text = (tree / file).read_text(encoding="utf-8")
    defined = set(re.findall(r"^\s*(?:SHARED_)?FN [\w ]*?\b(\w+)\(|^#define (\w+)", text, re.MULTILINE))
    others = " ".join(f.read_text(encoding="utf-8") for f in (tree / "kernels").rglob("*.cl*") if f != tree / file)
    return {name for pair in defined for name in pair if name} - set(re.findall(r"\w+", others))


def copied(file, kind):
    """The path, from the root, of the copy of a kind's file."""
    return str(Path(file).with_name(Path(file).name.replace(kind, KINDS[kind].new)))


def copy_file(tree, file, kind, copy):
    source, target = tree / file, tree / copied(file, kind)
    text = renamed(source.read_text(encoding="utf-8"), kind, copy.new, copy.keeps)
    if source.suffix == ".clh":
        for name in private_names(tree, file):
            if kind not in name and kind.upper() not in name:
                text = re.sub(rf"\b{name}\b", f"{copy.new.upper() if name.isupper() else copy.new}_{name}", text)
    target.write_text(text, encoding="utf-8")
    return target


def add_line(path, kind, new):
    """Adds a line to the list in which the kind has one."""
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


def add_entry(path, kind, new, suffix):
    """Families that are an array in one file: copies the variable of the kind and its entry."""
    text = path.read_text(encoding="utf-8")
    variable = f"{kind}_{suffix}"
    definition = re.search(rf"^const \w+ {variable}\{{.*?\}};\n", text, re.MULTILINE | re.DOTALL)[0]
    text = text.replace(definition, definition + definition.replace(variable, f"{new}_{suffix}").replace(f'"{kind}"', f'"{new}"'))
    text = re.sub(rf"&{variable}\b", f"&{variable}, &{new}_{suffix}", text)
    path.write_text(text, encoding="utf-8")


def add_kind(tree, kind):
    copy = KINDS[kind]
    for file in copy.files:
        copy_file(tree, file, kind, copy)
    for file in copy.lists:
        add_line(tree / file, kind, copy.new)
    for file, suffix in copy.arrays.items():
        add_entry(tree / file, kind, copy.new, suffix)
    print(f"{kind} as {copy.new}: {len(copy.files)} files, {len(copy.lists) + len(copy.arrays)} lines", flush=True)


def copy_tree(tree, kinds):
    for name in ("host", "kernels", "include", "cmake"):
        shutil.copytree(ROOT / name, tree / name, dirs_exist_ok=True)
    shutil.copy2(ROOT / "CMakeLists.txt", tree)
    for kind in kinds:
        add_kind(tree, kind)


# ---- the dry run ------------------------------------------------------------------------------------------------------------------------

def check_text(tree, kind):
    """What is wrong with the copied files and the changed lists."""
    copy = KINDS[kind]
    for file in copy.files:
        target = copied(file, kind)
        if not (tree / target).exists():
            yield f"there is no {target}"
            continue
        text = (tree / target).read_text(encoding="utf-8")
        if copy.new not in text:
            yield f"{target} does not name {copy.new}"
        left = {w for w in re.findall(r"\w+", re.sub(r"/\*.*?\*/|//[^\n]*|#include[^\n]*", "", text, flags=re.DOTALL))
                if (kind in w or kind.upper() in w) and not re.fullmatch(copy.keeps, w)}
        if left:
            yield f"{target} still names {', '.join(sorted(left))}"
    for file in [*copy.lists, *copy.arrays]:
        before, after = ((root / file).read_text(encoding="utf-8") for root in (ROOT, tree))
        if copy.arrays:
            ways = [rf"^const \w+ %s_{copy.arrays[file]}\{{", rf"&%s_{copy.arrays[file]}\b"]
        else:
            ways = [r"^    \w\(%s[,)].*\\$"] + [r"^#define %s_PARAMETERS\("] * (f"{kind.upper()}_PARAMETERS" in before)
        for way in ways:
            if len(re.findall(way % (copy.new.upper() if "PARAMETERS" in way else copy.new), after, re.MULTILINE)) != 1:
                yield f"{file}: not one place is {way % copy.new!r}"
        removed = set(before.splitlines()) - set(after.splitlines())
        if len(removed) > len(copy.arrays):
            yield f"{file} lost lines: {sorted(removed)}"


def compile_flags(file):
    """The command that compiles a file of the host, by the file's path from the root."""
    commands = json.loads(file.read_text(encoding="utf-8"))
    return {str(Path(c["file"]).relative_to(ROOT)): c for c in commands if Path(c["file"]).is_relative_to(ROOT)}


def words_in(tree, command):
    """The words of a command of compile_flags, for a copy of the sources."""
    words = shlex.split(command["command"])
    return [w.replace(f"{ROOT}/host", f"{tree}/host").replace(f"{ROOT}/include", f"{tree}/include") for w in words]


def check_host(tree, file, copy, flags):
    """What the compiler says about a copied file of the host, with the flags of the original."""
    words = words_in(tree, flags[file])
    compiler = next(i for i, w in enumerate(words) if re.search(r"(c\+\+|g\+\+|clang\+\+)[\d.-]*$", w))   # after a compiler cache
    words = words[compiler:]
    words = [w for i, w in enumerate(words) if w not in ("-c", "-o") and words[i - 1] not in ("-c", "-o")]
    run = subprocess.run([*words, "-fsyntax-only", tree / copy], cwd=flags[file]["directory"], capture_output=True, text=True)
    return run.stderr if run.returncode else ""


def dry_run(tree, kinds, flags):
    wrong = 0
    for kind in kinds:
        copy = KINDS[kind]
        problems = list(check_text(tree, kind))
        for file in [*copy.files, *copy.arrays]:
            if file.endswith(".cpp"):
                problems.append(check_host(tree, file, copied(file, kind), flags))
        problems = list(filter(None, problems))
        wrong += bool(problems)
        print("\n".join([f"{kind}: {'WRONG' if problems else 'changed as intended, compiles'}", *problems]), flush=True)
    return int(wrong > 0)


# ---- the test ---------------------------------------------------------------------------------------------------------------------------

def build_program(tree):
    """The copied program. Its build folder is where a checkout has it: the compiler cache, which CMakeLists.txt turns on, then finds what
    an earlier run or the checkout has compiled, since all paths are relative to the sources."""
    build = tree / "build"
    environment = dict(os.environ, CCACHE_BASEDIR=str(tree), CCACHE_NOHASHDIR="1")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DEIKONAL_TESTS=OFF", "-DEIKONAL_BENCH=OFF"]
    subprocess.run(["cmake", "-S", tree, "-B", build, *generator, *options], check=True, stdout=subprocess.DEVNULL, env=environment)
    start, tenths, log = time.monotonic(), 0, []
    command = ["cmake", "--build", build, "--target", "eikonal", "-j", str(os.cpu_count())]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment) as run:
        for line in run.stdout:
            log.append(line)
            step = re.match(r"\[\s*(\d+)(?:/(\d+)|%)", line)
            done = int(10 * int(step[1]) / int(step[2] or 100)) if step else 0
            if done > tenths:
                tenths = done
                print(f"built {10 * done} % in {time.monotonic() - start:.0f} s", flush=True)
    if run.returncode:
        print("".join(log[-60:]), flush=True)
        raise SystemExit("the program with the copied kinds does not compile")
    return build / "eikonal"


def pixels(program, tree, scene):
    """A hash of the image's pixels; the metadata of the file hold its command line."""
    image = scene.with_suffix(".pfm")
    run = subprocess.run([program, "render", scene, "-o", image, "--log-level", "error"], capture_output=True, text=True,
                         env=dict(os.environ, EIKONAL_KERNELS=str(tree)))
    if run.returncode:
        return None, run.stderr.strip()
    return hashlib.sha256(image.read_bytes()).hexdigest(), ""


def compare(program, tree, folder, kind):
    """Renders the kind and its copy. What is wrong, or nothing."""
    hashes = []
    for name in (kind, KINDS[kind].new):
        scene = folder / f"{name}.pbrt"
        scene.write_text(KINDS[kind].scene.replace("@", in_scenes(name)), encoding="utf-8")
        found, message = pixels(program, tree, scene)
        if not found:
            return f"{name} DOES NOT RENDER: {message}"
        hashes.append(found)
    return "" if hashes[0] == hashes[1] else "DIFFERS"


def parser_for(description):
    """The options of a script that changes a copy of the sources."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--folder", type=Path, help="work in this folder and keep it (default: a temporary one)")
    parser.add_argument("--dry-run", action="store_true", help="only check the changed text, and that it compiles")
    parser.add_argument("--flags", type=Path, default=ROOT / "build/compile_commands.json", help="for --dry-run: how CMake compiles the host")
    return parser


@contextmanager
def working_tree(folder):
    """A path for the copy of the sources, without those of an earlier run. folder: where it is, and stays; None: a temporary folder."""
    place = (folder or Path(tempfile.mkdtemp(prefix="eikonal-tree-"))).resolve()
    try:
        for name in ("host", "kernels", "include"):
            shutil.rmtree(place / "tree" / name, ignore_errors=True)
        yield place / "tree"
    finally:
        if not folder:
            shutil.rmtree(place, ignore_errors=True)


def main():
    parser = parser_for(__doc__.splitlines()[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    options = parser.parse_args()
    with working_tree(options.folder) as tree:
        copy_tree(tree, options.kinds)
        if options.dry_run:
            return dry_run(tree, options.kinds, compile_flags(options.flags))
        program = build_program(tree)
        write_png(tree.parent / "directions.png", 8)
        failed = 0
        for kind in options.kinds:
            problem = compare(program, tree, tree.parent, kind)
            failed += bool(problem)
            print(f"{kind}: {problem or 'same bits'}", flush=True)
        return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
