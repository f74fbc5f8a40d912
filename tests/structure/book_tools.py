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
from macro_lists import MacroLists  # noqa: E402
from mathematics import mended  # noqa: E402

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
        self.file.write_text(FILE)
        self.git("init", "--quiet")
        self.commit()
        self.file.unlink()

    def git(self, *arguments):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=T", "-c", "user.email=t@t", *arguments], check=True, capture_output=True)

    def commit(self):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "-m", "state")

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

    def number_of(self, line):
        """The number of a line of the page."""
        return self.page.read_text().split("\n").index(line) + 1

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

    def test_check_names_the_first_line_that_differs_and_what_no_fragment_holds(self):
        self.fail_with("kernels/light/spot.clh does not exist: ./dev tangle writes it; if it is to go, remove its block, "
                       f"{self.page}:{self.number_of('```opencl kernels/light/spot.clh =')}, and the fragments that only it uses\n", "--check")
        (self.root / "kernels" / "light" / "new.clh").write_text("float y;\n")
        advice = ": ./dev stitch takes the code's edits into the book, ./dev tangle writes the book's\n"
        for text, line, page_line in ((FILE.replace("0.5f;", "0.6f;"), 6, "x = 0.5f;"), (FILE + "more\n", 12, "}"), (FILE.removesuffix("\n"), 12, "}"),
                                      (FILE.removesuffix("}\n"), 11, "}"), (FILE.replace("Fall off", "Fall"), 3, "    /* <<Fall off>> */")):
            self.file.write_text(text)
            self.fail_with(f"kernels/light/spot.clh:{line} differs from the book, {self.page}:{self.number_of(page_line)}{advice}", "--check")
        self.fail_with("kernels/light/new.clh is in no chapter: add a block that begins with ```opencl kernels/light/new.clh =", "--check")

    def test_ends_of_lines_count(self):
        self.file.write_bytes(FILE.replace("\n", "\r\n").encode())
        where = (f"kernels/light/spot.clh:1 differs from the book, {self.page}:{self.number_of('/* A spot light. */')} (its lines end with CR LF; the book's "
                 "end with LF): ")
        self.fail_with(where, "--check")
        self.fail_with(where + "save it with LF", "--stitch")
        self.assertEqual(self.page.read_text(), CHAPTER)

    def test_a_file_is_text(self):
        self.file.write_bytes(b"/* \xff */")
        self.fail_with("error: kernels/light/spot.clh is no UTF-8 text at byte 4: save it as UTF-8", "--check")

    def test_tangle_keeps_edits_that_are_not_committed(self):
        self.succeed()
        self.file.write_text(FILE.replace("2.0f", "3.0f"))
        self.fail_with("error: kernels/light/spot.clh has edits that the book does not have: ./dev stitch takes them into the book, ./dev tangle --force "
                       "loses them")
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
                               (CHAPTER.replace("opencl <<Clamp>> =", "opencl <<Clamp>>"), "this fence defines nothing"),
                               (CHAPTER.replace("opencl kernels/", "opencl ../kernels/"), "../kernels/light/spot.clh is outside the repository"),
                               (CHAPTER.replace("opencl kernels/", "opencl /kernels/"), "/kernels/light/spot.clh is outside the repository"),
                               (CHAPTER.removesuffix("```\n"), "this block has no end")):
            self.page.write_text(wrong)
            self.fail_with(message, "--check")

    def test_a_blank_after_a_fence_is_nothing(self):
        self.page.write_text(CHAPTER.replace("<<Clamp>> =", "<<Clamp>> = "))
        self.succeed()
        self.assertEqual(self.file.read_text(), FILE)

    def edit(self, file, old, new):
        text = file.read_text()
        self.assertEqual(text.count(old), 1)
        file.write_text(text.replace(old, new))

    def test_stitch_leaves_edits_of_the_book_alone(self):
        self.succeed()
        self.edit(self.page, "x = 0.5f;", "x = 0.7f;")
        result = self.run_tool("--stitch")
        self.assertEqual(result.stdout, "only the book has edits of kernels/light/spot.clh: ./dev tangle writes it\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("\nx = 0.7f;\n", self.page.read_text())
        self.succeed()
        self.assertEqual(self.file.read_text(), FILE.replace("x = 0.5f;", "x = 0.7f;"))

    def test_edits_of_both_sides_come_together(self):
        self.succeed()
        self.edit(self.page, "x = 0.5f;", "x = 0.7f;\nx += 1.0f;")
        self.edit(self.page, "More of the end", "Prose,\nand more of it")
        self.edit(self.file, "* 2.0f", "* 3.0f")
        self.edit(self.file, "/* Fall off */", "/* Fall off smoothly */")
        self.fail_with("has edits that the book does not have")
        self.assertEqual(self.succeed("--stitch"), "stitched, and written with the book's edits: kernels/light/spot.clh\n")
        self.assertEqual(self.file.read_text(), FILE.replace("x = 0.5f;", "x = 0.7f;\n        x += 1.0f;").replace("2.0f", "3.0f").replace("off", "off smoothly"))
        self.succeed("--check")
        self.assertIn("Prose,\nand more of it", self.page.read_text())

    def test_different_edits_of_a_fragment_are_refused(self):
        self.succeed()
        self.edit(self.page, "x = 0.5f;", "x = 0.7f;")
        self.edit(self.file, "x = 0.5f;", "x = 0.9f;")
        page, file = self.page.read_text(), self.file.read_text()
        self.fail_with(f"error: {self.page}:{self.number_of('```opencl <<Clamp>> =')}: <<Clamp>> has one edit here and another in the code\n"
                       "make the two the same, or choose one: ./dev stitch --force takes the code's, ./dev tangle --force the book's\n", "--stitch")
        self.assertEqual((self.page.read_text(), self.file.read_text()), (page, file))
        self.succeed("--stitch", "--force")
        self.assertEqual((self.page.read_text(), self.file.read_text()), (page.replace("0.7f", "0.9f"), file))

    def test_the_same_edit_on_both_sides_is_no_conflict(self):
        self.succeed()
        self.edit(self.page, "x = 0.5f;", "x = 0.7f;")
        self.edit(self.file, "x = 0.5f;", "x = 0.7f;")
        self.edit(self.file, "* 2.0f", "* 3.0f")
        self.succeed("--stitch")
        self.assertEqual(self.page.read_text(), CHAPTER.replace("x = 0.5f;", "x = 0.7f;").replace("2.0f", "3.0f"))

    def test_work_goes_on_without_commits(self):
        """Stitching and tangling again and again, of one fragment: each begins with the state after the last."""
        self.succeed()
        for value in ("0.6f", "0.7f"):
            self.stitch(FILE.replace("x = 0.5f", f"x = {value}"))
            self.page.write_text(CHAPTER.replace("x = 0.5f", f"x = {value}1"))
            self.succeed()
            self.assertIn(f"x = {value}1;", self.file.read_text())
        self.commit()
        self.stitch(self.file.read_text().replace("0.7f1", "0.8f"))
        self.git("checkout", ".")
        self.stitch(self.file.read_text().replace("0.7f1", "0.9f"))

    def test_a_new_block_does_not_replace_a_file(self):
        self.succeed()
        self.page.write_text(CHAPTER + "\n```opencl kernels/light/new.clh =\nfloat x;\n```\n")
        new = self.file.with_name("new.clh")
        new.write_text("float y;\n")
        self.fail_with("kernels/light/new.clh has edits that the book does not have")
        self.fail_with("error: the block of kernels/light/new.clh is new and differs from the file: make the two the same, or choose one: ./dev stitch --force "
                       "takes the file's text, ./dev tangle --force the book's\n", "--stitch")
        self.succeed("--stitch", "--force")
        self.assertEqual(new.read_text(), "float y;\n")
        self.assertIn("=\nfloat y;\n```\n", self.page.read_text())

    def test_without_a_commit_someone_must_choose(self):
        self.succeed()
        self.edit(self.file, "2.0f", "3.0f")
        (self.root / ".git").rename(self.root / "no-git")
        self.fail_with("error: no commit tells whether the book or the code was edited: ./dev stitch --force takes the code's text, ./dev tangle --force the "
                       "book's\n", "--stitch")
        self.succeed("--stitch", "--force")
        self.assertIn("3.0f", self.page.read_text())

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


LISTS = """#define RAY_FIELDS(F, q) \\
    F(q, float, t_max, MEDIA) /* F(q, float, comment, MEDIA) */
#define QUEUES(Q) \\
    Q(ray, RAY_FIELDS) \\
    Q(hit, RAY_FIELDS)
#define BSDFS(B) \\
    B(diffuse, HERE)
#define FIELD_LOAD(q, type, name, FEATURE) if (HAS_##FEATURE) item.name = load_##type(q##_##name##_slot);
#define DEFINE_QUEUE(q, FIELDS) \\
    FN q##_item load_##q(void) { FIELDS(FIELD_LOAD, q) }
QUEUES(DEFINE_QUEUE)
#define JOIN(a, b) JOIN_(a, b)
#define EVAL_BSDF JOIN(eval_, BSDF)
#define EVAL_HERE(name) x_##name
#define EVAL(name, PLACE) EVAL_##PLACE(name)
BSDFS(EVAL)
STAGE(shade_hits, SHADE_HITS) {}
"""


class MacroListsTest(unittest.TestCase):
    """Names that macros make have the list's row and the macro."""

    def setUp(self):
        self.lists = MacroLists({"a.h": LISTS})

    def ways(self, name):
        return [(row.line, pattern.macro, pattern.line) for row, pattern in self.lists.made(name)]

    def line(self, text):
        return next(number for number, line in enumerate(LISTS.split("\n"), 1) if text in line)

    def test_rows_of_lists(self):
        self.assertEqual(self.ways("hit_item"), [(self.line("Q(hit"), "DEFINE_QUEUE", self.line("q##_item"))])
        self.assertIn((self.line("Q(hit"), "DEFINE_QUEUE", self.line("q##_item")), self.ways("load_hit"))

    def test_rows_of_the_lists_that_a_list_names(self):
        field = self.line("F(q, float, t_max")
        self.assertEqual(self.ways("load_float")[0], (field, "FIELD_LOAD", self.line("load_##type")))
        self.assertEqual(self.ways("HAS_MEDIA"), [(field, "FIELD_LOAD", self.line("load_##type"))])
        self.assertEqual([way[1] for way in self.ways("ray_t_max_slot")], ["FIELD_LOAD"])
        self.assertIn("t_max", dict(self.lists.fields()))

    def test_words_that_the_host_replaces(self):
        self.assertEqual(self.ways("eval_diffuse"), [(self.line("B(diffuse"), "BSDF", self.line("EVAL_BSDF"))])

    def test_macros_whose_names_are_joined(self):
        self.assertEqual(self.ways("x_diffuse"), [(self.line("B(diffuse"), "EVAL_HERE", self.line("x_##name"))])

    def test_other_words_are_not_made(self):
        for name in ("miss_item", "next_ray", "load_comment", "eval_hit", "hit"):
            self.assertEqual(self.ways(name), [])

    def test_stages(self):
        self.assertEqual(list(self.lists.kernels()), [("shade_hits", "a.h", self.line("STAGE("))])


def paired(stretchy, inner):
    """MathML of (inner), as pandoc writes it if stretchy is "true"."""
    return f'<mrow><mo stretchy="{stretchy}" form="prefix">(</mo>{inner}<mo stretchy="{stretchy}" form="postfix">)</mo></mrow>'


class MathematicsTest(unittest.TestCase):
    """Pandoc's MathML becomes such that MathML Core shows it as TeX does."""

    def expect(self, pandocs, ours):
        self.assertEqual(mended(f"<p>cos <math><mrow>{pandocs}</mrow></math></p>"), f"<p>cos <math><mrow>{ours}</mrow></math></p>")

    def test_names_are_upright_and_whole(self):
        self.expect('<mstyle mathvariant="normal"><mi>p</mi><mi>d</mi><mi>f</mi></mstyle><mi>x</mi>', '<mi mathvariant="normal">pdf</mi><mi>x</mi>')
        self.expect('<mstyle mathvariant="normal"><mi>n</mi><mn>2</mn></mstyle>', '<mi mathvariant="normal">n2</mi>')

    def test_functions_have_thin_spaces_between_factors_only(self):
        self.expect("<mo>cos</mo><mi>t</mi>", '<mo lspace="0" rspace="0.167em">cos</mo><mi>t</mi>')
        self.expect("<mi>f</mi><mo>cos</mo><mi>t</mi>", '<mi>f</mi><mo lspace="0.167em" rspace="0.167em">cos</mo><mi>t</mi>')
        self.expect("<mi>f</mi><mo>max</mo>" + paired("true", "<mi>t</mi>"), '<mi>f</mi><mo lspace="0.167em" rspace="0">max</mo>' + paired("false", "<mi>t</mi>"))
        self.expect("<mo>=</mo><mi>x</mi>", "<mo>=</mo><mi>x</mi>")

    def test_a_minus_without_a_left_side_is_a_sign(self):
        self.expect("<mi>a</mi><mo>=</mo><mo>−</mo><mi>b</mi><mo>−</mo><mi>c</mi>", '<mi>a</mi><mo>=</mo><mo form="prefix">−</mo><mi>b</mi><mo>−</mo><mi>c</mi>')
        self.expect(paired("true", "<mo>−</mo><mi>b</mi>"), paired("false", '<mo form="prefix">−</mo><mi>b</mi>'))

    def test_parentheses_stretch_around_what_is_high(self):
        fraction = "<mfrac><mi>a</mi><mi>b</mi></mfrac>"
        self.expect(paired("true", fraction), paired("true", fraction))
        self.expect(paired("true", "<mi>a</mi>" + paired("true", "<mi>b</mi>")), paired("false", "<mi>a</mi>" + paired("false", "<mi>b</mi>")))
        self.expect(paired("true", fraction + paired("true", "<mi>b</mi>")), paired("true", fraction + paired("false", "<mi>b</mi>")))


if __name__ == "__main__":
    unittest.main()
