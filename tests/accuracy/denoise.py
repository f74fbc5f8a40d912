#!/usr/bin/env python3
"""What denoising does to the error: the table of docs/denoise.md. Renders scenes with few samples, denoises them, and compares both images with
one of many samples. Needs Intel Open Image Denoise: docs/denoise.md says how to get it.

    EIKONAL_OIDN=/path/to/libOpenImageDenoise.so.2 tests/accuracy/denoise.py SCENE... [--program build/eikonal]
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def compare(program, image, reference):
    report = json.loads(subprocess.run([program, "compare", image, reference, "--json"], check=True, capture_output=True, text=True).stdout)
    return report["relativeMse"], report["flip"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+", type=Path)
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--resolution", default="320x240")
    parser.add_argument("--spp", type=int, nargs="+", default=[4, 16, 64])
    parser.add_argument("--reference-samples", type=int, default=2048)
    options = parser.parse_args()
    program = options.program.resolve()
    print("| scene | samples | relMSE, noisy | denoised | noisy / denoised | FLIP, noisy | denoised |\n|---|--:|--:|--:|--:|--:|--:|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        def render(scene, name, samples, seed):
            file = Path(folder) / name
            subprocess.run([program, "render", scene, "-o", file, "--aov", "albedo,normal", "--resolution", options.resolution,
                            "--spp", str(samples), "--seed", str(seed), "--log-level", "error"], check=True)
            return file

        for scene in options.scenes:
            reference = render(scene, "reference.exr", options.reference_samples, 1)
            for samples in options.spp:
                noisy, clean = render(scene, "noisy.exr", samples, 0), Path(folder) / "clean.exr"
                subprocess.run([program, "denoise", noisy, "-o", clean], check=True, stderr=subprocess.DEVNULL)
                (error, flip), (error_left, flip_left) = compare(program, noisy, reference), compare(program, clean, reference)
                print(f"| `{scene.parent.name if scene.stem.startswith('scene') else scene.stem}` | {samples} | {error:.2g} | {error_left:.2g} "
                      f"| {error / error_left:.1f} | {flip:.3f} | {flip_left:.3f} |", flush=True)


if __name__ == "__main__":
    main()
