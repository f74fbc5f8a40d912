"""The worked examples of the book: code that is not part of the program, in plain fenced blocks whose info strings say where it would go:

    ```opencl example kernels/bsdf/x.clh                               a whole new file
    ```opencl example include/eikonal/bsdfs.h after `text of a line`   lines to insert after the first line that contains the text

tests/structure/book_example.py puts them there, builds the program and tries it.
"""
import re
from collections import namedtuple

EXAMPLE = re.compile(r"^```(?P<language>\w+) example (?P<path>[\w./-]+)(?: after `(?P<after>[^`]+)`)?$")

# after: None for a whole file. first_line: the number (from 1) of the line behind the fence.
Example = namedtuple("Example", "language path after first_line lines")


def examples_of(page):
    """The examples of one page, in order."""
    lines = page.read_text(encoding="utf-8").split("\n")
    found = []
    for number, line in enumerate(lines):
        if match := EXAMPLE.match(line):
            end = lines.index("```", number)
            found.append(Example(match["language"], match["path"], match["after"], number + 2, lines[number + 1:end]))
    return found
