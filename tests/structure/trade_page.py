#!/usr/bin/env python3
"""Opens the page of `eikonal trade` in headless Chromium (Debian: chromium) at three widths, without a network.

Fails if the console has an error, if the page asks for anything from elsewhere, is wider than its window, or shows fewer marks or pictures than
the JSON has points and settings. --screenshots FOLDER keeps pictures, to be looked at. Exits with 77 if Chromium is not installed.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTHS = (400, 900, 1600)
PROBE = """<script>addEventListener("load", () => {
  const scroll = document.documentElement.scrollWidth;
  document.body.dataset.probe = [innerWidth, scroll, document.images.length, [...document.images].filter(i => i.naturalWidth > 0).length,
    document.querySelectorAll("svg circle").length, performance.getEntriesByType("resource").filter(e => !e.name.startsWith("data:")).length].join(" ");
});</script></body>"""


def chromium():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def browse(browser, page, width, *options):
    with tempfile.TemporaryDirectory() as profile:
        return subprocess.run([browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}", "--enable-logging=stderr",
                               "--host-resolver-rules=MAP * ~NOTFOUND", f"--window-size={width},2400", "--virtual-time-budget=5000", *options,
                               page.as_uri()], capture_output=True, text=True, timeout=120)


def check(browser, page, figures, screenshots):
    problems = []
    probed = page.with_name("probed.html")
    probed.write_text(page.read_text(encoding="utf-8").replace("</body>", PROBE), encoding="utf-8")
    settings = {p["setting"] for p in figures["points"]}
    for width in WIDTHS:
        dom = browse(browser, probed, width, "--dump-dom")
        console = [line for line in dom.stderr.splitlines() if "CONSOLE" in line and "ERROR" in line.upper()]
        problems += [f"{width}: {line}" for line in console]
        found = re.search(r'data-probe="([\d. ]+)"', dom.stdout)
        if not found:
            problems.append(f"{width}: the page did not load: {dom.stderr[-300:]}")
            continue
        inner, scroll, images, loaded, circles, resources = (int(float(x)) for x in found.group(1).split())
        print(f"{width}: {images} pictures, {circles} marks, page {scroll} wide")
        if scroll > inner:
            problems.append(f"{width}: the page is {scroll} wide, its window {inner}")
        if loaded != images or images < 3 * len(settings) + 1:
            problems.append(f"{width}: {loaded} of {images} pictures, for {len(settings)} settings")
        if circles < sum(p["relativeMse"]["value"] > 0 for p in figures["points"]):
            problems.append(f"{width}: {circles} marks for {len(figures['points'])} points")
        if resources:
            problems.append(f"{width}: {resources} resources from elsewhere")
        if screenshots:
            browse(browser, page, width, f"--screenshot={screenshots.resolve() / f'trade-{width}.png'}")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "scenes" / "cornell-box.pbrt")
    parser.add_argument("--budget", default="45s")
    parser.add_argument("--screenshots", type=pathlib.Path)
    o = parser.parse_args()
    browser = chromium()
    if not browser:
        print("chromium is not installed: skipped")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        page = pathlib.Path(name) / "page.html"
        subprocess.run([o.program, "trade", o.scene, "--resolution", "96x96", "--budget", o.budget, "-o", page, "--quiet"], check=True)
        problems = check(browser, page, json.loads(page.with_suffix(".json").read_text()), o.screenshots)
    print("\n".join(problems))
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
