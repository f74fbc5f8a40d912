"""The book as a PDF: printed by Chromium, with an outline and page numbers in its table of contents."""
import html
import re
import subprocess
from pathlib import Path

from site_pages import printed


HEADING = re.compile(r'<h([12])[^>]* id="([^"]+)"[^>]*>(.*?)</h\1>', re.DOTALL)


def print_page(page, pdf):
    # Without tags: they double the time and treble the size. Who needs them reads the site
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-pdf-tagging", "--no-pdf-header-footer",
                    f"--print-to-pdf={pdf}", f"file://{Path(page).resolve()}"], check=True, capture_output=True)


def outline_of(sections, page_of):
    """(level, title, page) of the headings, in order."""
    for section in sections:
        first = re.match(r'<section id="([^"]+)"', section)
        for level, identity, title in HEADING.findall(section):
            place = first[1] if first and level == "1" else identity   # chapters are linked to as sections
            if place in page_of:
                yield int(level), " ".join(html.unescape(re.sub(r"<[^>]+>", "", title)).split()), page_of[place]



def with_pages(contents, page_of):
    """The contents, each link with the number of its page."""
    return re.sub(r'<a href="#([^"]+)"', lambda match: f'{match[0]} data-page="{page_of[match[1]]}"' if match[1] in page_of else match[0], contents)


def write_pdf(sections, output):
    """Writes output/eikonal.pdf of the sections of the single page, of which the first is the contents.

    Only the printed book tells on which page a section is. So the contents are printed again, with these numbers, and replace the first pages:
    the numbers do not change where lines end.
    """
    import pikepdf
    (output / "all.html").write_text(printed(sections), encoding="utf-8")
    print_page(output / "all.html", output / "eikonal.pdf")
    with pikepdf.open(output / "eikonal.pdf", allow_overwriting_input=True) as book:
        number_of = {page.objgen: number for number, page in enumerate(book.pages, 1)}
        page_of = {str(name).removeprefix("/"): number_of[place[0].objgen] for name, place in book.Root.Dests.items()}
        contents, numbered = output / "contents.html", output / "contents.pdf"
        contents.write_text(printed([with_pages(sections[0], page_of)]), encoding="utf-8")
        print_page(contents, numbered)
        with pikepdf.open(numbered) as pages:
            for page, new in zip(book.pages, pages.pages):
                page.Contents = book.copy_foreign(new.obj.Contents)
                page.Resources = book.copy_foreign(pages.make_indirect(new.obj.Resources))
            with book.open_outline() as outline:
                items = outline.root
                for level, title, number in outline_of(sections, page_of):
                    item = pikepdf.OutlineItem(title, number - 1)
                    item.is_closed = True
                    if level == 1:
                        outline.root.append(item)
                        items = item.children
                    else:
                        items.append(item)
            count = len(book.pages)
            book.save(object_stream_mode=pikepdf.ObjectStreamMode.generate)
    contents.unlink()
    numbered.unlink()
    return count
