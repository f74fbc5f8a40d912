#!/usr/bin/env python3
"""Counts what makes the source hard to read, and fails if a count grows.

Each measure has a goal and a limit: the limit is what the source has today, or the goal where that is reached. Lower a limit when you lower
its count. Prints a Markdown table; with --places MEASURE also the places that it counts. Exits with status 1 if a count is over its limit.
"""
import argparse
import re
import sys
from functools import cache
from pathlib import Path

from declarations import Macros, declared, text_of, without_comments

ROOT = Path(__file__).resolve().parents[2]
FAMILIES = ("light", "shape", "camera", "medium", "texture", "bsdf")
LISTS = ("lights.h", "shapes.h", "cameras.h", "media.h", "textures.h", "bsdfs.h", "materials.h")
README_FILES = re.compile(r"\((kernels/[\w/.]+\.clh?|host/[\w/.]+\.(?:cpp|h)|include/[\w/.]+\.h)\)")
# Terms that were replaced, and words that a graphics engineer would have to look up (the field's words stand in docs/glossary.md). "branch"
# for one of the rays that a ray splits into is out, too, but means branches of code nearly everywhere.
WORDS_OUT = re.compile(r"\b(nobody\w*|somebody\w*|passages?|relieve[sd]?|palettes?(?! \()|foci|emergence|way_out|one_wave|part_wavelengths|"
                       r"(?<!in[ -])flights?|hops?|hopping|traffic|forks|runs? of slots|int is|paths? (that )?(is|are) blurred|(a|each|the) bundle|"
                       r"bundles|(?-i:\w*Book))\b", re.IGNORECASE)


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


def comparisons_with_kinds():
    """Code that asks whether something is of one kind: by the kind's variable (&mix_material), its number (kind_point_light) or its queue
    (next_hair)."""
    bsdfs = "|".join(macros().entries("BSDFS") - {"subsurface_exit"})   # the BSDF of no material: the surface that diffusion profiles end at
    kind = rf"(&\w+_(light|shape|camera|medium|texture|material|filter|integrator)|kind_\w+_(light|medium|texture)|" \
           rf"camera_(?!kinds)\w+|shape_(?!kinds)\w+|next_({bsdfs}))\b"
    pattern = re.compile(rf"[!=]= {kind}|{kind} [!=]=")
    return lines_with(pattern, [f for f in files("host", "kernels") if not is_kinds_own(f)])


def enumerators(file, with_lists):
    """(name, line, enumerators) of each enumeration in a file: those that it spells out, and also the kinds of its lists."""
    text = text_of(file)
    for match in re.finditer(r"\benum (?:class |struct )?(\w+)[^;{(]*\{([^}]*)\}", text):
        body = re.sub(r"^\s*#[^\n]*", "", match[2], flags=re.MULTILINE)
        for kinds in re.findall(r"\b([A-Z_]+)\(\w+\)", body) if with_lists else []:
            body += "," + ",".join(macros().entries(kinds))
        names = re.findall(r"(?:^|,)\s*([A-Za-z]\w*)", re.sub(r"\b[A-Z_]+\([^)]*\)", "", body))
        yield match[1], text.count("\n", 0, match.start()) + 1, names


def plain(names):
    """Enumerators without a prefix that all have, case and underscores: wrap_repeat, wrap_clamp and Repeat, Clamp are alike."""
    first = names[0].split("_")[0] + "_" if names else ""
    if len(names) > 1 and all(n.startswith(first) for n in names):
        names = [n.removeprefix(first) for n in names]
    return {n.replace("_", "").lower() for n in names}


def enumerations_of_kinds():
    """Enumerations on the host of kinds of something in a scene: called SomethingKind, or saying again what an enumeration or a list of the
    contract says."""
    contract = [plain(names) for f in files("include") for _, _, names in enumerators(f, True)]
    contract += [plain(list(macros().entries(kinds))) for kinds in macros().definitions if kinds.isupper()]
    found = []
    for f in files("host"):
        for enum, line, names in enumerators(f, False):
            own = plain(names)
            again = any(len(own & other) > 1 and len(own & other) >= max(len(own), len(other)) / 2 for other in contract)
            if again or re.search(r"\w(Kind|KindOfPbrt|Pattern)$", enum):
                found.append(f"{name(f)}:{line}: {enum}")
    return found


def files_of(kind):
    """The files whose code names a kind, other than the lists of families."""
    pattern = re.compile(rf"(?<![a-z]){kind}(?![a-z])", re.IGNORECASE)
    return [name(f) for f in source() if f.name not in LISTS and pattern.search(without_comments(f.read_text(encoding="utf-8")))]


def longest_recipe():
    """The steps of the longest of the recipes that add a kind."""
    page = "docs/book/16-adding-a-kind.md"
    text = (ROOT / page).read_text(encoding="utf-8").split("\n## Recipes\n")[1].split("\n## ")[0]
    recipes = {r.split("\n", 1)[0]: re.findall(r"^\d+\. .*$", r, re.MULTILINE) for r in text.split("\n### ")[1:]}
    kinds = {title: steps for title, steps in recipes.items() if re.match(r"A (BSDF|light|texture|shape|medium|camera)$", title)}
    title = max(kinds, key=lambda t: len(kinds[t]))
    return [f"{page}: {title}: {step}" for step in kinds[title]]


def long_lines():
    return [f"{name(f)}:{i}: {len(line)} columns" for f in source() + files("tests")
            for i, line in enumerate(f.read_text(encoding="utf-8").splitlines(), 1) if len(line) > 140]


def words_out():
    others = [ROOT / f for f in ("README.md", "CONTRIBUTING.md", "CMakeLists.txt", "dev")] + files("docs", suffixes=(".md",))
    tests = files("tests", suffixes=(".cpp", ".h", ".cl", ".clh", ".py", ".txt"))
    return lines_with(WORDS_OUT, source() + others + [f for f in tests if f != Path(__file__).resolve()])


def stages_by_name():
    """Stages that the host finds by a string."""
    return lines_with(re.compile(r'\bfind\("\w+"\)|== "(generate|intersect|extinguish|classify|route|shade|test|resolve)_\w+"'), files("host/render", "host/app"))


def readme_files():
    return [ROOT / path for path in dict.fromkeys(README_FILES.findall((ROOT / "README.md").read_text(encoding="utf-8")))]


def conditionals_in_readme_files():
    return lines_with(re.compile(r"^#\s*if(?!ndef \w+_(H|CLH|CL)$)"), readme_files())


def long_readme_files():
    return [f"{name(f)}: {n} lines" for f in readme_files() if (n := len(f.read_text(encoding="utf-8").splitlines())) > 150]


def find_include(path, file):
    folders = [ROOT / "kernels", ROOT / "include"] if file.suffix in (".cl", ".clh") else [ROOT / "host", ROOT / "include", file.parent]
    return next((p for folder in folders if (p := folder / path).exists()), None)


def included_by(file):
    """(line, the header) of the includes of ours."""
    for i, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        include = re.match(r'#include "([^"]+)"', line)
        header = include and find_include(include[1], file)
        if header:
            yield i, header


def gathers(file):
    """Headers that are there to include others: those that declare nothing, and those that the files of a family of kinds include first."""
    return not any(names_of(file)) or re.fullmatch(r"host/kinds/\w+_(packing|reading)\.h", name(file))


@cache
def names_of(header):
    return declared(header, macros())


@cache
def macros():
    return Macros(source())


@cache
def names_through(header):
    """All names that a header brings."""
    names = set().union(*names_of(header))
    for _, other in included_by(header):
        names |= names_through(other)
    return names


def words_of(file):
    """(words, words behind a dot or arrow) of a file's code. An exception that a comment says is thrown counts as a word."""
    bare = re.sub(r"^\s*#\s*include[^\n]*", " ", text_of(file), flags=re.MULTILINE)
    words = set(re.findall(r"[A-Za-z_]\w*", bare))
    words.update(re.findall(r"[Tt]hrows? (?:an? )?(\w+)", file.read_text(encoding="utf-8")))
    for call, arguments in re.findall(r"\b([A-Z]\w*)\(([^()]*)\)", bare):
        words |= macros().made_by(call, re.findall(r"[A-Za-z_]\w*", arguments), file)
    return words, set(re.findall(r"(?:\.|->)\s*([A-Za-z_]\w{2,})", bare))


def dead_includes():
    """Includes of headers of ours that declare nothing that the file uses. What those headers include in turn does not count, but for
    those that gather others. In kernels it counts, since macros make most of the names there."""
    dead = []
    for f in source():
        if f.suffix in (".h", ".clh") and gathers(f):
            continue
        words, members = words_of(f)
        for i, header in included_by(f):
            if header.stem == f.stem or re.search(r"template <>|#pragma (clang|OPENCL)", text_of(header)):
                continue                # its own header; specialisations and compiler settings need no name
            if f.is_relative_to(ROOT / "kernels"):
                is_used = names_through(header) & words
            else:
                brought = [header] + [h for _, h in included_by(header)] * bool(gathers(header))
                others = set().union(*(names_of(h)[1] for _, h in included_by(f) if h not in brought))   # `.name` may be of any of them
                is_used = any(names_of(h)[0] & words or names_of(h)[1] & members - others for h in brought)
            if not is_used:
                dead.append(f"{name(f)}:{i}: {name(header)}")
    return dead


# name: (what it counts, goal, limit, function)
MEASURES = {
    "cases": ("`case`s over kinds outside of the kinds' folders", 0, 0, cases_over_kinds),
    "comparisons": ("comparisons with one kind outside of the kinds' folders", 0, 8, comparisons_with_kinds),
    "visits": ("visits of variants of kinds", 0, 0, visits_of_kinds),
    "enumerations": ("enumerations of kinds on the host", 6, 3, enumerations_of_kinds),
    "goniometric": ("files of the goniometric light", 2, 2, lambda: files_of("goniometric")),
    "spherical": ("files of the spherical camera", 2, 2, lambda: [f for f in files_of("spherical") if "texture" not in f]),
    # A curve may be a cylinder, too
    "cylinder": ("files of the cylinder", 3, 3, lambda: [f for f in files_of("(?<!curve_)cylinder") if "curve" not in f]),
    "cloud": ("files of the cloud medium", 2, 2, lambda: files_of("cloud")),
    "wrinkled": ("files of the wrinkled texture", 2, 2, lambda: files_of("wrinkled")),
    "coatedconductor": ("files of the coated conductor", 3, 2, lambda: files_of("coated_?conductor")),
    "recipe": ("steps of the longest recipe for a kind", 4, 5, longest_recipe),
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
