#!/usr/bin/env python3
"""Kubernetes: the manifests that `submit` writes fit the schema of Kubernetes, and their scripts, run as its pods would, make the image.

    tests/farm/kubernetes.py [--program build/eikonal]

Installs kubernetes-validate of PyPI, which carries the schema, into a folder of its own; skipped without it or without kubectl. There is no
cluster: the test runs what containers would.
"""

import json
import os
import pathlib
import shutil

from farm_test import SCENE, environment_with, expect, pixels_of, program, run, scratch, skip


def main():
    eikonal = program()
    if not shutil.which("kubectl"):
        skip("kubectl is missing, which fills in numbers and places (kubectl kustomize)")
    with scratch() as name:
        top = pathlib.Path(name)
        tools = environment_with(top / "venv", "kubernetes-validate", "pyyaml")
        (top / "scene").mkdir()
        scene = top / "scene" / "My Box_1.pbrt"
        shutil.copy(SCENE, scene)
        settings = ["--spp", "64", "--resolution", "48x32"]
        folder = top / "scene" / "a job"
        run(eikonal, "submit", scene, "--engine", "kubernetes", "--dry-run", "--tiles", 3, "--sample-ranges", 2, "--folder", folder, *settings,
            "-o", top / "scene" / "image.exr", "-o", top / "scene" / "all.film")
        manifests = top / "manifests.yaml"
        manifests.write_text(run("kubectl", "kustomize", folder))
        print(run(f"{tools}/kubernetes-validate", "--strict", manifests, folder / "job.yaml"))

        # As pods would run: each index of the Job, then the merge
        reader = top / "as_json.py"
        reader.write_text("import json, sys, yaml\nprint(json.dumps([j for j in yaml.safe_load_all(open(sys.argv[1])) if j]))\n")
        jobs = {job["metadata"]["name"]: job["spec"] for job in json.loads(run(f"{tools}/python", reader, manifests))}
        expect(set(jobs) == {"my-box-1-parts", "my-box-1-merge"}, "the Jobs have the scene's name")
        parts = jobs["my-box-1-parts"]
        expect(parts["completions"] == 6 and parts["completionMode"] == "Indexed", "the Job has an index for each part")
        (top / "bin").mkdir()
        (top / "bin" / "eikonal").symlink_to(eikonal)
        for spec, indices in ((parts, range(6)), (jobs["my-box-1-merge"], [0])):
            container = spec["template"]["spec"]["containers"][0]
            expect(container["volumeMounts"][0]["mountPath"] == str(top / "scene"), "the shared folder is seen where it is")
            variables = {each["name"]: each["value"] for each in container["env"]} | {"PATH": f"{top / 'bin'}:{os.environ['PATH']}"}
            variables["EIKONAL_CACHE_DIR"] = os.environ.get("EIKONAL_CACHE_DIR", os.path.expanduser("~/.cache/eikonal"))
            for index in indices:
                run(*container["command"], *container["args"], env=os.environ | variables | {"JOB_COMPLETION_INDEX": str(index)})
        run(eikonal, "render", scene, *settings, "-o", top / "whole.film")
        expect(pixels_of(top / "scene" / "all.film") == pixels_of(top / "whole.film"), "all sums have the bits of one run")


if __name__ == "__main__":
    main()
