#!/usr/bin/env python3
"""What it costs to render an image in parts.

    tests/bench/parts.py [SCENE]                     # processor time of 1, 2, 4, 8 parts and their merge, one after the other
    tests/bench/parts.py --merge 1 10 100 1000       # memory and time of a merge of so many parts of a 4K image

Of each N, N processes render a tile each. Efficiency is the processor time of one run over that of all parts and the merge: processor time, since
parts on other machines do not share it, and since it hardly depends on what else this machine does. For --merge, one film is rendered and cut
into films of some rows each, which are what --tile leaves.
"""

import argparse
import os
import pathlib
import struct
import sys
import tempfile
import time

from report import Report

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*words, files=None):
    """(processor seconds, wall seconds, peak memory in bytes) of a command and its children."""
    start = time.monotonic()
    process = os.fork()
    if process == 0:
        sink = os.open(os.devnull, os.O_WRONLY)
        os.dup2(sink, 1)
        if files:
            import resource

            resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))
        os.execvp(str(words[0]), [str(word) for word in words])
    _, status, usage = os.wait4(process, 0)
    if status:
        sys.exit(f"parts: {' '.join(map(str, words))} ended with status {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime, time.monotonic() - start, usage.ru_maxrss * 1024


def records_of(film):
    """(kind, [(tag, record with its head)]) of a film file (host/film/record_file.h)."""
    data, place, records = film.read_bytes(), 32, []
    while place < len(data):
        tag, _, size, _, _ = struct.unpack_from("<4sIQII", data, place)
        records.append((tag, data[place : place + 24 + size]))
        place += 24 + size
    return data[:32], records


def cut(film, count, folder):
    """Writes `count` films of some rows each."""
    import zlib

    kind, records = records_of(film)
    heads = [record for tag, record in records if tag not in (b"PIXL", b"LAST")]
    rows = [record for tag, record in records if tag == b"PIXL"]
    names = []
    for i in range(count):
        own = heads + rows[len(rows) * i // count : len(rows) * (i + 1) // count]
        content = struct.pack("<Q", len(own))
        head = struct.pack("<4sIQ", b"LAST", zlib.crc32(content), len(content))
        head += struct.pack("<II", zlib.crc32(head), 0)
        names.append(folder / f"{i}-of-{count}.film")
        names[-1].write_bytes(kind + b"".join(own) + head + content)
    return names


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scene", type=pathlib.Path, nargs="?", default=ROOT / "scenes" / "cornell-box.pbrt")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--parts", type=int, nargs="+", default=[1, 2, 4, 8])
    options.add_argument("--spp", type=int, default=512)
    options.add_argument("--resolution", default="128x128")
    options.add_argument("--merge", type=int, nargs="+", help="merge so many parts of an image")
    options.add_argument("--files", type=int, help="files that the merge may open (ulimit -n)")
    Report.add_to(options)
    o = options.parse_args()
    report = Report(o.json)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if o.merge:
            size = "3840x2160" if o.resolution == "128x128" else o.resolution
            run(o.program, "render", o.scene, "--quiet", "--resolution", size, "--spp", 1, "-o", folder / "whole.film")
            add = report.table("merge", {"parts": None, "peak MiB": ".0f", "seconds": ".1f"})
            for count in o.merge:
                names = cut(folder / "whole.film", count, folder)
                _, wall, memory = run(o.program, "merge", *names, "--quiet", "-o", folder / "image.pfm", files=o.files)
                add(count, memory / 2**20, wall)
                for each in names:
                    each.unlink()
            return
        settings = [o.scene, "--quiet", "--resolution", o.resolution, "--spp", o.spp]
        run(o.program, "render", *settings, "-o", folder / "warm.film", "--samples", "0:16")  # compiles the kernels
        whole, whole_wall, _ = run(o.program, "render", *settings, "-o", folder / "whole.pfm")
        columns = {"parts": None, "parts, s": ".1f", "merge, s": ".2f", "over one run, s": ".2f", "of each part, s": ".2f", "efficiency": ".3f"}
        add = report.table("parts", columns)
        for count in o.parts:
            names, spent = [], 0
            for i in range(1, count + 1):
                names.append(folder / f"{i}-of-{count}.film")
                spent += run(o.program, "render", *settings, "--tile", f"{i}/{count}", "-o", names[-1])[0]
            merge = run(o.program, "merge", *names, "--quiet", "-o", folder / "merged.pfm")[0]
            over = spent + merge - whole
            add(count, spent, merge, over, (spent - whole) / count, whole / (spent + merge))


if __name__ == "__main__":
    main()
