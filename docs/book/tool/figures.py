#!/usr/bin/env python3
"""Makes the book's figures again: each docs/book/figures/NAME.pbrt is rendered to NAME.png, each NAME.py prints NAME.svg.

    figures.py --program build/eikonal            writes the images
    figures.py --program build/eikonal --check    makes them in a temporary folder; status 1 if one differs from the committed one

The renderer gives the same bits on one kind of device; another compiler may round differently, so --check allows a mean FLIP error of 0.01.
An SVG without a script is a drawing, and says so in a comment.
"""
import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from fragments import BOOK, ROOT

LARGEST_FLIP = 0.01
DRAWN = "<!-- drawn by hand -->"


def problems_of_figures(folder):
    """Figures of a book's folder that are not there, or that nothing makes, and files that belong to none."""
    shown = {match: page.name for page in sorted(folder.glob("*.md"))
             for match in re.findall(r"\]\(figures/([\w.-]+)\)", page.read_text(encoding="utf-8"))}
    files = {file.name for file in (folder / "figures").glob("*.*")}
    for name in sorted(shown.keys() - files):
        yield f"figures/{name}: {shown[name]} shows it, but there is no such file"
    for name in sorted(shown.keys() & files):
        path = folder / "figures" / name
        if path.suffix == ".png" and not path.with_suffix(".pbrt").exists():
            yield f"figures/{name}: the scene that makes it, {path.with_suffix('.pbrt').name}, is missing"
        if path.suffix == ".svg" and path.with_suffix(".py").exists() == (DRAWN in path.read_text(encoding="utf-8")):
            yield f"figures/{name}: the script that makes it, {path.with_suffix('.py').name}, is missing; a drawing has {DRAWN} instead"
    makers = {".pbrt": ".png", ".py": ".svg"}
    for name in sorted(files - shown.keys()):
        if Path(name).with_suffix(makers.get(Path(name).suffix, "")).name not in shown:
            yield f"figures/{name}: no page shows it"


def render(program, scene, image):
    subprocess.run([program, "render", scene, "-o", image, "--log-level", "error"], check=True)


def agree(program, image, reference):
    return subprocess.run([program, "compare", image, reference, "--fail-above", str(LARGEST_FLIP)], stdout=subprocess.DEVNULL).returncode == 0


def draw(script):
    return subprocess.run([sys.executable, script], check=True, capture_output=True, text=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--plots", action="store_true", help="only what scripts draw, without the renderer")
    options = parser.parse_args()
    failed = 0

    def report(image, differs):
        nonlocal failed
        failed += differs
        print(f"{image.relative_to(ROOT)}: {'DIFFERS' if differs else 'agrees' if options.check else 'made'}", flush=True)
    for script in sorted((BOOK / "figures").glob("*.py")):
        image, text = script.with_suffix(".svg"), draw(script)
        report(image, options.check and image.read_text(encoding="utf-8") != text)
        if not options.check:
            image.write_text(text, encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        for scene in [] if options.plots else sorted((BOOK / "figures").glob("*.pbrt")):
            image = scene.with_suffix(".png")
            target = Path(folder) / image.name if options.check else image
            render(options.program.resolve(), scene, target)
            report(image, options.check and not agree(options.program.resolve(), target, image))
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
