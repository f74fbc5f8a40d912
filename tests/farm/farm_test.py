"""What the tests of render farms share."""

import argparse
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import venv

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77  # exit status, for ctest
SCENE = ROOT / "scenes" / "cornell-box.pbrt"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def expect(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")
    print(f"ok: {message}", flush=True)


def run(*words, status=0, **more):
    """Runs a command, and returns what it printed. Exits unless it ends with `status`."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)
    if status is not None and done.returncode != status:
        sys.exit(f"FAILED: {' '.join(map(str, words))} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def wait_until(condition, what, seconds=300, step=0.1):
    """Returns how long it took."""
    start = time.monotonic()
    while not (found := condition()):
        if time.monotonic() - start > seconds:
            sys.exit(f"FAILED: after {seconds} seconds, still not: {what}")
        time.sleep(step)
    return time.monotonic() - start


def pixels_of(film):
    """The records of a film file that hold pixels (host/film/record_file.h): every word of every sum."""
    data, place, records = pathlib.Path(film).read_bytes(), 32, []
    while place < len(data):
        tag, _, size, _, _ = struct.unpack_from("<4sIQII", data, place)
        place += 24
        if tag == b"PIXL":
            records.append(data[place : place + size])
        place += size
    return records


def environment_with(folder, *packages):
    """A virtual environment's folder of programs, with these packages of PyPI. Skips the test without them."""
    venv.create(folder, with_pip=True)
    done = subprocess.run([f"{folder}/bin/pip", "install", "--quiet", *packages], capture_output=True, text=True)
    if done.returncode:
        skip(f"{' '.join(packages)} of PyPI cannot be installed: {done.stderr.strip().splitlines()[-1:]}")
    return f"{folder}/bin"


def program():
    """The program to test."""
    options = argparse.ArgumentParser()
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    return options.parse_args().program.resolve()


def scratch():
    """A folder that goes with the test."""
    return tempfile.TemporaryDirectory(prefix="eikonal farm ")
