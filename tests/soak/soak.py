#!/usr/bin/env python3
"""Renders random scenes with random settings, ends them by random signals at random moments, and checks that nothing is lost.

A trial renders a scene twice undisturbed. Then it renders it again, killed (SIGKILL, SIGTERM, SIGHUP, SIGINT) and resumed from its
checkpoint; or in parts, tiles times ranges of samples, some of them killed and resumed, which are merged in random order and perhaps in
steps; each time with other threads and another wave. Every channel must have the same bits. Exit statuses must be as documented, the time
that a checkpoint holds must never shrink, no temporary file may stay, and the checkpoint that is there must always be whole. Now and then
one process renders many frames, whose memory may not grow.

Trial i of seed S is the same in every run, but for the moments: a share of the time that an undisturbed render took. Prints each problem,
keeps its folder, and exits with 1. --json keeps the figures; docs/reliability.md shows those of one run.
"""
import argparse
import json
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from checks import Problem, bits_of, memory_of, seconds_kept

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
MOST_SECONDS = 600        # of one run, on a busy machine
STOP_SECONDS = 20         # until a signal has ended it; also while kernels compile
GROWTH = 16 << 20         # bytes that the second half of the frames may add: what allocators keep
SCENES = ("scenes/*.pbrt", "scenes/*.obj", "scenes/gallery/*.pbrt", "../shared/gallery/*.pbrt")


def heed_signals():
    """Under nohup, the program would ignore SIGHUP as it should."""
    for number in SIGNALS:
        if number != signal.SIGKILL:
            signal.signal(number, signal.SIG_DFL)


class Soak:
    def __init__(self, program, scenes, seed):
        self.program, self.scenes, self.seed = program, scenes, seed
        self.figures = {"trials": 0, "impossible": 0, "runs": 0, "signals": {s.name: 0 for s in SIGNALS}, "came_after_the_end": 0,
                        "resumed": 0, "parts": 0, "merges": 0, "images_compared": 0, "frames": 0, "largest_growth_bytes": 0,
                        "slowest_stop_seconds": 0.0, "scenes": set()}
        self.problems = []

    def start(self, folder, *words):
        self.figures["runs"] += 1
        self.commands.append(" ".join(map(str, words)))
        return subprocess.Popen([self.program, *map(str, words)], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                preexec_fn=heed_signals)

    def run(self, folder, *words, statuses=(0,)):
        process = self.start(folder, *words)
        try:
            _, errors = process.communicate(timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            raise Problem(f"did not end in {MOST_SECONDS} s: {self.commands[-1]}")
        if process.returncode not in statuses:
            raise Problem(f"status {process.returncode} instead of {statuses}: {self.commands[-1]}\n{errors}")
        return process.returncode

    def end_early(self, dice, folder, whole_seconds, film, *words):
        """Starts a render, and sends it a signal. Returns whether it was ended by it."""
        before = seconds_kept(folder / film)
        process = self.start(folder, *words)
        number, wait = dice.choice(SIGNALS), dice.uniform(0, 1.1) * whole_seconds
        try:
            process.communicate(timeout=wait)
            self.figures["came_after_the_end"] += 1
        except subprocess.TimeoutExpired:
            process.send_signal(number)
            begin = time.monotonic()
            try:
                process.communicate(timeout=STOP_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
                raise Problem(f"{number.name} after {wait:.2f} s: still running {STOP_SECONDS} s later: {self.commands[-1]}")
            self.figures["slowest_stop_seconds"] = max(self.figures["slowest_stop_seconds"], time.monotonic() - begin)
            self.figures["signals"][number.name] += 1
        kept = seconds_kept(folder / film)
        if kept < before:
            raise Problem(f"the checkpoint held {before} s of rendering, and holds {kept} s after {number.name}: {self.commands[-1]}")
        # -N: before the program has its handlers, or by SIGKILL; 128 + N: with the image on disk.
        if process.returncode not in (0, -number, 128 + number):
            raise Problem(f"status {process.returncode} after {number.name}, sent after {wait:.2f} s: {self.commands[-1]}")
        return process.returncode != 0

    def render_with_kills(self, dice, folder, seconds, film, words):
        """Renders until it is whole, whatever ends it meanwhile."""
        for _ in range(dice.randint(0, 3)):
            if not self.end_early(dice, folder, seconds, film, *words):
                return
            self.figures["resumed"] += 1
        self.run(folder, *words)

    def settings(self, dice, scene):
        words = ["--resolution", f"{dice.randint(2, 96)}x{dice.randint(2, 72)}",
                 "--spp", dice.choice((1, 17, 40, 64, 100, 300, 1000, 3000)), "--seed", dice.randint(0, 9), "--color", dice.choice(("rgb", "spectral", "auto")),
                 "--sampler", dice.choice(("independent", "paddedsobol", "sobol", "zsobol"))]
        if dice.random() < 0.5:
            words += ["--integrator", dice.choice(("path", "volpath", "bdpt", "direct", "simplepath", "vcm", "sppm"))]
        if dice.random() < 0.4:
            words += ["--aov", dice.choice(("all", "passes", "variance,sampleCount", "albedo,normal"))]
        return words

    def place(self, dice):
        """What changes speed only."""
        return ["--nthreads", dice.choice((1, 2)), "--wave-paths", dice.choice((4096, 16384, 65536))]

    def trial(self, number):
        dice = random.Random(f"{self.seed}/{number}")
        scene = dice.choice(self.scenes)
        self.commands = []
        folder = pathlib.Path(tempfile.mkdtemp(prefix=f"eikonal soak {number} "))
        try:
            if number % 12 == 11:
                self.frames(dice, folder)
            else:
                self.images(dice, folder, scene)
            left = [f.name for f in folder.iterdir() if f.name.startswith(".") or f.suffix == ".part"]
            if left:
                raise Problem(f"temporary files are left: {' '.join(left)}")
            shutil.rmtree(folder)
        except Problem as problem:
            self.problems.append({"trial": number, "scene": scene.name, "problem": str(problem), "commands": self.commands,
                                  "folder": str(folder)})
            print(f"trial {number} of seed {self.seed}, {scene}: {problem}\n  kept in {folder}", flush=True)
        self.figures["trials"] += 1

    def images(self, dice, folder, scene):
        settings = [scene, *self.settings(dice, scene), "--quiet"]
        # Some settings do not go together, which is an error of the command line or the scene, and no trial.
        if self.run(folder, "render", *settings, *self.place(dice), "-o", "whole.exr", statuses=(0, 1, 2)) != 0:
            self.figures["impossible"] += 1
            return
        # Its kernels are compiled now: this is what the disturbed renders take.
        begin = time.monotonic()
        self.run(folder, "render", *settings, *self.place(dice), "-o", "other.exr")
        seconds = time.monotonic() - begin
        self.figures["scenes"].add(scene.name)
        if dice.random() < 0.5:
            words = ["render", *settings, *self.place(dice), "-o", "again.exr", "--checkpoint", "c.film", "--resume",
                     "--checkpoint-every", f"{dice.choice((0.02, 0.1, 0.5))}s"]
            self.render_with_kills(dice, folder, seconds, "c.film", words)
        else:
            self.parts(dice, folder, settings, seconds)
        for name in ("other.exr", "again.exr"):
            self.figures["images_compared"] += 1
            if bits_of(folder / "whole.exr") != bits_of(folder / name):
                raise Problem(f"the bits of {name} differ")

    def parts(self, dice, folder, settings, seconds):
        spp = int(settings[settings.index("--spp") + 1])
        width, height = map(int, settings[settings.index("--resolution") + 1].split("x"))
        tiles, ranges = dice.randint(1, min(3, width, height)), dice.randint(1, min(3, (spp + 15) // 16))
        names = []
        for tile in range(1, tiles + 1):
            for part in range(1, ranges + 1):
                names.append(f"{tile}-{part}.film")
                words = ["render", *settings, *self.place(dice), "--tile", f"{tile}/{tiles}", "--samples", f"{part}/{ranges}",
                         "-o", names[-1], "--resume", "--checkpoint-every", "0.05s"]
                self.render_with_kills(dice, folder, seconds / (tiles * ranges), names[-1], words)
                self.figures["parts"] += 1
        dice.shuffle(names)
        if len(names) > 2 and dice.random() < 0.5:
            some = names[: dice.randint(2, len(names) - 1)]
            self.run(folder, "merge", *some, "-o", "some.film", "--quiet")
            self.figures["merges"] += 1
            names = ["some.film", *names[len(some):]]
        self.run(folder, "merge", *names, "-o", "again.exr", "--quiet")
        self.figures["merges"] += 1

    def frames(self, dice, folder):
        """One process renders frames; its memory is read while it runs."""
        count = 60
        process = self.start(folder, "render", ROOT / "scenes/model.obj", "--turntable", count, "--resolution", "32x32", "--spp", 4,
                             "--seed", dice.randint(0, 9), "--quiet", "-o", "f.####.exr")
        memory = {}
        while process.poll() is None:
            done = len(list(folder.glob("f.*.exr")))
            memory[done] = max(memory.get(done, 0), memory_of(process.pid))
            time.sleep(0.02)
        errors = process.stderr.read()
        if process.returncode != 0 or len(list(folder.glob("f.*.exr"))) != count:
            raise Problem(f"status {process.returncode}, {len(list(folder.glob('f.*.exr')))} of {count} frames: {errors}")
        self.figures["frames"] += count
        early, late = (max((m for done, m in memory.items() if low <= done < high), default=0)
                       for low, high in ((count // 4, count // 2), (count // 2, count)))
        growth = late - early
        self.figures["largest_growth_bytes"] = max(self.figures["largest_growth_bytes"], growth)
        if growth > GROWTH:
            raise Problem(f"memory grew by {growth} bytes in the second half of {count} frames")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/eikonal")
    parser.add_argument("--minutes", type=float, default=20, help="default: %(default)s")
    parser.add_argument("--seed", type=int, default=1, help="default: %(default)s")
    parser.add_argument("--trial", type=int, help="only this trial of the seed")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures there")
    args = parser.parse_args()
    scenes = sorted(scene for pattern in SCENES for scene in ROOT.glob(pattern))
    soak = Soak(args.program.resolve(), scenes, args.seed)
    begin, number = time.monotonic(), args.trial or 0
    while not soak.problems or args.trial is None:
        soak.trial(number)
        number += 1
        if args.trial is not None or time.monotonic() - begin > 60 * args.minutes:
            break
    figures = {"seed": args.seed, "minutes": round((time.monotonic() - begin) / 60, 1), **soak.figures,
               "scenes": len(soak.figures["scenes"]), "problems": soak.problems}
    if args.json:
        args.json.write_text(json.dumps(figures, indent=1) + "\n")
    print(json.dumps({k: v for k, v in figures.items() if k != "problems"}))
    sys.exit(1 if soak.problems else 0)


if __name__ == "__main__":
    main()
