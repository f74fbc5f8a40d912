"""A block of code as HTML: its tokens coloured, identifiers linked to their definitions, references to fragments, and links to the blocks
before, after and around it."""
import html
import re

from pygments.token import STANDARD_TYPES, Token

from fragments import REFERENCE
from identifiers import key_of, placed_tokens_of

TYPES = {"vec2", "vec3", "spectrum", "uint", "uchar", "ushort", "ulong", "float2", "float4", "float8", "uint8", "int8", "size_t", "__global", "__constant",
         "__kernel", "FN", "SHARED_FN", "const", "inline", "static"}

SHORT = 10  # lines of a block that is not parted in print


def slug(name):
    """A name as part of an address."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


class Listings:
    """HTML of the blocks of a book. number_of: key of a block -> its number, as "4.12"; anchor_of: key -> its id, made of its name, so that
    addresses stay when blocks are added."""

    def __init__(self, book, index, chapter_of):
        self.book, self.index, self.number_of, self.anchor_of = book, index, {}, {}
        counts, anchors = {}, {}
        for definition in book.definitions:
            anchor = f"f-{slug(definition.name)}"
            anchors[anchor] = anchors.get(anchor, 0) + 1
            self.anchor_of[key_of(definition)] = anchor if anchors[anchor] == 1 else f"{anchor}--{anchors[anchor]}"
            chapter = chapter_of[definition.page.stem]
            counts[chapter] = counts.get(chapter, 0) + 1
            self.number_of[key_of(definition)] = f"{chapter}.{counts[chapter]}"

    def link(self, definition, text, css="fragment"):
        return f'<a class="{css}" href="{self.address(key_of(definition))}">{text}</a>'

    def address(self, key):
        return f"{key[0]}.html#{self.anchor_of[key]}"

    def reference(self, name):
        return self.link(self.book.fragments[name][0], f'⟨{html.escape(name)} <span class="number">{self.number_of[key_of(self.book.fragments[name][0])]}</span>⟩')

    def identifier(self, name, text, here):
        """The text of an identifier (or of None), linked to where it is defined unless that is here."""
        places = self.index.defined.get(name, [])
        blocks = {key_of(place.definition) for place in places}
        if not places or here in blocks:
            return html.escape(text)
        if name.startswith(".") and len(blocks) > 1:
            return f'<a class="id" href="index-of-identifiers.html#i-{html.escape(name)}">{html.escape(text)}</a>'
        return f'<a class="id" href="{self.address(key_of(places[0].definition))}">{html.escape(text)}</a>'

    def code(self, definition):
        """Its lines, each an element that tells its indentation. Tokens may span lines (comments), references stand between them."""
        here, texts = key_of(definition), ["" if not REFERENCE.match(line) else self._reference_line(line) for line in definition.lines]
        for kind, value, line, column in placed_tokens_of(definition.lines):
            css = STANDARD_TYPES.get(Token.Keyword.Type if value in TYPES else kind, "")
            name = self.index.name_at(definition, kind, value, line, column)
            for part_number, part in enumerate(value.split("\n")):
                if part:
                    text = self.identifier(name, part, here)
                    texts[line + part_number] += f'<span class="{css}">{text}</span>' if css else text
        return "".join(map(self._line, definition.lines, texts))

    def _reference_line(self, line):
        reference = REFERENCE.match(line)
        return reference["indent"] + self.reference(reference["name"])

    @staticmethod
    def _line(line, text):
        indent = len(line) - len(line.lstrip())
        style = f' style="--in:{indent}"' if indent else ""
        return f'<span class="line"{style}>{text}\n</span>'

    def block(self, definition):
        key, number = key_of(definition), self.number_of[key_of(definition)]
        parts = (self.book.files if definition.is_file else self.book.fragments)[definition.name]
        at = [key_of(part) for part in parts].index(key)
        name = f"<code>{html.escape(definition.name)}</code>" if definition.is_file else html.escape(definition.name)
        notes = []
        if at:
            notes.append("continues " + self.link(parts[at - 1], self.number_of[key_of(parts[at - 1])]))
        if at + 1 < len(parts):
            notes.append("continued in " + self.link(parts[at + 1], self.number_of[key_of(parts[at + 1])]))
        if not definition.is_file and at == 0:
            user, _ = self.book.uses[definition.name]
            notes.append("used in " + self.link(user, f"{html.escape(user.name)} {self.number_of[key_of(user)]}"))
        sign = "+≡" if at else "≡"
        whole = " whole" if len(definition.lines) <= SHORT else ""
        return (f'<div class="listing{whole}" id="{self.anchor_of[key]}"><div class="title">⟨{name} <span class="number">{number}</span>⟩{sign}'
                f'</div>{self.margin(key)}<pre>{self.code(definition)}</pre><div class="notes">{" · ".join(notes)}</div></div>')

    def margin(self, key):
        """The margin index: identifiers that the block defines, with the blocks that use them."""
        rows = []
        for name in dict.fromkeys(identifier.name for identifier in self.index.of_block[key]):
            rows.append(f'<dt>{html.escape(name)}</dt><dd>{self.uses(name, 6)}</dd>')
        return f'<aside class="margin" aria-label="identifiers defined here, and their uses"><dl>{"".join(rows)}</dl></aside>' if rows else ""

    def uses(self, name, most=None):
        """Links to the blocks that use an identifier, at most so many; or in words that there are none."""
        keys = self.index.used.get(name, [])
        links = [f'<a href="{self.address(key)}">{self.number_of[key]}</a>' for key in keys[:most]]
        if not links:
            return "used by the host" if name.rpartition("::")[2].lstrip(".") in self.index.host_words else "not used"
        more = f' <a href="index-of-identifiers.html#i-{html.escape(name)}">and {len(keys) - most} more</a>' if most and len(keys) > most else ""
        return " ".join(links) + more
