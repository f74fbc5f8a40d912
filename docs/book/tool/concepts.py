#!/usr/bin/env python3
"""The concepts of the book. A term in bold is defined there; each is defined once, and used only after that, or with a link.

    concepts.py          says where that does not hold; status 1 if it does anywhere
    concepts.py --list   the concepts and where they are defined
"""
import argparse
import html
import re
import sys
from collections import namedtuple

from fragments import pages

# A concept: its page's stem, its line, and where the page's text has it.
Concept = namedtuple("Concept", "stem line position")

# Concepts whose words are everyday English, too: only a reader can tell which is meant, so they are neither checked nor linked.
EVERYDAY = frozenset((
    "base", "bias", "block", "centre", "channels", "dead", "dense", "error", "instance",
    "interval", "kind", "layer", "map", "object", "parts", "place", "program", "shape", "sparse", "stop",
    "stretch", "weight", "words"))

BOLD = re.compile(r"\*\*(.+?)\*\*", re.DOTALL)
# What is not prose: code, mathematics, comments, citations, headings, and the sections that ask and are answered by the chapter
NOT_PROSE = re.compile(r"^(```+).*?^\1$|^## (?:Seven questions|Exercises)\n.*?(?=^## |\Z)|`[^`]+`|\$\$.*?\$\$|\$[^$]+\$|<!--.*?-->|\[@[^]]*\]|^#+ .*?$",
                       re.DOTALL | re.MULTILINE)
LINK = re.compile(r"(?<!!)\[([^]]*)\]\(([^)\s]*)\)")


def normal(term):
    return re.sub(r"\s+", " ", term).strip(" .:").lower()


def id_of(term):
    """What the ids of a term end with: c-... where it is defined, u-... where a chapter first uses it."""
    return re.sub(r"\W+", "-", term)


def prose_of(text):
    """The text with blanks for what is not prose, line for line and column for column."""
    return NOT_PROSE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def pattern_of(terms):
    """Matches a use of any of the terms: as it is or in the plural, across the end of a line."""
    if not terms:
        return re.compile("(?!)")
    longest_first = sorted(terms, key=len, reverse=True)
    return re.compile(r"(?<![\w-])(" + "|".join(r"\s+".join(map(re.escape, term.split(" "))) for term in longest_first) + r")(?:s|es)?(?![\w-])",
                      re.IGNORECASE)


class Concepts:
    """defined: term -> Concept, of the chapters. problems: what is wrong, as page:line: text."""

    def __init__(self, chapters=None):
        chapters = chapters or [page for page in pages() if page.name[0].isdigit()]
        sources = {page.stem: page.read_text(encoding="utf-8") for page in chapters}
        texts = {stem: prose_of(text) for stem, text in sources.items()}
        self.order, self.defined, self.problems = list(texts), {}, []
        for stem, text in texts.items():
            for match in BOLD.finditer(text):
                term, line = normal(match[1]), text.count("\n", 0, match.start()) + 1
                if term in self.defined:
                    first = self.defined[term]
                    self.problems.append(f"{stem}.md:{line}: **{term}** is defined a second time; the first is {first.stem}.md:{first.line}: link there instead")
                else:
                    self.defined[term] = Concept(stem, line, match.start())
        for stem, text in texts.items():
            self.problems += self._used_too_early(stem, text, max(0, sources[stem].find("\n## ")))

    def _used_too_early(self, stem, text, begin):
        """First uses of terms that are defined later, unless they are links. The sentences before `begin` say what the chapter is about."""
        here = self.order.index(stem)
        later = {term for term, concept in self.defined.items() if self.order.index(concept.stem) >= here} - EVERYDAY
        if not later:
            return
        links = [match.span(1) for match in LINK.finditer(text)]
        targets = [match.span(2) for match in LINK.finditer(text)]
        bold = [match.span() for match in BOLD.finditer(text)]
        seen = set()

        def inside(spans):
            return any(first <= start < last for first, last in spans)
        for match in pattern_of(later).finditer(text, begin):
            term, start = normal(match[1]), match.start()
            concept = self.defined[term]
            is_defined = concept.stem == stem and concept.position <= start
            if term in seen or inside(targets) or inside(bold) and not is_defined:
                continue
            seen.add(term)
            if inside(links) or is_defined:
                continue
            yield f"{stem}.md:{text.count(chr(10), 0, start) + 1}: \"{term}\" is used before it is defined at {concept.stem}.md:{concept.line}: link there, or define it here"

    def linked(self, bodies):
        """The chapters' HTML with each definition marked by an id, and each chapter's first use of another's concept linked to its definition."""
        pattern = pattern_of(set(self.defined) - EVERYDAY)
        return {stem: self._link_uses(stem, self._mark_definitions(stem, body), pattern) if stem in self.order else body
                for stem, body in bodies.items()}

    def _mark_definitions(self, stem, body):
        marked = set()

        def mark(match):
            term = normal(html.unescape(re.sub(r"<[^>]+>", "", match[1])))
            if term in marked or term not in self.defined or self.defined[term].stem != stem:
                return match[0]
            marked.add(term)
            return f'<strong id="c-{id_of(term)}">{match[1]}</strong>'
        return re.sub(r"<strong>(.*?)</strong>", mark, body, flags=re.DOTALL)

    def _link_uses(self, stem, body, pattern):
        seen, inside, out = set(), [], []

        def link(match):
            term = normal(match[1])
            if term in seen or self.defined[term].stem == stem:
                return match[0]
            seen.add(term)
            return f'<a class="concept" id="u-{id_of(term)}" href="{self.defined[term].stem}.html#c-{id_of(term)}">{match[0]}</a>'
        for part in re.split(r"(<[^>]+>)", body):
            tag = re.match(r"<(/?)(a|code|pre|math|h[1-6]|aside|svg|strong|div|figure)\b", part)
            if tag and not part.endswith("/>"):
                inside.pop() if tag[1] else inside.append(tag[2])
            out.append(part if tag or inside or part.startswith("<") else pattern.sub(link, part))
        return "".join(out)

    def index(self, bodies, names):
        """Rows of the index, of linked bodies: each term with the chapter that defines it and the chapters that use it."""
        for term, concept in sorted(self.defined.items()):
            identity = id_of(term)
            uses = " ".join(f'<a href="{stem}.html#u-{identity}">{names[stem]}</a>' for stem in self.order if f'id="u-{identity}"' in bodies[stem])
            yield (f'<dt>{html.escape(term)}</dt><dd><a href="{concept.stem}.html#c-{identity}"><b>{names[concept.stem]}</b></a>'
                   f'{"; " + uses if uses else ""}</dd>')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    concepts = Concepts()
    if options.list:
        for term, concept in sorted(concepts.defined.items()):
            print(f"{term}: {concept.stem}.md:{concept.line}")
        return
    problems = concepts.problems + [f"concepts.py: the everyday word {word} is no concept" for word in sorted(EVERYDAY - set(concepts.defined))]
    print("\n".join(problems) or f"{len(concepts.defined)} concepts, each defined once and before it is used")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
