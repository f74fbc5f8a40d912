#!/usr/bin/env python3
"""Makes the code from the book, or takes edits of the code back into it.

    tangle.py               writes the files whose text differs from the book's
    tangle.py --check       says which differ, where, and which files are in no fragment; status 1 if any
    tangle.py --stitch      changes the book so that it makes the files as they are
    tangle.py --where FILE:LINE   the place in the book of a line of code

Edits that are not committed are kept on either side: what the code has changed since book and code were last the same is told from what the book
has (base.py). --stitch takes both if they are in different fragments, and refuses otherwise. --force takes the side that is read.
"""
import argparse
import sys
from itertools import zip_longest
from pathlib import Path

from base import bases, remember
from fragments import BOOK, ROOT, Book, BookError, covered_files, text_of, texts_of
from stitch import Edits, merged, stitch


def read(root, path):
    """The text of a file of code, its ends of lines as they are; None if there is no such file."""
    try:
        return (root / path).read_bytes().decode()
    except FileNotFoundError:
        return None
    except UnicodeDecodeError as error:
        raise BookError(f"{path} is no UTF-8 text at byte {error.start + 1}: save it as UTF-8") from None


def write(root, path, text):
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    (root / path).write_bytes(text.encode())


def made(book, path):
    """The text of the file that the book makes; None if it makes no such file."""
    return text_of(book.tangle(path)) if path in book.files else None


def first_difference(book, path, text):
    """path:line of the first difference, and the page:line that makes it."""
    lines, wanted = text.split("\n"), [*book.tangle(path), None]
    number = next(n for n, (line, want) in enumerate(zip_longest(lines, wanted), 1) if line != (want.text if want else "" if n == len(wanted) else None))
    place = next(line for line in (*wanted[number - 1:number], *wanted[-2::-1]) if line)
    ending = " (its lines end with CR LF; the book's end with LF)" if number <= len(lines) and lines[number - 1].endswith("\r") else ""
    return f"{path}:{number} differs from the book, {place.page}:{place.number}{ending}"


def differing(book, root):
    """The files that are not what the book makes: path -> why."""
    problems = {}
    for path in covered_files(root):
        if path not in book.files:
            problems[path] = f"{path} is in no chapter: add a block that begins with ```opencl {path} ="
    for path, parts in book.files.items():
        text = read(root, path)
        if text is None:
            problems[path] = (f"{path} does not exist: ./dev tangle writes it; if it is to go, remove its block, {parts[0].page}:{parts[0].first_line - 1}, "
                              "and the fragments that only it uses")
        elif text != made(book, path):
            problems[path] = f"{first_difference(book, path, text)}: ./dev stitch takes the code's edits into the book, ./dev tangle writes the book's"
    return problems


def tangle(book, root, folder, force):
    known = list(bases(folder))
    for path in differing(book, root):
        if path not in book.files:
            continue
        text = read(root, path)
        if text is not None and not force and text not in (made(base, path) for base in known):
            raise BookError(f"{path} has edits that the book does not have: ./dev stitch takes them into the book, ./dev tangle --force loses them")
        write(root, path, made(book, path))
        print(f"written: {path}")


def stitched(base, book, root, paths):
    """The pages of the book with what the files have that the base does not. Raises BookError if an edit has no place, or two have the same."""
    edits = Edits()
    if new := [path for path in paths if path not in base.files]:
        raise BookError(f"the block of {new[0]} is new and differs from the file: make the two the same, or choose one: ./dev stitch --force takes the "
                        "file's text, ./dev tangle --force the book's")
    changed = [path for path in paths if read(root, path) != made(base, path)]
    for path in changed:
        stitch(base, path, read(root, path).removesuffix("\n").split("\n"), edits)
    edited = Book(edits.applied(base.texts))
    if wrong := [path for path in changed if made(edited, path) != read(root, path)]:
        raise BookError(f"the edits could not be placed: {', '.join(wrong)}: edit the book, then tangle. The book is unchanged")
    return merged(base, edited, book)


def stitch_all(book, root, folder, force):
    paths = [path for path in differing(book, root) if path in book.files and read(root, path) is not None]
    if not paths:
        return
    for path in paths:
        if "\r" in read(root, path):
            raise BookError(f"{first_difference(book, path, read(root, path))}: save it with LF")
    known = [book] if force else list(bases(folder))
    if not known:
        raise BookError("no commit tells whether the book or the code was edited: ./dev stitch --force takes the code's text, ./dev tangle --force the book's")
    errors = []
    for base in known:
        try:
            after = Book(stitched(base, book, root, paths))
            break
        except BookError as error:
            errors.append(error)
    else:
        raise errors[0]
    for page, text in after.texts.items():
        if text != book.texts[page]:
            page.write_text(text, encoding="utf-8")
    for path in paths:
        before, text = read(root, path), made(after, path)
        if before == text:
            print(f"stitched: {path}")
        elif before == made(base, path):
            print(f"only the book has edits of {path}: ./dev tangle writes it")
        else:
            write(root, path, text)
            print(f"stitched, and written with the book's edits: {path}")


def where(book, place):
    path, _, number = place.rpartition(":")
    lines = book.tangle(path) if path in book.files else []
    if not number.isdigit() or not 0 < int(number) <= len(lines):
        raise BookError(f"{place} is no FILE:LINE of the book's files")
    line = lines[int(number) - 1]
    print(f"{line.page}:{line.number}: {line.definition.name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true")
    action.add_argument("--stitch", action="store_true")
    action.add_argument("--where", metavar="FILE:LINE")
    parser.add_argument("--force", action="store_true", help="tangle, or stitch, also over edits of the other side")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    parser.add_argument("--book", type=Path, default=BOOK, help="the folder of the book's pages")
    options = parser.parse_args()
    try:
        book = Book(texts_of(options.book))
        if options.where:
            where(book, options.where)
            return
        if options.stitch:
            stitch_all(book, options.root, options.book, options.force)
        elif not options.check:
            tangle(book, options.root, options.book, options.force)
        book = Book(texts_of(options.book))
        problems = differing(book, options.root)
        print("".join(f"{problem}\n" for problem in problems.values()), end="", file=sys.stderr)
        if not problems and not options.check:
            remember(book, options.book)
        sys.exit(1 if problems else 0)
    except BookError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
