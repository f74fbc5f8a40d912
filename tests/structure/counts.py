#!/usr/bin/env python3
"""Counts what makes the source hard to read, and fails if a count grows.

Each measure has a goal and a limit: the limit is what the source has today, or the goal where that is reached. Lower a limit when you lower
its count. Prints a Markdown table; with --places MEASURE also the places that it counts. Exits with status 1 if a count is over its limit.
"""
import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FAMILIES = ("light", "shape", "camera", "medium", "texture", "bsdf")
LISTS = {"light": "lights.h", "shape": "shapes.h", "camera": "cameras.h", "medium": "media.h", "texture": "textures.h", "bsdf": "bsdfs.h", "material": "materials.h"}
README_FILES = re.compile(r"\((kernels/[\w/.]+\.clh?|host/[\w/.]+\.(?:cpp|h)|include/[\w/.]+\.h)\)")
# Terms that were replaced, and words that a graphics engineer would have to look up (the field's words stand in docs/glossary.md).
WORDS_OUT = re.compile(r"\b(nobody\w*|somebody\w*|passages?|relieve[sd]?|palettes?|foci|emergence|way_out|one_wave|part_wavelengths|"
                       r"(?<!in )flights?|hops?|hopping|traffic)\b", re.IGNORECASE)


def files(*folders, suffixes=(".cpp", ".h", ".cl", ".clh")):
    return sorted(f for folder in folders for f in (ROOT / folder).rglob("*") if f.suffix in suffixes)


def source():
    return files("host", "kernels", "include")


def name(file):
    return str(file.relative_to(ROOT))


def lines_with(pattern, among):
    """file:line: text of every line that matches."""
    return [f"{name(f)}:{i}: {line.strip()}" for f in among
            for i, line in enumerate(f.read_text(encoding="utf-8").splitlines(), 1) if pattern.search(line)]


def is_kinds_own(file):
    parts = file.relative_to(ROOT).parts
    return parts[:2] == ("host", "kinds") or (parts[0] == "kernels" and parts[1] in FAMILIES)


def cases_over_kinds():
    pattern = re.compile(r"\bcase (kind_|camera_|shape_(?!kinds)|\w+::\w*[kK]ind|\w*Kind::)")
    return lines_with(pattern, [f for f in source() if not is_kinds_own(f)])


def visits_of_kinds():
    pattern = re.compile(r"std::(visit\(Overloaded|get<\w*(Texture|Material|Light|Mesh)\w*>|holds_alternative<\w*(Texture|Material|Light|Mesh))")
    return lines_with(pattern, source())


def enumerations_of_kinds():
    return lines_with(re.compile(r"^\s*enum (class )?\w*([kK]ind|Pattern|KindOfPbrt)\b(?!.*;\s*$.*\()"), files("host"))


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.DOTALL)


def files_of(kind):
    """The files whose code names a kind, other than the lists of families."""
    pattern = re.compile(rf"(?<![a-z]){kind}(?![a-z])", re.IGNORECASE)
    return [name(f) for f in source() if f.name not in LISTS.values() and pattern.search(without_comments(f.read_text(encoding="utf-8")))]


def longest_recipe():
    """The lines of the longest of the recipes that add a kind."""
    text = (ROOT / "docs/recipes.md").read_text(encoding="utf-8")
    recipes = {r.split("\n", 1)[0]: [line for line in r.split("\n**")[0].split("\n")[1:] if line] for r in text.split("\n## ")[1:]}
    kinds = {title: lines for title, lines in recipes.items() if re.match(r"Add a (BSDF|light|texture|shape|medium|camera)$", title)}
    title = max(kinds, key=lambda t: len(kinds[t]))
    return [f"docs/recipes.md: {title}: {line}" for line in kinds[title]]


def long_lines():
    return [f"{name(f)}:{i}: {len(line)} columns" for f in source() + files("tests")
            for i, line in enumerate(f.read_text(encoding="utf-8").splitlines(), 1) if len(line) > 140]


def words_out():
    return lines_with(WORDS_OUT, source() + files("docs", suffixes=(".md",)) + [ROOT / "README.md"])


def stages_by_name():
    """Stages that the host finds by a string."""
    return lines_with(re.compile(r'\bfind\("\w+"\)|== "(generate|intersect|extinguish|classify|route|shade|test|resolve)_\w+"'), files("host/render", "host/app"))


def readme_files():
    return [ROOT / path for path in dict.fromkeys(README_FILES.findall((ROOT / "README.md").read_text(encoding="utf-8")))]


def conditionals_in_readme_files():
    return lines_with(re.compile(r"^#\s*if(?!ndef \w+_(H|CLH|CL)$)"), readme_files())


def long_readme_files():
    return [f"{name(f)}: {n} lines" for f in readme_files() if (n := len(f.read_text(encoding="utf-8").splitlines())) > 150]


def declared(header):
    """Names that a header may be included for: nearly every word of it outside of comments."""
    text = without_comments(header.read_text(encoding="utf-8"))
    words = set(re.findall(r"\b[A-Za-z_]\w{2,}\b", re.sub(r"#include[^\n]*|#(ifndef|endif|pragma)[^\n]*", " ", text)))
    for macro in re.findall(r"#define (\w+)_KIND", text):
        words.add(macro)
    common = "namespace eikonal struct class enum const constexpr static inline return void int float double bool char auto std string vector " \
             "optional size_t include uint vec3 vec2 FN SHARED_FN __global for while else unsigned explicit operator default public private"
    return words - set(common.split())


def find_include(path, file):
    folders = [ROOT / "kernels", ROOT / "include"] if file.suffix in (".cl", ".clh") else [ROOT / "host", ROOT / "include", file.parent]
    return next((p for folder in folders if (p := folder / path).exists()), None)


def names_through(header, known):
    """Names that a header brings, those of the headers that it includes among them."""
    if header not in known:
        known[header] = declared(header)
        included = re.findall(r'#include "([^"]+)"', header.read_text(encoding="utf-8"))
        for other in filter(None, (find_include(path, header) for path in included)):
            known[header] = known[header] | names_through(other, known)
    return known[header]


def dead_includes():
    """Includes of headers of ours of which the file uses no name, nor of what they include."""
    dead, known = [], {}
    for f in source():
        text = f.read_text(encoding="utf-8")
        bare = re.sub(r"/\*.*?\*/|//[^\n]*|#include[^\n]*", " ", text, flags=re.DOTALL)
        words = set(re.findall(r"\b[A-Za-z_]\w{2,}\b", bare))
        if len(words) < 8:
            continue  # a file that only gathers others
        for i, line in enumerate(text.splitlines(), 1):
            include = re.match(r'#include "([^"]+)"', line)
            if not include or include[1].endswith("kinds.clh"):
                continue
            header = find_include(include[1], f)
            if header is None or header.stem == f.stem:
                continue
            if not names_through(header, known) & words:
                dead.append(f"{name(f)}:{i}: {include[1]}")
    return dead


# name: (what it counts, goal, limit, function)
MEASURES = {
    "cases": ("`case`s over kinds outside of the kinds' folders", 0, 0, cases_over_kinds),
    "visits": ("visits of variants of kinds", 0, 0, visits_of_kinds),
    "enumerations": ("enumerations of kinds on the host", 6, 6, enumerations_of_kinds),
    "goniometric": ("files of the goniometric light", 2, 2, lambda: files_of("goniometric")),
    "spherical": ("files of the spherical camera", 2, 2, lambda: [f for f in files_of("spherical") if "texture" not in f]),
    "cylinder": ("files of the cylinder", 3, 3, lambda: [f for f in files_of("cylinder") if "curve" not in f]  # a curve may be a cylinder, too
    ),
    "cloud": ("files of the cloud medium", 2, 2, lambda: files_of("cloud")),
    "wrinkled": ("files of the wrinkled texture", 2, 2, lambda: files_of("wrinkled")),
    "coatedconductor": ("files of the coated conductor", 3, 3, lambda: files_of("coated_?conductor")),
    "recipe": ("lines of the longest recipe for a kind", 4, 4, longest_recipe),
    "columns": ("lines of more than 140 columns", 0, 0, long_lines),
    "words": ("words that are out", 0, 0, words_out),
    "stages": ("stages that the host finds by a string", 0, 0, stages_by_name),
    "conditionals": ("`#if` in the files that the README names", 0, 0, conditionals_in_readme_files),
    "readme": ("files that the README names of more than 150 lines", 0, 0, long_readme_files),
    "includes": ("dead includes", 0, 0, dead_includes),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--places", choices=[*MEASURES, "all"], help="print the places that a measure counts")
    chosen = parser.parse_args().places
    print("| | goal | limit | count |\n|---|--:|--:|--:|")
    failed = False
    for key, (title, goal, limit, measure) in MEASURES.items():
        places = measure()
        over = len(places) > limit
        failed |= over
        print(f"| {title} (`{key}`) | {goal} | {limit} | {len(places)}{' OVER' if over else ''} |")
        if chosen in (key, "all") or over:
            print("\n".join(places))
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
