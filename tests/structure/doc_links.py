#!/usr/bin/env python3
"""Checks that the files which README.md, CONTRIBUTING.md, docs/*.md and the comments of the source mention exist.

In Markdown, checked are the target of every relative Markdown link outside code blocks, with its heading; in `backticks` and code blocks every path that
begins with one of the repository's folders; and every bare name of a source file in `backticks`, which some folder must have. A path may
hold {a,b} alternatives, the wildcard *, and placeholders: <name>, velvet, x.
In comments, checked are paths from the root, paths as an #include has them, and bare names of headers and kernels.
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

INCLUDE_FOLDERS = ("host", "kernels", "include", "tests")
# In a comment: a path from the root, a path to a file of source, or the name of one.
MENTION = re.compile(rf"(?<![\w/.<-])(?:(?:{'|'.join(FOLDERS)})/[\w./{{}},*<>+-]*|[a-z]\w*(?:/[\w{{}},*<>]+)*\.(?:clh?|h|cpp|py)\b(?![\w/(]))")


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


def comments(text):
    """(line number, text) of each line of comments, strings left alone."""
    for match in re.finditer(r'"(?:[^"\\\n]|\\.)*"|/\*.*?\*/|//[^\n]*', text, re.DOTALL):
        if match[0].startswith("/"):
            first = text.count("\n", 0, match.start()) + 1
            yield from enumerate(match[0].split("\n"), first)


def problems_of_comments(file, source_names):
    before = (0, "")
    for number, line in comments(file.read_text(encoding="utf-8")):
        context = line + before[1] * (before[0] == number - 1)
        before = (number, line)
        if "pbrt-v4's" in context:
            continue                     # files of pbrt
        for match in MENTION.finditer(line):
            path = match[0].rstrip(".,")
            if path.endswith("kinds.clh"):
                continue                 # made by the program: host/device/kind_files.h
            if "/" not in path:
                known = path in source_names or PLACEHOLDERS.sub("", "/" + path) != "/" + path
            else:
                known = any(exists(folder, path) for folder in [ROOT, *(ROOT / f for f in INCLUDE_FOLDERS), file.parent])
            if not known:
                yield number, f"there is no {path}"


def main():
    source_names = {file.name for folder in FOLDERS for file in (ROOT / folder).rglob("*.*")}
    found = 0
    documents = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
    sources = sorted(f for folder in ("host", "kernels", "include", "tests") for f in (ROOT / folder).rglob("*")
                     if f.suffix in (".cpp", ".h", ".cl", ".clh"))
    for check, file in chain(((problems, f) for f in documents), ((problems_of_comments, f) for f in sources)):
        for number, message in check(file, source_names):
            print(f"{file.relative_to(ROOT)}:{number}: {message}")
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
