#!/usr/bin/env python3
"""Weaves a small book in a temporary folder: a page that is right is woven without a word, and each mistake is named.

Exits with 77, skipped, without the tools that weave.
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

WEAVE = Path(__file__).resolve().parents[2] / "docs" / "book" / "tool" / "weave.py"

CHAPTER = """# Light

## Falling off

It falls off [@kajiya1986], as the [figure](#fig:lamp) and the [drawing](figures/drawn.svg) show, [here](#falling-off) and
[in the notes](a-01-light.md#more), in [a file](SOURCE).

![A lamp](figures/lamp.png){#fig:lamp}

![A curve](figures/curve.svg)

![A drawing](figures/drawn.svg)

```opencl kernels/light/spot.clh =
FN float eval_spot(float cosine) {
    /* <<Fall off>> */
}
```

```opencl <<Fall off>> =
return cosine;
```
"""
FILES = {"a-01-light.md": "# More light\n\n## More\n\nMore.\n",
         "references.bib": "@book{kajiya1986, author = {James T. Kajiya}, title = {The Rendering Equation}, year = {1986}}\n",
         "figures/lamp.pbrt": "WorldBegin\n", "figures/lamp.png": "", "figures/curve.py": "", "figures/curve.svg": "<svg></svg>\n",
         "figures/drawn.svg": "<!-- drawn by hand -->\n<svg></svg>\n"}


class BookWeave(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.book = Path(folder.name)
        (self.book / "figures").mkdir()
        self.chapter = CHAPTER.replace("SOURCE", str(WEAVE))
        (self.book / "01-light.md").write_text(self.chapter)
        for name, text in FILES.items():
            (self.book / name).write_text(text)

    def weave(self):
        result = subprocess.run(["/usr/bin/python3", WEAVE, "--check", "--book", self.book], capture_output=True, text=True)
        return result.returncode, result.stderr

    def test_a_book_without_mistakes(self):
        self.assertEqual(self.weave(), (0, ""))

    def expect(self, message, old, new):
        self.assertEqual(self.chapter.count(old), 1)
        (self.book / "01-light.md").write_text(self.chapter.replace(old, new))
        self.assertEqual(self.weave(), (1, message + "\n"))

    def test_a_link_to_no_heading(self):
        self.expect("01-light.html: #rising leads to no place of the page", "(#falling-off)", "(#rising)")

    def test_a_link_to_no_heading_of_another_page(self):
        self.expect("01-light.html: a-01-light.html#less leads to no place of the page", "a-01-light.md#more", "a-01-light.md#less")

    def test_a_link_to_no_file(self):
        self.expect("01-light.html: a-02-light.md#more leads to no file", "a-01-light.md#more", "a-02-light.md#more")

    def test_a_reference_to_no_figure(self):
        self.expect("01-light.html: #fig:torch leads to no place of the page", "(#fig:lamp)", "(#fig:torch)")

    def test_an_unknown_citation(self):
        self.expect("01-light.md: [WARNING] Citeproc: citation kajiya1987 not found\n"
                    "01-light.html: references.html#ref-kajiya1987 leads to no place of the page", "[@kajiya1986]", "[@kajiya1987]")

    def test_missing_files_of_figures(self):
        for name, message in (("lamp.png", "figures/lamp.png: 01-light.md shows it, but there is no such file"),
                              ("lamp.pbrt", "figures/lamp.png: the scene that makes it, lamp.pbrt, is missing"),
                              ("curve.py", "figures/curve.svg: the script that makes it, curve.py, is missing; a drawing has <!-- drawn by hand --> instead")):
            (self.book / "figures" / name).rename(self.book / "kept")
            status, errors = self.weave()
            (self.book / "kept").rename(self.book / "figures" / name)
            self.assertEqual(status, 1)
            self.assertIn(message + "\n", errors)

    def test_a_figure_that_no_page_shows(self):
        (self.book / "figures" / "torch.pbrt").touch()
        self.assertEqual(self.weave(), (1, "figures/torch.pbrt: no page shows it\n"))


if __name__ == "__main__":
    if subprocess.run(["/usr/bin/python3", WEAVE, "--help"], stdout=subprocess.DEVNULL).returncode == 77:
        sys.exit(77)
    unittest.main()
