"""The identifiers that the book's code defines, and where they are defined and used.

Of the scheduler and of the contract between host and device, libclang says what is defined (clang_index.py), and of the scheduler what each
name refers to. The kernels are parsed by Universal Ctags (C with the macros of kernels/math/portable.clh left out); there and in the contract's
macros, an identifier is used where a fragment has it as a token outside comments and strings. What lists and macros make is found by
macro_lists.py: it is used where the code has its name, or where a macro joins it.

Members of the kernels' and the contract's structs, with the fields of queues, are indexed by their name alone, as ".t_max": no parse tells there
which struct an expression has. Names of parameters, of local variables, and members of one letter are not indexed.
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
from fragments import REFERENCE, ROOT, text_of
from macro_lists import MacroLists

# kind: function, macro, struct ...; definition: the block of the book that holds its line
Identifier = namedtuple("Identifier", "name kind definition number")

KINDS = {"function", "member", "prototype", "macro", "struct", "typedef", "enum", "enumerator", "union", "class"}
# Words before a declaration that are macros of ours: to ctags they are nothing.
IGNORED_MACROS = ("FN", "SHARED_FN", "__global", "__constant", "__local", "__kernel")


def ctags_of(folder, paths):
    """(path, line, name, kind) of each definition in files of a folder."""
    command = ["ctags", "--output-format=json", "--fields=+n", "--langmap=C:.cl.clh", "--kinds-C=+p", "-I", ",".join(IGNORED_MACROS), "-o", "-", *paths]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    for line in result.stdout.splitlines():
        tag = json.loads(line)
        if tag.get("kind") in KINDS and not tag["name"].startswith("__anon"):
            yield tag["path"], tag["line"], member_name(tag["name"]) if tag["kind"] == "member" else tag["name"], tag["kind"]


def words_of_host():
    """The words of the host's code and of the tests, which use what the book defines."""
    files = (file for folder in ("host", "tests") for file in (ROOT / folder).rglob("*") if file.suffix in (".cpp", ".h"))
    return {word for file in files for word in re.findall(r"\w+", file.read_text(encoding="utf-8"))}


class Index:
    """defined: name -> Identifiers; of_block: key of a block -> Identifiers; used: name -> keys of blocks, in the order of the book; host_words: what
    host/ and the tests have."""

    def __init__(self, book):
        self.defined, self.of_block, self.used = defaultdict(list), defaultdict(list), defaultdict(list)
        tangled = {path: book.tangle(path) for path in book.files}
        texts = {path: text_of(lines) for path, lines in tangled.items()}
        self.file_of = {(line.definition.page.stem, line.number): (path, number, len(line.indent))
                        for path, lines in tangled.items() for number, line in enumerate(lines, 1) if not line.is_title}
        parsed = Parser({path: text for path, text in texts.items() if not path.startswith("kernels/")})
        self.host_words = words_of_host()
        self.lists = MacroLists({path: text for path, text in texts.items() if not path.startswith("host/")})
        self.referred = {(path, line, column): name for path, line, column, name in parsed.referred}
        definitions = [(path, line, name, kind) for path, line, _, name, kind in sorted(parsed.defined)]
        with tempfile.TemporaryDirectory() as folder:
            kernels = sorted(path for path in texts if path.startswith("kernels/"))
            for path in kernels:
                file = Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(texts[path], encoding="utf-8")
            # STAGE(name, ...) { is a function called STAGE to ctags
            definitions += [tag for tag in ctags_of(folder, kernels) if tag[3] == "macro" or tag[2] not in self.lists.macros]
        definitions += [(path, line, name, "kernel") for name, path, line in self.lists.kernels()]
        for path, number, name, kind in definitions:
            if not (name.startswith(".") and (len(name) < 3 or name.isupper())):
                self._define(name, kind, tangled[path][number - 1])
        self.joined = defaultdict(set)  # key of a block -> names that its macros make
        self._define_made(book, tangled)
        for places in self.defined.values():
            places.sort(key=lambda place: place.kind == "declaration")
        for definition in book.definitions:
            key = key_of(definition)
            # A definition is also a token of its name, but no reference
            found = Counter({identifier.name: -1 for identifier in self.of_block[key] if not self._is_parsed(definition, identifier.number - definition.first_line)})
            found.update({name: 1 for name in self.joined[key]})
            found.update(name for token in placed_tokens_of(definition.lines) if (name := self.name_at(definition, *token)))
            for name in sorted(name for name, count in found.items() if count > 0):
                self.used[name].append(key)

    def _define(self, name, kind, place, in_block=True):
        identifier = Identifier(name, kind, place.definition, place.number)
        if identifier not in self.defined[name]:
            self.defined[name].append(identifier)
            if in_block:
                self.of_block[key_of(place.definition)].append(identifier)

    def _define_made(self, book, tangled):
        """Defines what lists and macros make and the code uses, and notes what the code defines and macros use."""
        tokens = {(kind is Token.Name.Attribute, value) for definition in book.definitions for kind, value in tokens_of(definition.lines) if kind in Token.Name}
        for name, row in self.lists.fields():
            if len(name) > 1 and (True, name) in tokens:
                self._define(member_name(name), "field", tangled[row.path][row.line - 1])
        for name in sorted({value for is_member, value in tokens if not is_member} | set(self.defined)):
            ways = self.lists.made(name)
            if ways and name not in self.defined:
                row, pattern = ways[0]
                self._define(name, "from the list", tangled[row.path][row.line - 1])
                self._define(name, "made by the macro", tangled[pattern.path][pattern.line - 1], in_block=False)
            for _, pattern in ways:
                self.joined[key_of(tangled[pattern.path][pattern.line - 1].definition)].add(name)

    def _is_parsed(self, definition, line):
        return self.file_of.get((definition.page.stem, definition.first_line + line), ("",))[0].startswith("host/")

    def name_at(self, definition, kind, token, line, column):
        """The identifier that a token of a block refers to, or None; line and column in the block, from 0."""
        if kind not in Token.Name:
            return None
        if self._is_parsed(definition, line):
            path, number, indent = self.file_of[definition.page.stem, definition.first_line + line]
            return self.referred.get((path, number, indent + column + 1))
        name = member_name(token) if kind is Token.Name.Attribute else token
        return name if name in self.defined else None


def member_name(name):
    """What a member of a struct is called in the index."""
    return f".{name}"


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
