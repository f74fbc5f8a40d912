"""Takes edits of tangled files back into the book.

Each line of a tangled file has one place in the book, so a difference between a file and what the book makes of it is a difference of
these places: changed lines replace theirs, new ones follow the line above them (or precede the one below, if only its fragment is indented
deeply enough), and a changed title renames its fragment. The difference is taken from a base, a book in which pages and code were the same;
a fragment that only the code has changed since then is replaced in the pages as they are now.
"""
from difflib import SequenceMatcher

from fragments import REFERENCE, BookError


class Edits:
    """Lines to put in the place of others, by page."""

    def __init__(self):
        self.replaced = {}  # (page, number) -> the lines that take this line's place
        self.renamed = {}   # old name -> new name

    def replace(self, line, texts):
        self.replaced[line.page, line.number] = texts

    def insert(self, line, texts, after):
        """Puts texts after a line of the book, or before it."""
        key = (line.page, line.number)
        kept = self.replaced.get(key, [line.text[len(line.indent):] if line.text else ""] if not line.is_title else None)
        if kept is None:
            raise BookError(f"{line.page}:{line.number}: a title has no place for lines beside it")
        self.replaced[key] = kept + texts if after else texts + kept

    def applied(self, texts):
        """The pages (path -> text) with the edits."""
        return {page: self._applied(page, text.split("\n")) for page, text in texts.items()}

    def _applied(self, page, lines):
        changed = []
        for number, text in enumerate(lines, 1):
            for new in self.replaced.get((page, number), [text]):
                for old_name, name in self.renamed.items():
                    new = new.replace(f"<<{old_name}>>", f"<<{name}>>")
                changed.append(new)
        return "\n".join(changed)


def fits(line, texts):
    """Whether all texts can be lines of the fragment that line is in: whether they are indented as far."""
    return all(text.startswith(line.indent) or not text for text in texts)


def undent(line, texts, path):
    if not fits(line, texts):
        raise BookError(f"{path}: an edited line is indented less than its fragment, {line.page}:{line.number}: edit the book there, then tangle")
    return [text[len(line.indent):] if text else "" for text in texts]


def change(edits, old, new, path):
    """Replaces tangled lines `old` by texts `new`."""
    if len(old) == len(new):
        for line, text in zip(old, new):
            if line.is_title:
                rename(edits, line, text)
            else:
                edits.replace(line, undent(line, [text], path))
        return
    if any(line.is_title for line in old):
        raise BookError(f"{path}: the edit removes a fragment's title, {next(f'{l.page}:{l.number}' for l in old if l.is_title)}: edit the book there, then tangle")
    for line in old:
        edits.replace(line, [])
    if new:
        home = max((line for line in old if fits(line, new)), key=lambda line: len(line.indent), default=old[0])
        edits.replace(home, undent(home, new, path))


def rename(edits, line, text):
    was = REFERENCE.match(line.definition.lines[line.number - line.definition.first_line])
    prefix, suffix = line.indent + was["indent"] + was["open"], was["close"] or ""
    if not (text.startswith(prefix) and text.endswith(suffix)):
        raise BookError(f"{line.page}:{line.number}: the title of <<{was['name']}>> became something else: {text.strip()}")
    edits.renamed[was["name"]] = text[len(prefix):len(text) - len(suffix)]


def insert(edits, above, below, texts, path):
    """Puts new texts between two tangled lines, of which one may be None: into the fragment that is indented deepest, else the one above."""
    places = [place for place in ((above, True), (below, False)) if place[0] and not place[0].is_title and fits(place[0], texts)]
    if not places:
        raise BookError(f"{path}: new lines are indented less than the fragments beside them: edit the book, then tangle")
    line, after = max(places, key=lambda place: len(place[0].indent))
    edits.insert(line, undent(line, texts, path), after)


def stitch(book, path, texts, edits):
    """Notes what makes the book's lines of the file `path` equal to texts."""
    lines = book.tangle(path)
    matcher = SequenceMatcher(None, [line.text for line in lines], texts, autojunk=False)
    for kind, i, i_end, j, j_end in matcher.get_opcodes():
        if kind == "insert":
            insert(edits, lines[i - 1] if i else None, lines[i] if i < len(lines) else None, texts[j:j_end], path)
        elif kind != "equal":
            change(edits, lines[i:i_end], texts[j:j_end], path)


def merged(base, edited, book):
    """The pages of `book` with what `edited` changes of `base`; the two have the same blocks. Raises BookError where `book` changes the same block."""
    lines = {page: [[line] for line in text.split("\n")] for page, text in book.texts.items()}
    conflicts = []
    for was, new in zip(base.definitions, edited.definitions):
        if (was.name, was.lines) == (new.name, new.lines):
            continue
        parts, at = book.parts_of(was), base.parts_of(was).index(was)
        now = next((part for part in parts if part.lines == was.lines), parts[at] if at < len(parts) else None)
        if now is None:
            conflicts.append(f"{was.page}: <<{was.name}>> has an edit in the code, but the page no longer has this block")
        elif now.lines not in (was.lines, new.lines):
            conflicts.append(f"{now.page}:{now.first_line - 1}: <<{was.name}>> has one edit here and another in the code")
        else:
            place, fence = lines[now.page], now.first_line - 2
            place[fence] = [place[fence][0].replace(f"<<{was.name}>>", f"<<{new.name}>>")]
            place[fence + 1:fence + 1 + len(now.lines)] = [new.lines, *[[]] * (len(now.lines) - 1)] if now.lines else []
            if not now.lines:
                place[fence] += new.lines
    if conflicts:
        raise BookError("\n".join((*conflicts, "make the two the same, or choose one: ./dev stitch --force takes the code's, ./dev tangle --force the book's")))
    return {page: "\n".join(text for texts in place for text in texts) for page, place in lines.items()}
