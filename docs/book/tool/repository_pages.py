"""The files of the repository that the book links to, as part of the site: Markdown as pages, other text as it is.

They lie below repository/, with the paths that they have in the repository. A link from them to what the site does not have becomes plain text.
"""
import html
import os
import re
import shutil

from fragments import ROOT, BookError

FOLDER = "repository"
LINK = re.compile(r'<a\s+href="([^"#]*)(#[^"]*)?"([^>]*)>(.*?)</a>', re.DOTALL)


def address_of(file):
    """Where a file of the repository lies in the site, from its root; None if it is no file, or outside."""
    if not file.is_relative_to(ROOT) or not file.is_file():
        return None
    path = file.relative_to(ROOT)
    return f"{FOLDER}/{path.with_suffix('.html') if path.suffix == '.md' else f'{path}.txt'}"


class RepositoryPages:
    """Collects the files that are linked to, and writes them. to_html: turns Markdown into the body of a page."""

    def __init__(self, book_folder, to_html):
        self.book_folder, self.to_html, self.linked = book_folder, to_html, []

    def link(self, file):
        """The address of a file that a page links to, from the site's root."""
        address = address_of(file)
        if address is None:
            raise BookError(f"{file} is linked to, but is no file of the repository")
        if file not in self.linked:
            self.linked.append(file)
        return address

    def write(self, output):
        for file in self.linked:  # grows: pages link to pages
            target = output / address_of(file)
            target.parent.mkdir(parents=True, exist_ok=True)
            if file.suffix == ".md":
                target.write_text(self._page(file, target.parent, output), encoding="utf-8")
            else:
                shutil.copy(file, target)

    def _page(self, file, folder, output):
        body = self.to_html(file.read_text(encoding="utf-8"))

        def link(match):
            path, anchor, attributes, text = match.groups("")
            if re.match(r"[a-z]+:", path) or not path:
                return match[0]
            to = (file.parent / html.unescape(path)).resolve()
            if to.parent == self.book_folder and (output / f"{to.stem}.html").exists():
                address = f"{to.stem}.html"
            elif to.suffix == ".md" and to.is_file():
                address = self.link(to)
            else:
                return text
            return f'<a href="{os.path.relpath(output / address, folder)}{anchor}"{attributes}>{text}</a>'

        def picture(match):
            source = file.parent / html.unescape(match[1])
            if source.is_file():
                (folder / match[1]).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, folder / match[1])
            return match[0]
        body = re.sub(r'<img\s+src="([^":]+)"', picture, LINK.sub(link, body))
        title = html.escape(re.sub(r"<[^>]+>", "", (re.search(r"<h1[^>]*>(.*?)</h1>", body, re.DOTALL) or ["", file.name])[1]))
        root = os.path.relpath(output, folder)
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
                f'<title>{title} - Eikonal</title><link rel="stylesheet" href="{root}/style.css"><link rel="icon" href="data:,"></head>\n'
                f'<body><header><a href="{root}/index.html">The program as a book</a></header><main id="text">{body}</main></body></html>\n')
