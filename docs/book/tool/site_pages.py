"""The pages of the woven site around the chapters: frame, contents, indices, the single page for the PDF, and the check of links."""
import html
import json
import os
import re
from pathlib import Path
from urllib.parse import unquote

from identifiers import key_of

HEADING = re.compile(r"<h([1-3])(?: [^>]*?)?id=\"([^\"]+)\"[^>]*>(.*?)</h\1>", re.DOTALL)
FIGURE = re.compile(r"<figure>\s*<img src=\"(?P<src>[^\"]+)\"(?P<attributes>[^>]*?)/?>\s*<figcaption[^>]*>(?P<caption>.*?)</figcaption>\s*</figure>", re.DOTALL)
MEMBERS = ("<p>Bold: where a name is defined. <code>.x</code> is a member <code>x</code>, of every struct that has one. What a list or a macro makes has the list's "
           "row and the macro. Local variables, parameters and members of one letter are left out.</p>")
# What makes a figure lies beside it: NAME.pbrt or NAME.py
MAKERS = {".pbrt": "scene", ".py": "script"}
INDICES = {"references": "References", "index-of-concepts": "Index of concepts", "index-of-figures": "Index of figures",
           "index-of-fragments": "Index of fragments", "index-of-identifiers": "Index of identifiers"}


def plain(text):
    return html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", text))).strip()


def title_of(body):
    match = re.search(r"<h1[^>]*>(.*?)</h1>", body, re.DOTALL)
    return plain(match[1]) if match else "Untitled"


def label(stem, names):
    """ "4  " for chapter 4; "A4  " for its appendix; nothing for indices."""
    return f"{names[stem]}&ensp;" if stem in names and names[stem] != stem else ""


def figures_of(bodies):
    return [(stem, match) for stem, body in bodies.items() for match in FIGURE.finditer(body)]


def name_figure(match, number):
    """The id of a page's figure: its own, or one made of its number."""
    return (re.search(r'id="([^"]+)"', match["attributes"]) or [None, f"fig-{number}"])[1]


def number_figures(stem, body, names, folder):
    """Figures with a number, an id, and for images a link to the scene that makes them; SVG inline, so that it has the page's colours."""
    count = 0

    def figure(match):
        nonlocal count
        count += 1
        source = match["src"]
        identity = name_figure(match, count)
        picture = f'<img src="{source}"{match["attributes"]} loading="lazy">'.replace(f' id="{identity}"', "")
        if source.endswith(".svg") and (folder / source).exists():
            label = f'<svg role="img" aria-label="{html.escape(plain(match["caption"]))}"'
            picture = re.sub(r"^.*?<svg", lambda _: label, (folder / source).read_text(encoding="utf-8"), count=1, flags=re.DOTALL)
        made = "".join(f' <a href="{maker}">({name})</a>' for suffix, name in MAKERS.items()
                       if (folder / (maker := Path(source).with_suffix(suffix))).exists())
        return (f'<figure id="{identity}">{picture}<figcaption><b>Figure {names.get(stem, stem)}.{count}.</b> {match["caption"]}{made}</figcaption></figure>')
    return FIGURE.sub(figure, body)


def link_out(body, folder, repository):
    """Links of Markdown to pages of the book, and to files of the repository, as the site has them."""
    def address(match):
        target, _, anchor = match[1].partition("#")
        anchor = "#" + anchor if anchor else ""
        if anchor.startswith("#ref-") and not target:
            return f'href="references.html{anchor}"'
        if not target or re.match(r"[a-z]+:", target):
            return match[0]
        if re.fullmatch(r"[\w-]+\.md", target) and (folder / target).exists() and target != "README.md":
            return f'href="{target[:-3]}.html{anchor}"'
        file = (folder / target).resolve()
        if file.is_relative_to(folder / "figures") or target.endswith(".html") or not file.is_file():
            return match[0]  # check_links() names it if it is nowhere
        return f'href="{repository.link(file)}{anchor}"'
    return re.sub(r'href="([^"]+)"', address, body)


def rows(entries):
    return "<dl class=\"index\">" + "".join(entries) + "</dl>"


def index_pages(book, listings, concepts, names, bodies, bibliography):
    """The bodies of the first page and of the indices, by stem."""
    identifiers = []
    for name in sorted(listings.index.defined, key=lambda name: name.lower().lstrip(".")):
        places = listings.index.defined[name]
        defined = ", ".join(f'{place.kind} <a href="{listings.address(key_of(place.definition))}"><b>{listings.number_of[key_of(place.definition)]}</b></a>' for place in places)
        identifiers.append(f'<dt id="i-{html.escape(name)}"><code>{html.escape(name)}</code></dt><dd>{defined}; {listings.uses(name)}</dd>')
    fragments = []
    for name in sorted(book.fragments, key=str.lower):
        parts = " ".join(listings.link(part, listings.number_of[key_of(part)]) for part in book.fragments[name])
        user, _ = book.uses[name]
        fragments.append(f'<dt>⟨{html.escape(name)}⟩</dt><dd>{parts}; used in {listings.link(user, listings.number_of[key_of(user)])}</dd>')
    for name in sorted(book.files):
        parts = " ".join(listings.link(part, listings.number_of[key_of(part)]) for part in book.files[name])
        fragments.append(f'<dt><code>{html.escape(name)}</code></dt><dd>{parts}</dd>')
    figures, counts = [], {}
    for stem, match in figures_of(bodies):
        counts[stem] = counts.get(stem, 0) + 1
        caption = match["caption"].replace('href="#', f'href="{stem}.html#')
        figures.append(f'<dt><a href="{stem}.html#{name_figure(match, counts[stem])}">Figure {names.get(stem, stem)}.{counts[stem]}</a></dt><dd>{caption}</dd>')
    texts = {"references": bibliography, "index-of-concepts": rows(concepts.index(bodies, names)), "index-of-figures": rows(figures), "index-of-fragments": rows(fragments),
             "index-of-identifiers": MEMBERS + rows(identifiers)}
    made = {stem: f'<h1 id="{stem}">{title}</h1>\n{texts[stem]}' for stem, title in INDICES.items()}
    contents = []
    for stem, body in (bodies | made).items():
        sections = [f'<li><a href="{stem}.html#{identity}">{text}</a></li>' for level, identity, text in HEADING.findall(body) if level == "2" and not stem.startswith("a-")]
        contents.append(f'<li><a href="{stem}.html">{label(stem, names)}{html.escape(title_of(body))}</a>{"<ol>" + "".join(sections) + "</ol>" if sections else ""}</li>')
    front = ('<h1 id="eikonal">Eikonal: the program as a book</h1><p>A wavefront path tracer in OpenCL, from the first ray to the last bit. The text contains the program: '
             'every line of the kernels, of the contract between host and device, and of the scheduler stands in one of the numbered fragments, and '
             '<code>./dev tangle</code> makes the files from them.</p>')
    return {"index": front + f'<nav aria-label="contents"><ol class="contents">{"".join(contents)}</ol></nav>'} | made


def finished(bodies, names, folder, repository):
    """The bodies with numbered figures and the site's addresses."""
    def finish(stem, body):
        body = body.replace('<math display="block"', '<math display="block" tabindex="0"')  # it may scroll: keys must reach it
        return link_out(number_figures(stem, body, names, folder), folder, repository)
    return {stem: finish(stem, body) for stem, body in bodies.items()}


def page_html(bodies, names, output):
    """Whole pages by stem, of finished bodies; writes the words that search finds, search-words.js."""
    order = ["index", *(stem for stem in bodies if stem != "index")]
    titles = {stem: title_of(bodies[stem]) for stem in bodies}
    menu = "".join(f'<li><a href="{stem}.html">{label(stem, names)}{html.escape(titles[stem])}</a></li>' for stem in order)
    pages = {}
    for at, stem in enumerate(order):
        before = f'<a rel="prev" href="{order[at - 1]}.html">← {html.escape(titles[order[at - 1]])}</a>' if at else "<span></span>"
        after = f'<a rel="next" href="{order[at + 1]}.html">{html.escape(titles[order[at + 1]])} →</a>' if at + 1 < len(order) else "<span></span>"
        current = menu.replace(f'href="{stem}.html"', f'href="{stem}.html" aria-current="page"')
        pages[stem] = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(titles[stem])} - Eikonal</title><link rel="stylesheet" href="style.css"><link rel="icon" href="data:,"></head>
<body><a class="skip" href="#text">To the text</a>
<header><details class="menu"><summary>Contents</summary><nav aria-label="chapters"><ol>{current}</ol></nav></details>
<form class="search" role="search" hidden><label>Search <input type="search" autocomplete="off"></label><ol aria-live="polite"></ol></form></header>
<main id="text">{bodies[stem].replace("<h1", "<h1 class='title' data-number='" + names.get(stem, "") + "'", 1)}</main>
<footer><nav class="around" aria-label="pages before and after">{before}{after}</nav></footer>
<script src="search-words.js" defer></script><script src="search.js" defer></script></body></html>
"""
    words = []
    for stem, body in bodies.items():
        parts = re.split(r"(?=<h[1-3][ >])", body)
        for part in parts:
            heading = HEADING.match(part)
            if heading:
                chapter = "" if heading[1] == "1" else f"{names[stem]} {titles[stem]}" if names.get(stem, stem) != stem else titles[stem]
                words.append([f"{stem}.html#{heading[2]}", plain(heading[3]), chapter, plain(re.sub(r"<(math|svg|aside).*?</\1>", "", part, flags=re.DOTALL))])
    (output / "search-words.js").write_text("const words = " + json.dumps(words, ensure_ascii=False).replace("</", "<\\/") + ";\n", encoding="utf-8")
    return pages


def sections_of(bodies):
    """The pages as sections of one, of finished bodies, the contents first: addresses of pages become addresses within it."""
    texts = []
    for stem, body in bodies.items():
        body = re.sub(r'\bid="([^"]+)"', rf'id="{stem}--\1"', body)
        body = re.sub(r'href="#([^"]+)"', rf'href="#{stem}--\1"', body)
        body = re.sub(r'href="([\w-]+)\.html#([^"]+)"', r'href="#\1--\2"', body)
        body = re.sub(r'href="([\w-]+)\.html"', r'href="#page-\1"', body)
        texts.append(f'<section id="page-{stem}">{body}</section>')
    texts.insert(0, texts.pop(list(bodies).index("index")))
    return texts


def printed(sections):
    """The page that is printed."""
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Eikonal</title><link rel="stylesheet" href="style.css"></head>'
            f'<body class="print"><main>{"".join(sections)}</main></body></html>')


def check_links(output):
    """What is wrong with the links and ids of the site."""
    texts = {str(file.relative_to(output)): file.read_text(encoding="utf-8") for file in sorted(output.rglob("*.html"))}
    ids = {name: re.findall(r'\bid="([^"]+)"', text) for name, text in texts.items()}
    problems = []
    for name, text in texts.items():
        problems += [f"{name}: the id {identity} is there twice" for identity in sorted({i for i in ids[name] if ids[name].count(i) > 1})]
        for target in sorted(set(re.findall(r'(?:href|src)="([^"]+)"', text))):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, anchor = html.unescape(unquote(target)).partition("#")
            file = os.path.normpath(Path(name).parent / path) if path else name
            if not (output / file).exists():
                problems.append(f"{name}: {target} leads to no file")
            elif anchor and file in ids and anchor not in ids[file]:
                problems.append(f"{name}: {target} leads to no place of the page")
    return problems
