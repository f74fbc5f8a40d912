"""Tables in the pages of docs/ that a script makes."""


def put(page, begin, text, end, only_print=False):
    """Replaces what stands between the marks `begin` and `end` of a page by `text`. only_print: prints the text instead."""
    if only_print:
        print(text, end="")
        return
    head, rest = page.read_text().split(begin)
    page.write_text(head + begin + text + end + rest.split(end)[1])
