#!/usr/bin/env python3
"""Makes the code from the book, or takes edits of the code back into it.

    tangle.py               writes the files whose text differs from the book's
    tangle.py --check       says which differ, and which lines are in no fragment; status 1 if any
    tangle.py --stitch      changes the book so that it makes the files as they are
    tangle.py --where FILE:LINE   the place in the book of a line of code
"""
import argparse
import subprocess
import sys
from pathlib import Path

from fragments import BOOK, ROOT, Book, BookError, covered_files, pages, text_of
from stitch import Edits, stitch


def differing(book, root):
    """The files that are not what the book makes: path -> why."""
    problems = {}
    for path in covered_files(root):
        if path not in book.files:
            problems[path] = f"is in no chapter: add a block that begins with ```opencl {path} ="
    for path in book.files:
        file = root / path
        if not file.exists():
            problems[path] = "does not exist: ./dev tangle writes it"
        elif text_of(book.tangle(path)) != file.read_text(encoding="utf-8"):
            problems[path] = "differs from the book: ./dev stitch takes its edits into the book, ./dev tangle replaces it"
    return problems


def has_edits(root, path):
    """Whether the file differs from the last commit. What git does not know counts as edited if it exists."""
    if not (root / path).exists():
        return False
    status = subprocess.run(["git", "-C", str(root), "status", "--porcelain", "--", path], capture_output=True, text=True)
    return status.returncode != 0 or bool(status.stdout.strip())


def tangle(book, root, force):
    for path in differing(book, root):
        if path not in book.files:
            continue
        if has_edits(root, path) and not force:
            raise BookError(f"{path} has edits that are not committed: ./dev stitch takes them into the book, tangle --force loses them")
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text_of(book.tangle(path)), encoding="utf-8")
        print(f"written: {path}")


def stitch_all(book, root, folder):
    edits, changed = Edits(), []
    for path in differing(book, root):
        if path not in book.files or not (root / path).exists():
            continue
        changed.append(path)
        stitch(book, path, (root / path).read_text(encoding="utf-8").removesuffix("\n").split("\n"), edits)
    kept = {page: page.read_text(encoding="utf-8") for page in pages(folder)}
    edits.write(kept)
    try:
        after = Book(folder)
        wrong = [path for path in changed if text_of(after.tangle(path)) != (root / path).read_text(encoding="utf-8")]
    except BookError as error:
        wrong = [str(error)]
    if wrong:
        for page, text in kept.items():
            page.write_text(text, encoding="utf-8")
        raise BookError(f"the edits could not be placed: {', '.join(wrong)}: edit the book, then tangle. The book is unchanged")
    for path in changed:
        print(f"stitched: {path}")


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
    parser.add_argument("--force", action="store_true", help="tangle also over edits that are not committed")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository")
    parser.add_argument("--book", type=Path, default=BOOK, help="the folder of the book's pages")
    options = parser.parse_args()
    try:
        book = Book(options.book)
        if options.where:
            where(book, options.where)
        elif options.stitch:
            stitch_all(book, options.root, options.book)
        elif not options.check:
            tangle(book, options.root, options.force)
        if not options.where:
            problems = differing(Book(options.book), options.root)
            for path, problem in problems.items():
                print(f"{path} {problem}", file=sys.stderr)
            sys.exit(1 if problems else 0)
    except BookError as error:
        sys.exit(f"error: {error}")


if __name__ == "__main__":
    main()
