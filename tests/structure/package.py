#!/usr/bin/env python3
"""The Debian package: cpack makes it, lintian (if installed) finds nothing, and unpacked into an empty folder it renders what the build
renders."""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command, cwd=None):
    done = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"package: {' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    build = options.parse_args().build.resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=build)
        package, = folder.glob("*.deb")
        assert "pocl-opencl-icd" in run("dpkg-deb", "--field", package, "Depends")
        if shutil.which("lintian"):
            found = run("lintian", "--allow-root", "--fail-on", "error,warning", package)
            assert not found.strip(), found
        run("dpkg-deb", "--extract", package, folder / "root")
        packaged, scene = folder / "root/usr/bin/eikonal", [ROOT / "scenes/cornell-box.pbrt", "--resolution", "32x32"]
        for number, program in enumerate((packaged, build / "eikonal")):
            run(program, "render", *scene, "--spp", 4, "-o", folder / f"{number}.exr")
        # A format that the module of OpenImageIO writes
        run(packaged, "render", *scene, "--spp", 1, "-o", folder / "a.jpg")
        compared = run(build / "eikonal", "compare", folder / "0.exr", folder / "1.exr")
        assert "relative MSE    0\n" in compared, compared


if __name__ == "__main__":
    main()
