#!/usr/bin/env python3
"""Checks that the files which README.md and docs/*.md mention exist.

Checked are the target of every relative Markdown link outside code blocks, with its heading; in `backticks` and code blocks every path that
begins with one of the repository's folders; and every bare name of a source file in `backticks`, which some folder must have. A path may
hold {a,b} alternatives, the wildcard *, and placeholders: <name>, velvet, x.
Prints file:line: message for each missing file, then exits with status 1.
"""
import re
import sys
from itertools import chain, product
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("host", "kernels", "include", "tests", "docs", "scenes", "cmake")
# File names that recipes use for a file that the reader is about to write.
PLACEHOLDERS = re.compile(r"<[^<>]*>|(?<=/)(velvet|x)(?=\.)")
SOURCE_NAME = re.compile(r"[a-z]\w*\.(?:clh?|h|cpp|py)")
LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`]+)`")
PATH = re.compile(rf"(?<![\w/.-])(?:{'|'.join(FOLDERS)})/[\w./{{}},*<>+-]*")


def alternatives(path):
    """a/{b,c}.h -> a/b.h, a/c.h"""
    parts = [part[1:-1].split(",") if part.startswith("{") else [part] for part in re.split(r"(\{[^{}]*\})", path)]
    return ["".join(choice) for choice in product(*parts)]


def exists(folder, path):
    """Whether each alternative of the path names at least one file or folder."""
    pattern = PLACEHOLDERS.sub("*", path)
    return all(any(folder.glob(p)) if "*" in p else (folder / p).exists() for p in alternatives(pattern))


def headings(file):
    """The anchors that GitHub gives the headings of a Markdown file."""
    titles = re.findall(r"^#+ (.*)$", file.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-") for title in titles}


def problems(file, source_names):
    in_block = False
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if line.lstrip().startswith("```"):
            in_block = not in_block
            continue
        if not in_block:
            for target in LINK.findall(line):
                path, _, heading = target.partition("#")
                if re.match(r"[a-z]+:", target):
                    continue
                if path and not exists(file.parent, path):
                    yield number, f"the link to {target} leads to no file"
                elif heading and heading not in headings(file.parent / path if path else file):
                    yield number, f"the link to {target} leads to no heading"
        for code in [line] if in_block else CODE.findall(line):
            for path in PATH.findall(code):
                path = path.rstrip(".,")
                if not exists(ROOT, path):
                    yield number, f"there is no {path}"
            if not in_block and SOURCE_NAME.fullmatch(code) and code not in source_names:
                yield number, f"no folder has a file {code}"


def main():
    source_names = {file.name for folder in FOLDERS for file in (ROOT / folder).rglob("*.*")}
    found = 0
    for file in chain([ROOT / "README.md"], sorted((ROOT / "docs").glob("*.md"))):
        for number, message in problems(file, source_names):
            print(f"{file.relative_to(ROOT)}:{number}: {message}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
