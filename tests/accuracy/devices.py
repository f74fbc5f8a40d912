#!/usr/bin/env python3
"""The same kernels on several OpenCL implementations: how far their images differ from those of the installed PoCL.

    tests/accuracy/devices.py SCENE ... [--intel VENV] [--pocl VENV] [--json FILE]
    tests/accuracy/devices.py --from FILE           puts the table of kept figures into docs/numerics.md

PoCL with threads (`pthread`) and without (`basic`), and Oclgrind if it is installed (at 8 x 8 pixels and one sample: it is a hundred times
slower). Others from PyPI, each in a virtual environment of its own:
    python3 -m venv VENV && VENV/bin/pip install intel-opencl-rt intel-cmplr-lib-rt       --intel VENV: Intel's runtime for processors
    python3 -m venv VENV && VENV/bin/pip install pocl-binary-distribution                 --pocl VENV: another version of PoCL
A cell is "same bits", or relMSE and the change of the worst channel's mean; a failure is its last line. The sampler is `independent`, because
Oclgrind 21.10 cannot reverse bits.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "bench"))
from page import put  # noqa: E402
from report import processor  # noqa: E402

BASE = "PoCL pthread"
# Functions are called, not inlined: inlining leaves an intrinsic behind that Oclgrind 21.10 does not know
OCLGRIND = ["oclgrind", "--build-options", "-disable-llvm-passes"]


def vendor(folder, libraries, name):
    """The environment in which only the implementation `name` of these libraries is found."""
    (library,) = libraries
    vendors = folder / name
    vendors.mkdir()
    (vendors / f"{name}.icd").write_text(f"{library.resolve()}\n")
    return {"OCL_ICD_VENDORS": str(vendors), "LD_LIBRARY_PATH": str(library.parent)}


def implementations(o, folder):
    """For each: what it adds to the environment; options; what its command begins with, if it is only for tiny images."""
    found = {BASE: ({"POCL_DEVICES": "pthread"}, ["--device", "Portable"], []),
             "PoCL basic": ({"POCL_DEVICES": "basic"}, ["--device", "Portable"], [])}
    if o.pocl:
        found["PoCL from PyPI"] = (vendor(folder, o.pocl.glob("lib/*/site-packages/*/.libs/libpocl-*.so"), "pocl"), ["--device", "Portable"], [])
    if o.intel:
        found["Intel"] = (vendor(folder, o.intel.glob("lib/libintelocl.so"), "intel"), ["--device", "Intel"], [])
    if shutil.which("oclgrind"):
        found["Oclgrind"] = ({}, ["--device", "Oclgrind", "--no-cache", "--wave-paths", 64, "--local-size", 16], OCLGRIND)
    return found


def render(o, scene, image, implementation, tiny):
    environment, options, before = implementation
    size = ["--resolution", "8x8", "--spp", 1] if tiny else ["--resolution", o.size, "--spp", o.samples]
    command = [*before, o.program, "render", scene, *size, "--sampler", "independent", "--environment-guide", "never", "--quiet", "-o", image, *options]
    try:
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True, env=os.environ | environment, timeout=600)
    except subprocess.TimeoutExpired:
        return "takes more than 10 minutes"
    return (done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1] if done.returncode else None


def compare(o, image, base):
    c = json.loads(subprocess.run([str(w) for w in (o.program, "compare", image, base, "--json")], capture_output=True, text=True, check=True).stdout)
    return {"relativeMse": c["relativeMse"], "mean": c["worstMean"]}


def measure(o, scene, folder):
    row = {}
    found = implementations(o, folder)
    for name, implementation in found.items():
        tiny = bool(implementation[2])
        base, image = folder / f"base-{tiny}.exr", folder / "other.exr"
        if not base.exists():
            failure = render(o, scene, base, found[BASE], tiny)
            if failure:
                sys.exit(f"devices: {scene}: {failure}")
        if name != BASE:
            failure = render(o, scene, image, implementation, tiny)
            row[name] = {"failure": failure} if failure else compare(o, image, base)
    return row


def cell(figure):
    if figure is None:
        return "-"
    if "failure" in figure:
        return figure["failure"]
    return "same bits" if figure["relativeMse"] == 0 else f"{figure['relativeMse']:.0e}, {100 * figure['mean']:.0e} %"


def table(scenes):
    names = list(dict.fromkeys(name for row in scenes.values() for name in row))
    return f"| scene | {' | '.join(names)} |\n|---|{'--:|' * len(names)}\n" + "".join(
        f"| {scene} | {' | '.join(cell(row.get(name)) for name in names)} |\n" for scene, row in scenes.items())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--intel", type=pathlib.Path)
    parser.add_argument("--pocl", type=pathlib.Path)
    parser.add_argument("--size", default="64x64")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--from", type=pathlib.Path, dest="kept")
    o = parser.parse_args()
    figures = json.loads(o.kept.read_text()) if o.kept else {"processor": processor(), "scenes": {}}
    for scene in o.scenes:
        with tempfile.TemporaryDirectory() as name:
            figures["scenes"][scene.stem] = measure(o, scene, pathlib.Path(name))
        if o.json:
            o.json.write_text(json.dumps(figures, indent=1) + "\n")
    put(ROOT / "docs" / "numerics.md", "<!-- devices: made by tests/accuracy/devices.py -->\n", table(figures["scenes"]), "<!-- end of devices -->",
        only_print=not o.kept)


if __name__ == "__main__":
    main()
