#!/usr/bin/env python3
"""What a start costs, measured from outside: from the start of the process to its exit by this script's clock, and the processor time that
the system counted for it and its workers.

    tests/bench/starts.py [SCENE ...]

Prints a row for --version, for --help, for a tiny scene and an OBJ without lamps, and for each scene: kernels that had to be compiled, wall
and processor seconds with an empty cache of kernels and with a full one. Scenes are rendered with 16 x 16 pixels and one sample. Warm times are
the medians of --repeats; cold ones are measured once, since each takes seconds. Nothing else should run on the machine.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]
TINY = """Camera "perspective" "float fov" 40
Film "rgb" "string filename" "image.exr"
WorldBegin
LightSource "point" "point3 from" [ 0 1 0 ]
Translate 0 0 3
Shape "sphere"
"""
PLAIN = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def measured(command, environment):
    """(wall, processor) seconds of a command that succeeds."""
    with tempfile.TemporaryFile("w+") as output:
        begin = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], stdout=output, stderr=output, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            output.seek(0)
            sys.exit(f"starts: {' '.join(map(str, command))} failed:\n{output.read()}")
    return wall, usage.ru_utime + usage.ru_stime


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", type=pathlib.Path, nargs="*")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--repeats", type=int, default=5)
    Report.add_to(options)
    o = options.parse_args()
    add = Report(o.json).table("starts", {"start": None, "kernels": None, "cold, s": ".1f", "cold, CPU s": ".1f", "warm, s": ".3f", "warm, CPU s": ".3f"})

    def median(command, environment):
        return [statistics.median(column) for column in zip(*(measured(command, environment) for _ in range(o.repeats)))]

    environment = {key: value for key, value in os.environ.items() if key != "POCL_CACHE_DIR"}
    for option in ("--version", "--help"):
        add(option, None, None, None, *median([o.program, option], environment))
    with tempfile.TemporaryDirectory() as folder:
        own = [pathlib.Path(folder) / name for name in ("tiny.pbrt", "plain.obj")]
        for path, text in zip(own, (TINY, PLAIN)):
            path.write_text(text)
        for scene in own + o.scenes:
            command = [o.program, "render", scene, "--spp", "1", "--resolution", "16x16", "-o", f"{folder}/image.exr"]
            with tempfile.TemporaryDirectory() as cache:
                cached = environment | {"EIKONAL_CACHE_DIR": cache}
                cold = measured(command, cached)
                kernels = len(list(pathlib.Path(cache).glob("*.program")))
                add(scene.name if scene in own else f"{scene.parent.name}/{scene.name}", kernels, *cold, *median(command, cached))


if __name__ == "__main__":
    main()
