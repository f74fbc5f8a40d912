#!/usr/bin/env python3
"""Fuzzes the readers with libFuzzer, under the address and undefined-behaviour sanitizers, one target after the other.

Builds build-fuzz (or --build) with clang 16 (Debian: clang-16). New inputs that reach other code are gathered in BUILD/corpus/TARGET, for
the next run. What crashes, hangs (--timeout) or takes 1 GiB lands in BUILD/found, and the exit status is 1: fix it, and keep the file in
tests/fuzz/findings/TARGET, where the test FuzzReplay reads it again. Prints one line for each target. Exits with 77 without clang 16.
"""
import argparse
import os
import re
import resource
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FUZZ = ROOT / "tests/fuzz"
TARGETS = re.findall(r'\{"(\w+)", run\w+\}', (FUZZ / "targets.cpp").read_text())
# These ask for memory that they only take as far as the file fills it.
PROMISED = ("image", "nanovdb", "merge")


def build(folder):
    compiler = shutil.which("clang++-16")
    if not compiler:
        print("clang++-16 is missing (Debian: clang-16): nothing is fuzzed")
        sys.exit(77)
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}", "-DEIKONAL_FUZZ=ON",
                        f"-DCMAKE_C_COMPILER={shutil.which('clang-16')}", "-DEIKONAL_TESTS=OFF", "-DEIKONAL_WERROR=OFF",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "fuzzer"], check=True, stdout=subprocess.DEVNULL)


def fuzz(target, args):
    """Runs a target. Returns whether it found nothing."""
    gathered, found = args.build / "corpus" / target, args.build / "found"
    gathered.mkdir(parents=True, exist_ok=True)
    found.mkdir(exist_ok=True)
    kept = [f for f in (FUZZ / "corpus" / target, FUZZ / "findings" / target) if f.is_dir()]
    dictionary = FUZZ / "words" / f"{'pbrt' if target == 'scene' else target}.txt"
    command = [args.build / "fuzzer", *([f"-dict={dictionary}"] if dictionary.exists() else []),
               f"-max_total_time={args.seconds}", f"-timeout={args.timeout}", f"-seed={args.seed}", "-max_len=16384", "-rss_limit_mb=3000",
               f"-malloc_limit_mb={16384 if target in PROMISED else 1024}", "-print_final_stats=1",
               f"-artifact_prefix={found}/{target}-", gathered, *kept]
    # Memory that is not to be had is null, as without the sanitizer. OpenImageIO keeps its last error for each thread, and never frees it.
    env = os.environ | {"EIKONAL_FUZZ_TARGET": target, "ASAN_OPTIONS": f"allocator_may_return_null=1:detect_leaks={int(target != 'image')}",
                        "UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1"}
    log = args.build / f"{target}.log"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(log, "w") as output:
        status = subprocess.run(command, env=env, stdout=output, stderr=output).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    text = log.read_text(errors="replace")
    runs = re.search(r"number_of_executed_units: (\d+)", text)
    covered = re.findall(r"cov: (\d+)", text)
    result = "nothing found" if status == 0 else f"FOUND, status {status}: see {log}"
    print(f"{target:11} {runs[1] if runs else '?':>9} runs in {seconds:.0f} s of processor time, {covered[-1] if covered else '?':>6} edges: {result}", flush=True)
    return status == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=f"which: {' '.join(TARGETS)} (default: all)")
    parser.add_argument("--seconds", type=int, default=120, help="for each target (default: %(default)s)")
    parser.add_argument("--timeout", type=int, default=60,
                        help="seconds, of a sanitized build on a busy machine, after which an input is a finding (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=1, help="default: %(default)s")
    parser.add_argument("--build", type=Path, default=ROOT / "build-fuzz")
    args = parser.parse_args()
    if unknown := set(args.targets) - set(TARGETS):
        parser.error(f"no target {' '.join(unknown)}; there are {' '.join(TARGETS)}")
    args.build = args.build.resolve()
    build(args.build)
    sys.exit(0 if all([fuzz(target, args) for target in args.targets or TARGETS]) else 1)


if __name__ == "__main__":
    main()
