"""The identifiers that the book's code defines, and where they are defined and used.

Universal Ctags parses the tangled files (C with the macros of kernels/math/portable.clh left out); an identifier is used where a fragment has it
as a token outside comments and strings. Names of parameters, local variables and members are not indexed: one letter means too many things.
"""
import json
import re
import subprocess
import tempfile
from collections import defaultdict, namedtuple
from pathlib import Path

from pygments.lexers.c_cpp import CppLexer
from pygments.token import Token

from fragments import REFERENCE, text_of

# kind: function, macro, struct ...; definition: the block of the book that holds its line
Identifier = namedtuple("Identifier", "name kind definition number")

KINDS = {"function", "prototype", "macro", "struct", "typedef", "enum", "enumerator", "union", "class"}
# Words before a declaration that are macros of ours: to ctags they are nothing.
IGNORED_MACROS = ("FN", "SHARED_FN", "__global", "__constant", "__local", "__kernel")


def ctags_of(folder, paths):
    """(path, line, name, kind) of each definition in files of a folder."""
    command = ["ctags", "--output-format=json", "--fields=+n", "--langmap=C:.c.cl.clh,C++:.cpp.h", "--kinds-C=+p", "-I", ",".join(IGNORED_MACROS), "-o", "-", *paths]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    for line in result.stdout.splitlines():
        tag = json.loads(line)
        if tag.get("kind") in KINDS and not tag["name"].startswith("__anon"):
            yield tag["path"], tag["line"], tag["name"], tag["kind"]


class Index:
    """defined: name -> Identifiers; of_block: key of a block -> Identifiers; used: name -> keys of blocks, in the order of the book."""

    def __init__(self, book):
        self.defined, self.of_block, self.used = defaultdict(list), defaultdict(list), defaultdict(list)
        with tempfile.TemporaryDirectory() as folder:
            tangled = {path: book.tangle(path) for path in book.files}
            for path, lines in tangled.items():
                file = Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text_of(lines), encoding="utf-8")
            for path, number, name, kind in ctags_of(folder, sorted(tangled)):
                place = tangled[path][number - 1]
                identifier = Identifier(name, kind, place.definition, place.number)
                if identifier not in self.defined[name]:
                    self.defined[name].append(identifier)
                    self.of_block[key_of(place.definition)].append(identifier)
        for definition in book.definitions:
            names = [value for kind, value in tokens_of(definition.lines) if is_identifier(kind) and value in self.defined]
            here = [identifier.name for identifier in self.of_block[key_of(definition)]]
            for name in sorted(set(names)):
                if names.count(name) > here.count(name):
                    self.used[name].append(key_of(definition))


def is_identifier(kind):
    return kind in Token.Name and kind is not Token.Name.Attribute


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
