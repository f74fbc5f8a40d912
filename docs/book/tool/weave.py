#!/usr/bin/env python3
"""Weaves the book: one static site with an index in the margin, and a PDF.

    weave.py --output build/book [--no-pdf]
    weave.py --check         weaves into a temporary folder, without a PDF; exits with 77, skipped, if a tool is missing

Pandoc turns Markdown, mathematics (into MathML) and citations into HTML; listing.py makes the blocks of code. Afterwards every link within the
site is followed, and each figure is asked for what makes it: what is missing is an error, status 1. Needs pandoc, Pygments, libclang, Universal
Ctags and, for the PDF, Chromium.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

try:
    import clang.cindex  # noqa: F401
    import pygments  # noqa: F401
    MISSING = [tool for tool in ("pandoc", "ctags") if not shutil.which(tool)]
except ImportError as error:
    MISSING = [error.name]
if MISSING:
    print(f"skipped: there is no {MISSING[0]}; ./dev book installs what weaves the book, for /usr/bin/python3")
    sys.exit(77)

from concepts import Concepts
from examples import EXAMPLE
from figures import problems_of_figures
from fragments import BOOK, ROOT, Book, BookError, texts_of
from identifiers import Index
from listing import Listings
from mathematics import mended
from pdf import write_pdf
from repository_pages import RepositoryPages
from site_pages import check_links, figures_of, finished, index_pages, page_html, sections_of

FORMAT = "markdown+gfm_auto_identifiers+implicit_figures+tex_math_dollars+pipe_tables+autolink_bare_uris-smart"
TICKS = "`" * 10
# Debian's fonts-texgyre-math and fonts-texgyre. Their licence (GUST, a kind of LPPL) lets anyone pass them on. Without them, the reader's fonts serve.
GYRE = Path("/usr/share/texmf/fonts/opentype/public")
FONTS = {"math.otf": GYRE / "tex-gyre-math" / "texgyrepagella-math.otf",
         **{f"{style}.otf": GYRE / "tex-gyre" / f"texgyrepagella-{style}.otf" for style in ("regular", "bold", "italic", "bolditalic")}}


def chapter_names(pages):
    """The number (or letter) of each page's chapter: 01-one-ray is 1; the appendix a-01-one-ray is A1."""
    names = {}
    for page in pages:
        match = re.match(r"(a-)?(\d+)-", page.stem)
        names[page.stem] = ("A" if match[1] else "") + str(int(match[2])) if match else page.stem
    return names


def with_listings(page, book, listings):
    """The page's Markdown, its blocks of code as HTML."""
    blocks = {definition.first_line - 1: definition for definition in book.definitions if definition.page == page}
    lines, out, number = book.texts[page].split("\n"), [], 0
    while number < len(lines):
        number += 1
        definition = blocks.get(number)
        if definition:
            out += [TICKS + "{=html}", listings.block(definition), TICKS]
            number += len(definition.lines) + 1
        elif example := EXAMPLE.match(lines[number - 1]):
            # Pandoc takes one word behind a fence
            out += [f"`{example['path']}`" + (f", after the line with `{example['after']}`:" if example["after"] else ", a new file:"), "",
                    f"```{example['language']}"]
        else:
            out.append(lines[number - 1])
    return "\n".join(out)


def pandoc(text, references):
    command = ["pandoc", "--from", FORMAT, "--to", "html5", "--mathml", "--citeproc", "--bibliography", str(references),
               "--metadata", "link-citations=true", "--metadata", "suppress-bibliography=true"]
    result = subprocess.run(command, input=text, capture_output=True, text=True)
    if result.returncode:
        raise BookError(f"pandoc: {result.stderr.strip()}")
    return mended(result.stdout), result.stderr


def bibliography(references):
    text = "---\nnocite: '@*'\n---\n"
    result = subprocess.run(["pandoc", "--from", "markdown", "--to", "html5", "--citeproc", "--bibliography", str(references)],
                            input=text, capture_output=True, text=True, check=True)
    return result.stdout


def weave(folder, output, with_pdf):
    """Weaves the pages in `folder`; returns what is wrong with the site."""
    start = time.monotonic()
    book, references = Book(texts_of(folder)), folder / "references.bib"
    sources = list(book.texts)
    names = chapter_names(sources)
    listings = Listings(book, Index(book), names)
    with ThreadPoolExecutor(2) as pool:
        woven = list(pool.map(lambda page: pandoc(with_listings(page, book, listings), references), sources))
    warnings = [f"{page.name}: {line}" for page, (_, errors) in zip(sources, woven) for line in errors.splitlines()]
    concepts = Concepts([page for page in sources if page.name[0].isdigit()])
    bodies = concepts.linked({page.stem: body for page, (body, _) in zip(sources, woven)})
    bodies |= index_pages(book, listings, concepts, names, bodies, bibliography(references))
    shutil.rmtree(output, ignore_errors=True)
    (output / "figures").mkdir(parents=True)
    for file in (folder / "figures").glob("*.*"):
        shutil.copy(file, output / "figures")
    for file in ("style.css", "search.js"):
        shutil.copy(Path(__file__).parent / file, output)
    (output / "fonts").mkdir()
    for name, file in FONTS.items():
        if file.exists():
            shutil.copy(file, output / "fonts" / name)
    repository = RepositoryPages(folder, lambda text: pandoc(text, references)[0])
    complete = finished(bodies, names, folder, repository)
    for stem, text in page_html(complete, names, output).items():
        (output / f"{stem}.html").write_text(text, encoding="utf-8")
    repository.write(output)
    problems = [*warnings, *check_links(output), *problems_of_figures(folder)]
    printed = f", {write_pdf(sections_of(complete), output)} printed pages" if with_pdf else ""
    print(f"{len(sources)} pages, {len(book.definitions)} blocks of {len(book.fragments)} fragments and {len(book.files)} files, "
          f"{len(listings.index.defined)} identifiers, {len(figures_of(bodies))} figures{printed}: {output}/index.html in {time.monotonic() - start:.1f} s")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=ROOT / "build" / "book")
    parser.add_argument("--book", type=Path, default=BOOK, help="the folder of the book's pages")
    parser.add_argument("--no-pdf", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    try:
        if options.check:
            with tempfile.TemporaryDirectory() as folder:
                problems = weave(options.book.resolve(), Path(folder) / "book", False)
        else:
            problems = weave(options.book.resolve(), options.output, not options.no_pdf)
    except BookError as error:
        sys.exit(f"error: {error}")
    for problem in problems:
        print(problem, file=sys.stderr)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
