"""A block of code as HTML: its tokens coloured, identifiers linked to their definitions, references to fragments, and links to the blocks
before, after and around it."""
import html

from pygments.token import STANDARD_TYPES, Token

from fragments import REFERENCE
from identifiers import key_of, placed_tokens_of

TYPES = {"vec2", "vec3", "spectrum", "uint", "uchar", "ushort", "ulong", "float2", "float4", "float8", "uint8", "int8", "size_t", "__global", "__constant",
         "__kernel", "FN", "SHARED_FN", "const", "inline", "static"}


class Listings:
    """HTML of the blocks of a book. number_of: key of a block -> its number, as "4.12"."""

    def __init__(self, book, index, chapter_of):
        self.book, self.index, self.number_of = book, index, {}
        counts = {}
        for definition in book.definitions:
            chapter = chapter_of[definition.page.stem]
            counts[chapter] = counts.get(chapter, 0) + 1
            self.number_of[key_of(definition)] = f"{chapter}.{counts[chapter]}"

    def link(self, definition, text, css="fragment"):
        return f'<a class="{css}" href="{self.address(key_of(definition))}">{text}</a>'

    def address(self, key):
        return f"{key[0]}.html#f-{self.number_of[key]}"

    def reference(self, name):
        return self.link(self.book.fragments[name][0], f'⟨{html.escape(name)} <span class="number">{self.number_of[key_of(self.book.fragments[name][0])]}</span>⟩')

    def identifier(self, name, text, here):
        """The text of an identifier (or of None), linked to where it is defined unless that is here."""
        places = self.index.defined.get(name, [])
        if not places or any(key_of(place.definition) == here for place in places):
            return html.escape(text)
        return f'<a class="id" href="{self.address(key_of(places[0].definition))}">{html.escape(text)}</a>'

    def code(self, definition):
        """Its lines. Tokens may span lines (comments), references stand between them."""
        here, texts, at = key_of(definition), [], 0
        for kind, value, line, column in placed_tokens_of(definition.lines):
            css = STANDARD_TYPES.get(Token.Keyword.Type if value in TYPES else kind, "")
            name = self.index.name_at(definition, kind, value, line, column)
            for part_number, part in enumerate(value.split("\n")):
                if part_number:
                    at = self._end_line(texts, definition, at)
                if part:
                    text = self.identifier(name, part, here)
                    texts.append(f'<span class="{css}">{text}</span>' if css else text)
        self._end_line(texts, definition, at)
        return "".join(texts).strip("\n")

    def _end_line(self, texts, definition, line):
        if line < len(definition.lines) and (reference := REFERENCE.match(definition.lines[line])):
            texts.append(reference["indent"] + self.reference(reference["name"]))
        texts.append("\n")
        return line + 1

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
        anchor = f' id="file-{definition.name.replace("/", "-").replace(".", "-")}"' if definition.is_file and not at else ""
        return (f'<div class="listing" id="f-{number}"><div{anchor} class="title">⟨{name} <span class="number">{number}</span>⟩{sign}'
                f'</div>{self.margin(key)}<pre tabindex="0">{self.code(definition)}</pre><div class="notes">{" · ".join(notes)}</div></div>')

    def margin(self, key):
        """The margin index: identifiers that the block defines, with the blocks that use them."""
        rows = []
        for name in dict.fromkeys(identifier.name for identifier in self.index.of_block[key]):
            uses = self.uses(name, 6)
            rows.append(f'<dt>{html.escape(name)}</dt><dd>{uses or "no uses"}</dd>')
        return f'<aside class="margin" aria-label="identifiers defined here, and their uses"><dl>{"".join(rows)}</dl></aside>' if rows else ""

    def uses(self, name, most=None):
        keys = self.index.used.get(name, [])
        links = [f'<a href="{self.address(key)}">{self.number_of[key]}</a>' for key in keys[:most]]
        more = f' <a href="index-of-identifiers.html#i-{html.escape(name)}">and {len(keys) - most} more</a>' if most and len(keys) > most else ""
        return " ".join(links) + more
