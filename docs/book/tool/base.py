"""The states in which book and code were the same: from these, the tools tell who has changed what.

One is the book of the last commit. Another, newer one may be noted by remember() in the repository's git folder: the book after the last tangle or
stitch, if that has edits which are not committed.
"""
import io
import json
import subprocess
import tarfile

from fragments import Book, BookError


def git(folder, *arguments):
    """What git prints, or None if it fails: for example, because the folder is in no repository, or nothing is committed."""
    result = subprocess.run(["git", "-C", str(folder), *arguments], capture_output=True)
    return result.stdout if result.returncode == 0 else None


def committed(folder):
    """The pages of the last commit, path -> text; None without one."""
    archive = git(folder, "archive", "HEAD", "--", "*.md")
    if archive is None:
        return None
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        texts = {folder / member.name: files.extractfile(member).read().decode() for member in files if member.isfile()}
    # In the order of pages()
    return {page: texts[page] for page in sorted(texts, key=lambda page: (not page.name[0].isdigit(), page.name)) if "-" in page.name}


def note_of(folder):
    """Where remember() notes the book; None outside of repositories."""
    path = git(folder, "rev-parse", "--git-path", "book-base.json")
    return None if path is None else folder / path.decode().strip()


def remember(book, folder):
    """Notes that the code is what this book makes."""
    note, commit = note_of(folder), git(folder, "rev-parse", "HEAD")
    if note is None or commit is None:
        return
    if book.texts == committed(folder):
        note.unlink(missing_ok=True)
    else:
        note.write_text(json.dumps({"commit": commit.decode().strip(), "pages": {page.name: text for page, text in book.texts.items()}}), encoding="utf-8")


def bases(folder):
    """Books that the code was equal to, the newest first."""
    found, note, commit = [], note_of(folder), git(folder, "rev-parse", "HEAD")
    if note is not None and commit is not None and note.exists():
        noted = json.loads(note.read_text(encoding="utf-8"))
        if noted["commit"] == commit.decode().strip():
            found.append({folder / name: text for name, text in noted["pages"].items()})
    found.append(committed(folder))
    for texts in found:
        if texts:
            try:
                yield Book(texts)
            except BookError:
                pass  # a commit whose book was wrong is no base
