#!/usr/bin/env python3
"""Weaves the book and opens all its pages in headless Chromium, at three widths: no error in the console, nothing wider than the window, and no
serious fault that axe-core finds at the smallest width. axe.min.js is that of PyPI's axe-playwright-python, if it is installed, or --axe FILE.

Exits with 77, skipped, without Chromium or the tools that weave.
"""
import argparse
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTHS = (1400, 900, 400)

# Puts what it found into the page, where --dump-dom shows it. Code and formulas may scroll within themselves.
REPORT = """<script>
addEventListener("load", async () => {
    const report = { wide: document.documentElement.scrollWidth > innerWidth + 1, width: document.documentElement.scrollWidth, faults: [] };
    if (window.axe) {
        const found = await axe.run(document, { resultTypes: ["violations"], preload: false });
        report.faults = found.violations.filter(v => v.impact === "serious" || v.impact === "critical").map(v => v.id + ": " + v.nodes[0].html.slice(0, 200));
    }
    const element = document.createElement("pre");
    element.id = "report";
    element.textContent = JSON.stringify(report);
    document.body.append(element);
});
</script>"""


def open_page(page, width, axe):
    """What is wrong with a page at a width."""
    probe = page.with_name(f"probe-{width}-{page.name}")
    scripts = f"<script>{axe.read_text(encoding='utf-8')}</script>" if axe else ""
    probe.write_text(page.read_text(encoding="utf-8").replace("</body>", scripts + REPORT + "</body>"), encoding="utf-8")
    command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", f"--window-size={width},1000",
               "--virtual-time-budget=60000", "--dump-dom", f"file://{probe}"]
    result = subprocess.run(command, capture_output=True, text=True, timeout=300)
    probe.unlink()
    match = re.search(r'<pre id="report">(.*?)</pre>', result.stdout, re.DOTALL)
    if not match:
        yield "it did not finish loading"
        return
    report = json.loads(match[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
    if report["wide"]:
        yield f"the page is {report['width']} wide"
    yield from report["faults"]
    yield from (line for line in result.stderr.splitlines() if "CONSOLE" in line)


def installed_axe():
    package = importlib.util.find_spec("axe_playwright_python")
    return next(Path(package.origin).parent.rglob("axe.min.js"), None) if package else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--axe", type=Path, default=installed_axe())
    parser.add_argument("--page", help="only this one")
    options = parser.parse_args()
    missing = [tool for tool in ("chromium", "pandoc", "ctags") if not shutil.which(tool)]
    if missing or subprocess.run(["/usr/bin/python3", "-c", "import clang.cindex, pygments"], capture_output=True).returncode:
        print(f"skipped: {', '.join(missing) or 'python3-clang-16 or python3-pygments'} is not installed; ./dev book installs it")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "book"
        if subprocess.run(["/usr/bin/python3", ROOT / "docs/book/tool/weave.py", "--no-pdf", "--output", site]).returncode:
            return 1
        pages = sorted(site.glob(f"{options.page or '*'}.html"))
        with ThreadPoolExecutor(2) as pool:
            found = pool.map(lambda where: (where, list(open_page(*where, options.axe if where[1] == WIDTHS[-1] else None))),
                             [(page, width) for page in pages for width in WIDTHS])
            problems = [f"{page.stem} at {width}: {problem}" for (page, width), all_of_it in found for problem in all_of_it]
    print("\n".join(problems) or f"{len(pages)} pages at {len(WIDTHS)} widths: nothing wrong{'' if options.axe else ', without axe-core'}")
    return int(bool(problems))


if __name__ == "__main__":
    sys.exit(main())
