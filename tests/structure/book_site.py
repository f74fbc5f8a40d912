#!/usr/bin/env python3
"""Weaves the book and opens pages of it in headless Chromium, at three widths: no error in the console, nothing wider than the window, and, with
--axe FILE, no serious fault that axe-core finds at the smallest width (axe.min.js; PyPI's axe-playwright-python contains it; a minute a page).

Exits with 77, skipped, without Chromium or the tools that weave.
"""
import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WIDTHS = (1400, 900, 400)
PAGES = ("index", "01-one-ray", "08-surfaces", "a-10-light", "index-of-identifiers", "references")

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
    probe = page.with_name(f"probe-{page.name}")
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--axe", type=Path)
    options = parser.parse_args()
    missing = [tool for tool in ("chromium", "pandoc", "ctags") if not shutil.which(tool)]
    if missing or subprocess.run(["/usr/bin/python3", "-c", "import clang.cindex, pygments"], capture_output=True).returncode:
        print(f"skipped: {', '.join(missing) or 'python3-clang-16 or python3-pygments'} is not installed; ./dev book installs it")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "book"
        if subprocess.run(["/usr/bin/python3", ROOT / "docs/book/tool/weave.py", "--no-pdf", "--output", site]).returncode:
            return 1
        problems = [f"{page} at {width}: {problem}" for page in PAGES for width in WIDTHS for problem in open_page(site / f"{page}.html", width, options.axe if width == WIDTHS[-1] else None)]
    print("\n".join(problems) or f"{len(PAGES)} pages at {len(WIDTHS)} widths: nothing wrong")
    return int(bool(problems))


if __name__ == "__main__":
    sys.exit(main())
