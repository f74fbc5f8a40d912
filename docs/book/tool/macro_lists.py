"""Names that macros make: from lists such as QUEUES(Q), whose rows are Q(hit, HIT_FIELDS, ...), and from macros that join words, such as
q##_item. With these, hit_item is defined by the list's row, and sample_implicit_light is used where sample_##name##_light stands."""
import re
from collections import defaultdict, namedtuple

# A macro's definition, its continuation lines joined by newlines; params is None for a macro without parentheses
Macro = namedtuple("Macro", "name params body path line")
Row = namedtuple("Row", "words path line")      # words: the arguments that are names, in order
Pattern = namedtuple("Pattern", "regex macro path line")

DEFINE = re.compile(r"^#define (\w+)(?:\(([\w, ]*)\))?[ \t]*((?:[^\n]*\\\n)*[^\n]*)", re.MULTILINE)
JOINED = re.compile(r"\w+(?:[ ]*##[ ]*\w+)+")
JOIN_CALL = re.compile(r"\bJOIN\((\w+), (\w+)\)")
NAME = re.compile(r"[A-Za-z_]\w*$")


def without_comments(text):
    """The text with blanks for comments, line for line."""
    return re.sub(r"/\*.*?\*/|//[^\n]*", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.DOTALL)


def arguments(text, start):
    """The arguments of a call whose opening parenthesis is text[start - 1]."""
    depth, at, found = 0, start, []
    for end in range(start, len(text)):
        if text[end] in "([{":
            depth += 1
        elif text[end] in ")]}" and depth:
            depth -= 1
        elif text[end] in ",)" and not depth:
            found.append(text[at:end].strip(" \\\n"))
            at = end + 1
            if text[end] == ")":
                break
    return found


def regex_of(joined, params):
    """What words joined by ## can make, a group for each parameter; None without a word that is no parameter."""
    parts = re.split(r" *## *", joined)
    if not any("_" in part for part in parts if part not in (params or [])):
        return None
    return re.compile("".join(r"(\w+?)" if part in (params or []) else re.escape(part) for part in parts))


class MacroLists:
    """made(name): the row and the pattern that make a name, or None."""

    def __init__(self, texts):
        """texts: path -> text of the kernels and the contract."""
        self.texts = {path: without_comments(text) for path, text in texts.items()}
        self.macros = defaultdict(list)
        for path, text in self.texts.items():
            for match in DEFINE.finditer(text):
                params = None if match[2] is None else [word.strip() for word in match[2].split(",")]
                self.macros[match[1]].append(Macro(match[1], params, match[3], path, text.count("\n", 0, match.start()) + 1))
        self.rows = {name: [row for macro in macros for row in self._rows(macro)] for name, macros in self.macros.items()}
        self.words = defaultdict(dict)  # macro -> word -> the row that the macro gets it from, or the place of a call
        self.row_of = {row.words[0]: row for rows in self.rows.values() for row in rows if row.words[0].isupper()}  # of features
        for path, text in self.texts.items():
            for match in re.finditer(r"\b(\w+)\(", text):
                if match[1] in self.macros:
                    self._note_call(match[1], arguments(text, match.end()), path, text.count("\n", 0, match.start()) + 1)
        self.patterns = [pattern for macros in self.macros.values() for macro in macros for pattern in self._patterns(macro)]
        self.patterns += [pattern for path, text in self.texts.items() for pattern in self._joins(path, text)]

    def _rows(self, macro):
        if not macro.params or not re.fullmatch(r"[A-Z]", macro.params[0]):
            return
        for match in re.finditer(rf"\b{macro.params[0]}\(", macro.body):
            words = [word for word in arguments(macro.body, match.end()) if NAME.match(word) and word not in macro.params]
            if words:
                yield Row(words, macro.path, macro.line + macro.body.count("\n", 0, match.start()))

    def _all_rows(self, name, seen):
        """Rows of a list and of the lists that it contains or names."""
        if name in seen or name not in self.macros:
            return
        seen.add(name)
        yield from self.rows[name]
        inner = [word for row in self.rows[name] for word in row.words]
        inner += [word for macro in self.macros[name] for word in re.findall(r"\b(\w+)\([A-Z]\b", macro.body)]
        for word in inner:
            yield from self._all_rows(word, seen)

    def _reach(self, name, seen):
        """The macro and those that its body mentions."""
        if name in self.macros and name not in seen:
            seen.add(name)
            for macro in self.macros[name]:
                for word in re.findall(r"\w+", macro.body):
                    self._reach(word, seen)
                for joined in JOINED.findall(macro.body):  # PDF_OF_##PLACE: any of these
                    regex = regex_of(joined, macro.params)
                    for other in self.macros if regex else ():
                        if regex.fullmatch(other):
                            self._reach(other, seen)
        return seen

    def _note_call(self, name, given, path, line):
        """LIST(MACRO, ...): MACRO and what it calls get the list's words. Otherwise the macro gets the words of the call."""
        if self.rows[name] or any(macro.params and re.fullmatch("[A-Z]", macro.params[0]) for macro in self.macros[name]):
            for argument in given:
                for macro in self._reach(argument, set()):
                    for row in self._all_rows(name, set()):
                        for at, word in enumerate(row.words):
                            if at == 0 or word not in self.words[macro]:
                                self.words[macro][word] = row
        else:
            for macro in self._reach(name, set()):
                for word in given:
                    if NAME.match(word):
                        self.words[macro].setdefault(word, Row([], path, line))
                    for row in self._all_rows(word, set()):  # DEFINE_ITEM(x, FIELDS)
                        for field in row.words:
                            self.words[macro].setdefault(field, row)

    def _patterns(self, macro):
        for match in JOINED.finditer(macro.body):
            if regex := regex_of(match[0], macro.params):
                yield Pattern(regex, macro.name, macro.path, macro.line + macro.body.count("\n", 0, match.start()))

    def _joins(self, path, text):
        """JOIN(eval_, BSDF): BSDF, a macro that the host defines, is one of BSDFS."""
        for match in JOIN_CALL.finditer(text):
            for hole in set(match.groups()) - set(self.macros):
                if hole.isupper() and f"{hole}S" in self.rows:
                    self.words[hole] = {row.words[0]: row for row in self.rows[f"{hole}S"]}
                    regex = "".join(r"(\w+)" if part == hole else re.escape(part) for part in match.groups())
                    yield Pattern(re.compile(regex), hole, path, text.count("\n", 0, match.start()) + 1)

    def made(self, name):
        """(Row, Pattern) of each way in which macros make the name, those from lists first. The row of a word that only calls give has no words."""
        ways = []
        for pattern in self.patterns:
            if (match := pattern.regex.fullmatch(name)) and all(word in self.words[pattern.macro] for word in match.groups()):
                rows = [self.words[pattern.macro][word] for word in match.groups()]
                feature = self.row_of.get(name.removeprefix("HAS_"))
                ways.append((feature or next((row for row in rows if row.words), rows[0]), pattern))
        return sorted(ways, key=lambda way: not way[0].words)

    def fields(self):
        """(name, Row) of each word of a list that may be a member's name."""
        for rows in self.rows.values():
            for row in rows:
                for word in row.words:
                    if not word.isupper():
                        yield word, row

    def kernels(self):
        """(name, path, line) of each stage, STAGE(name, ...)."""
        for path, text in self.texts.items():
            for match in re.finditer(r"^\w*STAGE\((\w+),", text, re.MULTILINE):
                yield match[1], path, text.count("\n", 0, match.start()) + 1
