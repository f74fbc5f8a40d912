#!/usr/bin/env python3
"""The same scenes on two OpenCL devices, by turns: which is faster, and how far the images differ.

    tests/bench/devices.py --devices Portable,Intel SCENE ...

Intel's runtime for processors is on PyPI; no installation but this, and OCL_ICD_VENDORS and LD_LIBRARY_PATH set, makes it a device:
    python3 -m venv intel && intel/bin/pip install intel-opencl-rt intel-cmplr-lib-rt
    mkdir vendors && cp /etc/OpenCL/vendors/*.icd vendors && realpath intel/lib/libintelocl.so > vendors/intel.icd
    export OCL_ICD_VENDORS=$PWD/vendors LD_LIBRARY_PATH=$PWD/intel/lib
Prints a row for each scene.
"""

import argparse
import json
import pathlib
import statistics
import tempfile

from paths import ROOT, bench, run


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenes", nargs="+", type=pathlib.Path)
    options.add_argument("--devices", default="Portable,Intel", help="two of them, as --device takes them")
    options.add_argument("--program", type=pathlib.Path, default=ROOT / "build" / "eikonal")
    options.add_argument("--samples", type=int, default=8)
    options.add_argument("--rounds", type=int, default=3)
    o = options.parse_args()
    devices = o.devices.split(",")
    print(f"| scene | {devices[0]}, M paths/s | {devices[1]} | ratio | relative MSE between the images |\n|---|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in o.scenes:
            rates = {device: [] for device in devices}
            for device in devices:
                run([o.program, "render", scene, "--device", device, "--spp", o.samples, "-o", folder / f"{device}.exr", "--quiet"])
            for _ in range(o.rounds):
                for device in devices:
                    figures = bench(o.program, scene, folder, "--device", device, "--spp", o.samples, "--repeats", 1)
                    rates[device].append(figures["pathsPerSecond"] * 1e-6)
            comparison = json.loads(run([o.program, "compare", folder / f"{devices[1]}.exr", folder / f"{devices[0]}.exr", "--json"]))
            first, second = (statistics.median(rates[device]) for device in devices)
            print(f"| {scene.parent.name}/{scene.name} | {first:.2f} | {second:.2f} | {second / first:.2f} | {comparison['relativeMse']:.2g} |", flush=True)


if __name__ == "__main__":
    main()
