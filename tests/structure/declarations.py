"""The names that a header of ours declares, read without a compiler: good enough to find includes of which a file uses nothing.

Follows the project's own style: one declaration a statement, macros in capitals. What it does not understand, it does not declare.
"""
import re
from functools import cache

TOKEN = re.compile(r'[A-Za-z_]\w*|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|::|->|\d[\w.]*|\S')
NAME = re.compile(r"[A-Za-z_]\w*$")
TYPES = {"struct", "class", "union"}


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.DOTALL)


@cache
def text_of(file):
    return re.sub(r"\\\n", " ", without_comments(file.read_text(encoding="utf-8")))


def is_macro(name):
    return name.isupper() and len(name) > 1


class Macros:
    """The macros of all headers that make names of their arguments: #define NAME_OF(x) x##_words."""

    def __init__(self, files):
        self.definitions = {}    # name: [(file, parameters, body)]
        for file in files:
            for name, parameters, body in re.findall(r"^\s*#\s*define (\w+)(?:\(([^)]*)\))?(.*)", text_of(file), re.MULTILINE):
                self.definitions.setdefault(name, []).append((file, [p.strip() for p in parameters.split(",") if p.strip()], body))

    def seen_from(self, name, file):
        """Definitions of a name: those of the file itself, if it has any."""
        every = self.definitions.get(name, [])
        return [d for d in every if d[0] == file] or every

    @cache
    def affixes(self, name, file):
        """(before, after) of every name that the macro, or one that it calls, pastes together."""
        found = set()
        for _, parameters, body in self.seen_from(name, file):
            for pasted in re.findall(r"\w+(?:\s*##\s*\w+)+", body):
                parts = re.split(r"\s*##\s*", pasted)
                at = next((i for i, part in enumerate(parts) if part in parameters), None)
                if at is not None:
                    found.add(("".join(parts[:at]), "".join(parts[at + 1:])))
            for other in set(re.findall(r"\b[A-Z]\w+(?=\s*\()", body)) - {name}:
                found |= self.affixes(other, file)
        return frozenset(found)

    @cache
    def entries(self, name):
        """The kinds of a list: #define LIGHTS(L) L(point, ...) L(spot, ...)."""
        return frozenset(kind for _, parameters, body in self.definitions.get(name, []) if len(parameters) == 1
                         for kind in re.findall(rf"\b{re.escape(parameters[0])}\(\s*(\w+)", body))

    def made_by(self, name, arguments, file):
        """The names that a call in the file declares: of a macro that pastes, or of a list that is handed one."""
        made = {before + a + after for before, after in self.affixes(name, file) for a in arguments}
        for macro in arguments:
            made |= {before + kind + after for before, after in self.affixes(macro, file) for kind in self.entries(name)}
        return made


def skip(tokens, i, opening, closing):
    """The index behind the bracket that closes the one at i."""
    depth = 0
    while i < len(tokens):
        depth += (tokens[i] == opening) - (tokens[i] == closing)
        i += 1
        if depth == 0:
            return i
    return i


def without_arguments(text):
    """Without what templates are given."""
    while (inner := re.sub(r"<[^<>]*>", "", text)) != text:
        text = inner
    return text


def declared(header, macros):
    """(names that stand alone, names of members) that a header declares."""
    text = text_of(header)
    guard = re.search(r"#ifndef (\w+)\s*\n\s*#define \1\b", text)
    alone = set(re.findall(r"^\s*#\s*define (\w+)", text, re.MULTILINE)) - ({guard[1]} if guard else set())
    members = set()
    tokens = TOKEN.findall(re.sub(r"^\s*#[^\n]*", " ", text, flags=re.MULTILINE))
    scopes, statement, i = [], [], 0     # of each open brace: "namespace", "type" or "enum"

    def declare(name):
        if NAME.match(name):
            (members if "type" in scopes else alone).add(name)

    def end_statement():
        """Declares the variables of `type a, b[2] = ...` and the like."""
        if statement[:1] == ["using"] and "=" in statement:
            declare(statement[1])
        elif statement[:1] in (["friend"], ["enum"]) or (statement[:1] and statement[0] in TYPES and len(statement) == 2):
            pass                         # of something else, or a forward declaration
        elif "(" not in statement:
            words = re.sub(r"=[^,;]*|\{[^}]*\}", "", without_arguments(" ".join(statement))).split() + [";"]
            for at, token in enumerate(words[1:-1], 1):
                if words[at + 1] in (";", ",", "[", ":"):
                    declare(token)
        statement.clear()

    while i < len(tokens):
        token = tokens[i]
        if token == "template" and tokens[i + 1] == "<":
            i = skip(tokens, i + 1, "<", ">")
            continue
        if scopes[-1:] == ["enum"]:
            # enumerators: a name, then what is up to the next comma; or a list of them
            if token == "}":
                scopes.pop()
            elif NAME.match(token) and tokens[i + 1] == "(":
                end = skip(tokens, i + 1, "(", ")")
                alone.update(macros.made_by(token, tokens[i + 2:end - 1], header))
                i = end
                continue
            elif NAME.match(token):
                declare(token)
                while tokens[i + 1] not in (",", "}"):
                    i += 1
        elif token == "(":
            end = skip(tokens, i, "(", ")")
            name = statement[-1] if statement else ""
            if is_macro(name):
                alone.update(macros.made_by(name, [t for t in tokens[i + 1:end - 1] if NAME.match(t)], header))
                if len(statement) == 1 and tokens[end:end + 1] != [";"]:
                    statement.clear()    # a call that is a declaration by itself
            elif tokens[i + 1] == "*" and statement:
                declare(tokens[i + 2])   # a pointer to a function
                statement.append("(")
            elif len(statement) > 1 and "(" not in statement and not name.startswith("__"):
                declare(name)
                statement.append("(")
            i = end
            continue
        elif token == "{":
            opened = "namespace" if "namespace" in statement or statement[:2] == ["extern", '"C"'] else \
                     "enum" if "enum" in statement else "type" if TYPES & set(statement) and "(" not in statement else None
            if opened is None:           # the body of a function, or a value
                i = skip(tokens, i, "{", "}")
                if "(" in statement and tokens[i:i + 1] != [";"]:
                    statement.clear()
                continue
            names = [t for t in statement if NAME.match(t) and t not in TYPES | {"enum", "typedef", "namespace", "inline", "extern"}]
            if opened != "namespace" and names:
                declare(names[0])
            scoped = opened == "enum" and TYPES & set(statement)
            statement.clear()
            if scoped:                   # its enumerators cannot be used without its name
                i = skip(tokens, i, "{", "}")
                continue
            scopes.append(opened)
        elif token == "}":
            if scopes and scopes.pop() == "type":
                statement.append("}")    # `typedef struct { ... } name;`, `struct { ... } a, b;`
            else:
                statement.clear()
        elif token == ";":
            end_statement()
        elif token in ("public", "private", "protected") and tokens[i + 1] == ":":
            i += 1
        elif statement or not is_macro(token) or tokens[i + 1:i + 2] == ["("]:   # else one such as CONTRACT_BEGIN
            statement.append(token)
        i += 1
    return alone, members
