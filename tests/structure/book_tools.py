#!/usr/bin/env python3
"""Tests the book's tools (docs/book/tool) on a small book in a temporary folder: what tangles, what is refused, and that edits of the code come
back into the book: the book then makes exactly the edited files."""
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(__file__).resolve().parents[2] / "docs" / "book" / "tool" / "tangle.py"
sys.path.insert(0, str(TOOL.parent))
from concepts import Concepts  # noqa: E402

CHAPTER = """# Light

```opencl kernels/light/spot.clh =
/* A spot light. */
FN float eval_spot(float cosine) {
    /* <<Fall off>> */
    <<Return the intensity>>
}
```

The light falls off between two angles.

```opencl <<Fall off>> =
float x = cosine;
if (x > 0.5f) {
    <<Clamp>>
}
```

```opencl <<Clamp>> =
x = 0.5f;
```

More of the end:

```opencl <<Return the intensity>> =

return x
```

```opencl <<Return the intensity>> +=
    * 2.0f;
```
"""
FILE = """/* A spot light. */
FN float eval_spot(float cosine) {
    /* Fall off */
    float x = cosine;
    if (x > 0.5f) {
        x = 0.5f;
    }

    return x
        * 2.0f;
}
"""


class BookTools(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.page = self.root / "docs" / "book" / "1-light.md"
        self.file = self.root / "kernels" / "light" / "spot.clh"
        self.page.parent.mkdir(parents=True)
        self.file.parent.mkdir(parents=True)
        self.page.write_text(CHAPTER)

    def run_tool(self, *options):
        return subprocess.run([sys.executable, TOOL, "--root", self.root, "--book", self.page.parent, *options], capture_output=True, text=True)

    def succeed(self, *options):
        result = self.run_tool(*options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def fail_with(self, text, *options):
        result = self.run_tool(*options)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn(text, result.stderr)

    def stitch(self, text):
        """Stitches the edited file; afterwards the book makes it."""
        self.file.write_text(text)
        self.succeed("--stitch")
        self.succeed("--check")
        self.file.unlink()
        self.succeed()
        self.assertEqual(self.file.read_text(), text)

    def test_tangles_and_finds_a_line_again(self):
        self.succeed()
        self.assertEqual(self.file.read_text(), FILE)
        place = self.succeed("--where", "kernels/light/spot.clh:6")
        number = CHAPTER.split("\n").index("x = 0.5f;") + 1
        self.assertIn(f"1-light.md:{number}: Clamp", place)

    def test_check_names_what_differs_and_what_no_fragment_holds(self):
        self.fail_with("spot.clh does not exist", "--check")
        self.succeed()
        self.file.write_text(FILE.replace("2.0f", "3.0f"))
        (self.root / "kernels" / "light" / "new.clh").write_text("float y;\n")
        self.fail_with("spot.clh differs from the book", "--check")
        self.fail_with("new.clh is in no chapter", "--check")

    def test_tangle_keeps_edits_that_are_not_committed(self):
        self.succeed()
        self.file.write_text(FILE.replace("2.0f", "3.0f"))
        self.fail_with("has edits that are not committed")
        self.assertIn("3.0f", self.file.read_text())
        self.succeed("--force")
        self.assertEqual(self.file.read_text(), FILE)

    def test_mistakes_of_the_book_are_named(self):
        for wrong, message in ((CHAPTER.replace("    <<Clamp>>\n", ""), "no fragment uses <<Clamp>>"),
                               (CHAPTER.replace("x = 0.5f;", "<<Clamp>>"), "used a second time"),
                               (CHAPTER.replace("x = 0.5f;", "<<Clip>>"), "<<Clip>> is not defined"),
                               (CHAPTER.replace("<<Return the intensity>> +=", "<<Return the intensity>> ="), "already defined"),
                               (CHAPTER.replace("<<Return the intensity>> =", "<<Return the intensity>> +="), "is not defined before this"),
                               (CHAPTER.replace("opencl <<Clamp>> =", "opencl <<Clamp> ="), "this fence defines nothing"),
                               (CHAPTER.removesuffix("```\n"), "this block has no end")):
            self.page.write_text(wrong)
            self.fail_with(message, "--check")

    def test_edits_come_back(self):
        self.succeed()
        self.stitch(FILE.replace("x = 0.5f;", "x = 0.25f;"))
        self.assertIn("\nx = 0.25f;\n", self.page.read_text())  # without the indentation of its use

    def test_new_lines_join_the_fragment_indented_deepest(self):
        self.succeed()
        self.stitch(FILE.replace("        x = 0.5f;\n", "        x = 0.5f;\n        x += 1.0f;\n"))
        self.assertIn("x = 0.5f;\nx += 1.0f;\n```", self.page.read_text())
        self.stitch(self.file.read_text().replace("    if (x", "    x *= 2.0f;\n    if (x"))
        self.assertIn("float x = cosine;\nx *= 2.0f;\n", self.page.read_text())

    def test_a_changed_title_renames_its_fragment(self):
        self.succeed()
        self.stitch(FILE.replace("/* Fall off */", "/* Fall off smoothly */"))
        self.assertEqual(self.page.read_text().count("<<Fall off smoothly>>"), 2)

    def test_what_has_no_place_changes_nothing(self):
        self.succeed()
        self.file.write_text(FILE.replace("    /* Fall off */\n", ""))
        self.fail_with("removes a fragment's title", "--stitch")
        self.assertEqual(self.page.read_text(), CHAPTER)

    def test_random_edits(self):
        """Changes, insertions and deletions of lines that are not titles, at random: each is stitched, or refused with the book unchanged."""
        generator, stitched = random.Random(1), 0
        for _ in range(25):
            self.page.write_text(CHAPTER)
            lines = FILE.split("\n")[:-1]
            for edit in range(generator.randint(1, 4)):
                at = generator.choice([i for i, line in enumerate(lines) if "Fall off" not in line])
                indent = len(lines[at]) - len(lines[at].lstrip())
                match generator.randint(0, 2):
                    case 0: lines[at] = " " * indent + f"changed_{edit}();"
                    case 1: lines.insert(at, " " * indent + f"inserted_{edit}();")
                    case 2: del lines[at]
            self.file.write_text("\n".join(lines) + "\n")
            if self.run_tool("--stitch").returncode == 0:
                stitched += 1
                self.succeed("--check")
            else:
                self.assertEqual(self.page.read_text(), CHAPTER)
        self.assertGreater(stitched, 15)


class ConceptsTest(unittest.TestCase):
    """A term in bold is defined there, once; before that it is used only in links."""

    def concepts(self, *chapters):
        with tempfile.TemporaryDirectory() as folder:
            pages = [Path(folder) / f"{number:02}-chapter.md" for number in range(1, len(chapters) + 1)]
            for page, text in zip(pages, chapters):
                page.write_text(text)
            return Concepts(pages)

    def test_a_definition_and_uses_after_it(self):
        concepts = self.concepts("A **shadow\nray** asks.\nShadow rays end.", "A shadow ray.")
        self.assertEqual(concepts.problems, [])
        self.assertEqual({term: (concept.stem, concept.line) for term, concept in concepts.defined.items()}, {"shadow ray": ("01-chapter", 1)})

    def test_a_use_before_the_definition_is_named_once(self):
        problems = self.concepts("# Lobes\n\n## Two\nBoth lobes, and a lobe.", "A **lobe** is one.").problems
        self.assertEqual(problems, ['01-chapter.md:4: "lobe" is used before it is defined at 02-chapter.md:1: link there, or define it here'])
        self.assertEqual(len(self.concepts("# One\n## Text\nA lobe. A **lobe** is one.").problems), 1)

    def test_links_code_mathematics_and_questions_may_come_first(self):
        early = "## Seven questions\n1. A lobe?\n\n## Text\nA [lobe](02-chapter.md), `lobe`, $lobe$.\n```c\nlobe\n```\nMore lobes."
        self.assertEqual(self.concepts(early, "A **lobe** is one.").problems, [])

    def test_a_second_definition_is_named(self):
        self.assertEqual(self.concepts("A **lobe**.", "text\nA **lobe**.").problems,
                         ["02-chapter.md:2: **lobe** is defined a second time; the first is 01-chapter.md:1: link there instead"])

    def test_html_links_first_uses_to_the_definition(self):
        concepts = self.concepts("A **lobe**.", "Lobes.")
        linked = concepts.linked({"01-chapter": "<p>A <strong>lobe</strong>.</p>", "02-chapter": "<p><code>lobe</code> Lobes. A lobe.</p>"})
        self.assertEqual(linked["01-chapter"], '<p>A <strong id="c-lobe">lobe</strong>.</p>')
        self.assertEqual(linked["02-chapter"],
                         '<p><code>lobe</code> <a class="concept" id="u-lobe" href="01-chapter.html#c-lobe">Lobes</a>. A lobe.</p>')


if __name__ == "__main__":
    unittest.main()
