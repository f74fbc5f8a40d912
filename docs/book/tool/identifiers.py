"""The identifiers that the book's code defines, and where they are defined and used.

Of the scheduler and of the contract between host and device, libclang says what is defined (clang_index.py), and of the scheduler what each
name refers to. The kernels are parsed by Universal Ctags (C with the macros of kernels/math/portable.clh left out); there and in the contract's
macros, an identifier is used where a fragment has it as a token outside comments and strings. Names of parameters, of local variables and of
the members of kernels' structs are not indexed: one letter means too many things.
"""
import json
import re
import subprocess
import tempfile
from collections import Counter, defaultdict, namedtuple
from pathlib import Path

from pygments.lexers.c_cpp import CppLexer
from pygments.token import Token

from clang_index import Parser
from fragments import REFERENCE, text_of

# kind: function, macro, struct ...; definition: the block of the book that holds its line
Identifier = namedtuple("Identifier", "name kind definition number")

KINDS = {"function", "prototype", "macro", "struct", "typedef", "enum", "enumerator", "union", "class"}
# Words before a declaration that are macros of ours: to ctags they are nothing.
IGNORED_MACROS = ("FN", "SHARED_FN", "__global", "__constant", "__local", "__kernel")


def ctags_of(folder, paths):
    """(path, line, name, kind) of each definition in files of a folder."""
    command = ["ctags", "--output-format=json", "--fields=+n", "--langmap=C:.cl.clh", "--kinds-C=+p", "-I", ",".join(IGNORED_MACROS), "-o", "-", *paths]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    for line in result.stdout.splitlines():
        tag = json.loads(line)
        if tag.get("kind") in KINDS and not tag["name"].startswith("__anon"):
            yield tag["path"], tag["line"], tag["name"], tag["kind"]


class Index:
    """defined: name -> Identifiers; of_block: key of a block -> Identifiers; used: name -> keys of blocks, in the order of the book."""

    def __init__(self, book):
        self.defined, self.of_block, self.used = defaultdict(list), defaultdict(list), defaultdict(list)
        tangled = {path: book.tangle(path) for path in book.files}
        texts = {path: text_of(lines) for path, lines in tangled.items()}
        self.file_of = {(line.definition.page.stem, line.number): (path, number, len(line.indent))
                        for path, lines in tangled.items() for number, line in enumerate(lines, 1) if not line.is_title}
        parsed = Parser({path: text for path, text in texts.items() if not path.startswith("kernels/")})
        self.referred = {(path, line, column): name for path, line, column, name in parsed.referred}
        definitions = [(path, line, name, kind) for path, line, _, name, kind in sorted(parsed.defined)]
        with tempfile.TemporaryDirectory() as folder:
            kernels = sorted(path for path in texts if path.startswith("kernels/"))
            for path in kernels:
                file = Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(texts[path], encoding="utf-8")
            definitions += ctags_of(folder, kernels)
        for path, number, name, kind in definitions:
            place = tangled[path][number - 1]
            identifier = Identifier(name, kind, place.definition, place.number)
            if identifier not in self.defined[name]:
                self.defined[name].append(identifier)
                self.of_block[key_of(place.definition)].append(identifier)
        for places in self.defined.values():
            places.sort(key=lambda place: place.kind == "declaration")
        for definition in book.definitions:
            key = key_of(definition)
            # A definition is also a token of its name, but no reference
            found = Counter({identifier.name: -1 for identifier in self.of_block[key] if not self._is_parsed(definition, identifier.number - definition.first_line)})
            found.update(name for token in placed_tokens_of(definition.lines) if (name := self.name_at(definition, *token)))
            for name in sorted(name for name, count in found.items() if count > 0):
                self.used[name].append(key)

    def _is_parsed(self, definition, line):
        return self.file_of.get((definition.page.stem, definition.first_line + line), ("",))[0].startswith("host/")

    def name_at(self, definition, kind, token, line, column):
        """The identifier that a token of a block refers to, or None; line and column in the block, from 0."""
        if kind not in Token.Name:
            return None
        if self._is_parsed(definition, line):
            path, number, indent = self.file_of[definition.page.stem, definition.first_line + line]
            return self.referred.get((path, number, indent + column + 1))
        return token if kind is not Token.Name.Attribute and token in self.defined else None


def key_of(definition):
    """What names a block of the book: its page and the line of its fence."""
    return definition.page.stem, definition.first_line - 1


def tokens_of(lines):
    """The tokens (kind, text) of lines of code; references to fragments are left out. Members, after . or ->, are Token.Name.Attribute."""
    text = "\n".join("" if REFERENCE.match(line) else line for line in lines)
    before = ""
    for kind, value in CppLexer(stripnl=False, ensurenl=False).get_tokens(text):
        if kind is Token.Comment.Preproc:  # Pygments has a macro's definition as one token
            for part in re.split(r"(\w+)", value):
                if part:
                    yield (Token.Name.Macro if re.match(r"[A-Za-z_]", part) and part != "define" else kind), part
        elif kind in Token.Name and before.endswith((".", "->")):
            yield Token.Name.Attribute, value
        else:
            yield kind, value
        before = (before + value)[-2:] if value.strip() else ""


def placed_tokens_of(lines):
    """The tokens with the line and column where they begin, from 0."""
    line = column = 0
    for kind, value in tokens_of(lines):
        yield kind, value, line, column
        if "\n" in value:
            line, column = line + value.count("\n"), len(value) - value.rindex("\n") - 1
        else:
            column += len(value)
