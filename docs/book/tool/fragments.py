"""The named fragments of the book, and the files that they make.

A fragment is a fenced block whose info string names what it defines:

    ```opencl kernels/light/spot.clh =            the file itself, a root
    ```opencl <<Fall off between two cones>> =    a named fragment
    ```opencl <<Fall off between two cones>> +=   more of it: definitions are joined in the order of the book

A line of code that is only <<Name>> stands for the fragment of that name, indented as far as the line. As /* <<Name>> */ (or // <<Name>>) the
line also becomes a comment with that name: the title of the paragraph. Each fragment is used exactly once, so each line of code has one place
in the book.
"""
import re
from collections import namedtuple
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BOOK = ROOT / "docs" / "book"

# What the book contains completely: every line of these files belongs to a fragment.
COVERED = ("kernels/**/*.cl", "kernels/**/*.clh", "include/eikonal/*.h",
           *(f"host/render/{stem}.{end}" for stem in ("wave", "path_loop", "batches_in_flight", "wave_counts", "wave_queues", "stages")
             for end in ("h", "cpp")), "host/render/stage_table.h")

FENCE = re.compile(r"^```\w+ (?:<<(?P<name>.+)>>|(?P<path>[\w./]+)) (?P<sign>\+?=)\s*$")
REFERENCE = re.compile(r"^(?P<indent> *)(?P<open>/\* |// )?<<(?P<name>.+)>>(?P<close> \*/)?$")

# One fenced block: the fragment that it adds to (a name, or a path if is_file), its page, and the number (from 1) and text of its lines.
Definition = namedtuple("Definition", "name is_file page first_line lines is_continued")

# A line of a tangled file: its text and where it comes from. is_title: it is the comment that a reference becomes, not a line of a fragment.
Line = namedtuple("Line", "text definition page number indent is_title")


class BookError(Exception):
    """A mistake in the book or in an edit; the text says where and what would work."""


def pages(book=BOOK):
    """The pages in the order of the book: chapters by number, then appendices."""
    return sorted(book.glob("[0-9a-z]*-*.md"), key=lambda page: (not page.name[0].isdigit(), page.name))


def texts_of(book=BOOK):
    """The text of each page of a book's folder, in the order of the book: path -> text."""
    return {page: page.read_text(encoding="utf-8") for page in pages(book)}


def definitions_of(page, text):
    """The definitions of one page, in order."""
    found, lines = [], text.split("\n")
    start = None
    for number, line in enumerate(lines, 1):
        if start is None and line.startswith("```"):
            start, fence = number, FENCE.match(line)
            if not fence and re.search(r"<<|\+?=\s*$", line):
                raise BookError(f"{page}:{number}: this fence defines nothing: write ```opencl <<Name>> = or ```opencl path/of/file =")
            if fence and fence["path"] and (fence["path"].startswith("/") or ".." in fence["path"].split("/")):
                raise BookError(f"{page}:{number}: {fence['path']} is outside the repository: write the path from its root")
        elif start is not None and line == "```":
            if fence:
                found.append(Definition(fence["name"] or fence["path"], bool(fence["path"]), page, start + 1,
                                        lines[start:number - 1], fence["sign"] == "+="))
            start = None
    if start is not None:
        raise BookError(f"{page}:{start}: this block has no end: a line with ``` alone")
    return found


class Book:
    """The fragments of pages (path -> text, in order). Raises BookError unless each is defined, before it is continued, and used exactly once."""

    def __init__(self, texts=None):
        self.texts = texts_of() if texts is None else texts
        self.definitions = [definition for page, text in self.texts.items() for definition in definitions_of(page, text)]
        self.fragments, self.files, self.uses = {}, {}, {}
        for definition in self.definitions:
            table = self.files if definition.is_file else self.fragments
            where = f"{definition.page}:{definition.first_line - 1}"
            if definition.name in table and not definition.is_continued:
                other = table[definition.name][0]
                raise BookError(f"{where}: {definition.name} is already defined at {other.page}:{other.first_line - 1}: write += to add to it")
            if definition.name not in table and definition.is_continued:
                raise BookError(f"{where}: {definition.name} is not defined before this: write = here")
            table.setdefault(definition.name, []).append(definition)
            for offset, text in enumerate(definition.lines):
                if reference := REFERENCE.match(text):
                    self._note_use(reference["name"], definition, definition.first_line + offset)
        for name, (definition, number) in self.uses.items():
            if name not in self.fragments:
                raise BookError(f"{definition.page}:{number}: <<{name}>> is not defined")
        for name, parts in self.fragments.items():
            if name not in self.uses:
                raise BookError(f"{parts[0].page}:{parts[0].first_line - 1}: no fragment uses <<{name}>>")

    def parts_of(self, definition):
        """All definitions of what this one adds to."""
        return (self.files if definition.is_file else self.fragments).get(definition.name, [])

    def _note_use(self, name, definition, number):
        if name in self.uses:
            other, line = self.uses[name]
            raise BookError(f"{definition.page}:{number}: <<{name}>> is used a second time; the first is {other.page}:{line}")
        self.uses[name] = (definition, number)

    def tangle(self, path):
        """The lines of the file `path` (from the repository's root)."""
        return list(self._expand(self.files[path], "", ()))

    def _expand(self, parts, indent, inside):
        for definition in parts:
            for offset, text in enumerate(definition.lines):
                number = definition.first_line + offset
                line = Line(indent + text if text else "", definition, definition.page, number, indent, False)
                reference = REFERENCE.match(text)
                if not reference:
                    yield line
                    continue
                name = reference["name"]
                if name in inside:
                    raise BookError(f"{definition.page}:{number}: <<{name}>> contains itself")
                deeper = indent + reference["indent"]
                if reference["open"]:
                    title = f"{deeper}{reference['open']}{name}{reference['close'] or ''}"
                    yield line._replace(text=title, is_title=True)
                yield from self._expand(self.fragments[name], deeper, (*inside, name))


def text_of(lines):
    """The text of a file with these Lines."""
    return "".join(line.text + "\n" for line in lines)


def covered_files(root=ROOT):
    """The paths of the files that the book must contain."""
    return sorted({str(file.relative_to(root)) for pattern in COVERED for file in root.glob(pattern)})
