#!/usr/bin/env python3
"""What being watched costs a render: CPU seconds of the program without --view, with --view, and with a client that does what the page does.

The three are interleaved, so that what else the machine does meets them alike; prints the median of each and of the ratios within a round, as
JSON with --json. CPU seconds, not wall-clock time, since a machine that is busy changes them less; the client's own time is not counted.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import threading
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]


def look(url):
    """Follows the render as the page does: news, and each new image."""
    state, image = None, 0
    try:
        while not (state and state["hasEnded"]):
            state = json.load(urllib.request.urlopen(f"{url}state" + (f"?after={state['number']}" if state else ""), timeout=30))
            if state["image"] != image:
                image = state["image"]
                urllib.request.urlopen(f"{url}values?channels=R,G,B", timeout=30).read()
            threading.Event().wait(0.2)
    except OSError:
        pass   # the program has ended
    return image


def cpu_seconds(program, scene, options, watched, follows):
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen([program, "render", scene, "-o", "a.png", *options, *(["--view"] if watched else [])], cwd=folder,
                                   stderr=subprocess.PIPE, text=True)
        if follows:
            look(next(line for line in process.stderr if line.startswith("view: ")).split()[1])
        process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
        assert status == 0, f"status {status}"
        return usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "scenes" / "cornell-box.pbrt")
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("options", nargs="*", help="for render, after --")
    o = parser.parse_args()
    kinds = {"without": (False, False), "served": (True, False), "watched": (True, True)}
    seconds = {kind: [] for kind in kinds}
    for _ in range(o.rounds):
        for kind, (watched, follows) in kinds.items():
            seconds[kind].append(cpu_seconds(o.program.resolve(), o.scene.resolve(), o.options, watched, follows))
    ratios = {kind: statistics.median(b / a for a, b in zip(seconds["without"], all_of)) for kind, all_of in seconds.items()}
    if o.json:
        print(json.dumps({"seconds": seconds, "ratios": ratios}))
    else:
        for kind, all_of in seconds.items():
            print(f"{kind:8} {statistics.median(all_of):8.2f} s of CPU, x {ratios[kind]:.4f}")


if __name__ == "__main__":
    main()
