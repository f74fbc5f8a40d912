"""Builds the program of a changed copy of the sources from the objects of this checkout's build: only what the changes reach is compiled."""
import json
import os
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from add_kinds import ROOT, words_in

# The targets of which the program consists; the second one is the library that the first one links.
PROGRAM, LIBRARY = "eikonal", "eikonal_host"
# Made by the build from the contract headers; the program carries it.
CARRIED = Path("generated/contract_headers.inc")


def can_build_from(build):
    """Whether a build folder has all objects of the program, and Ninja's record of what they depend on."""
    return (build / "build.ninja").exists() and (build / PROGRAM).exists()


def same(a, b):
    return a.exists() and b.exists() and a.read_bytes() == b.read_bytes()


def changed_files(tree):
    """The sources and headers of a copy, by their paths from the root, that are new in it or differ."""
    files = (f for folder in ("host", "include") for f in (tree / folder).rglob("*") if f.is_file())
    return {f.relative_to(tree) for f in files if not same(f, ROOT / f.relative_to(tree))}


def dependencies(build):
    """What each object was made from: {its path from the build folder: absolute paths}."""
    found, files = {}, set()
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        if line.startswith(" "):
            files.add((build / line.strip()).resolve())
        elif line.endswith("(VALID)"):
            files = found[line.split(":")[0]] = set()
    return found


def output_of(command):
    words = shlex.split(command["command"])
    return words[words.index("-o") + 1]


def carry_contract(tree):
    target = tree / "build" / CARRIED
    target.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["cmake", f"-DROOT={tree}/include", "-DPATTERNS=eikonal/*.h", f"-DOUTPUT={target}", "-P", tree / "cmake/embed_files.cmake"],
                   check=True)


def compile_in(tree, command, source, target):
    """Compiles a file of the copy with the command of one of this checkout. Says what the compiler does where it fails."""
    words = words_in(tree, command)
    words[words.index("-c"):words.index("-c")] = ["-iquote", str(tree / "build" / CARRIED.parent)]   # looked in first
    output = words.index("-o")
    words[output + 1], words[words.index("-c") + 1] = str(target), str(source)
    target.parent.mkdir(parents=True, exist_ok=True)
    for option in ("-MT", "-MF"):
        if option in words:
            words[words.index(option) + 1] = f"{target}.d"
    run = subprocess.run(words, cwd=command["directory"], capture_output=True, text=True)
    return run.stderr if run.returncode else ""


def build_changed(tree, build, sibling):
    """The program of the copy. Files that are new in it are compiled as `sibling` is, a path from the root."""
    changed, made_from = {ROOT / c for c in changed_files(tree)}, dependencies(build)
    if any(c.suffix == ".h" and c.parent.name == "eikonal" for c in changed):
        carry_contract(tree)
        changed.add(build / CARRIED)
    targets = (f"/{PROGRAM}.dir/host/", f"/{LIBRARY}.dir/host/")   # others compile some of the files, too
    listed = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    commands = {Path(c["file"]).relative_to(ROOT): c for c in listed if any(t in output_of(c) for t in targets)}

    objects, jobs = [], []
    for source, command in commands.items():
        output = output_of(command)
        reached = output not in made_from or made_from[output] & changed
        objects.append(tree / "build" / output if reached else build / output)
        if reached:
            jobs.append((command, tree / source, objects[-1]))
    for source in sorted(c.relative_to(ROOT) for c in changed if c.suffix == ".cpp" and c.relative_to(ROOT) not in commands):
        objects.append(tree / "build" / f"{source}.o")
        jobs.append((commands[Path(sibling)], tree / source, objects[-1]))
    print(f"{len(jobs)} of {len(objects)} files are to be compiled", flush=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        problems = [p for p in pool.map(lambda job: compile_in(tree, *job), jobs) if p]
    if problems:
        raise SystemExit("\n".join(["the changed program does not compile", *problems]))

    response = tree / "build" / "objects"
    response.write_text("\n".join(f'"{o}"' for o in objects), encoding="utf-8")
    link = subprocess.run(["ninja", "-C", build, "-t", "commands", PROGRAM], check=True, capture_output=True, text=True).stdout.splitlines()[-1]
    words = [w for w in shlex.split(link) if w not in (":", "&&") and not w.endswith(".o")]
    words[words.index(f"lib{LIBRARY}.a")] = f"@{response}"
    words[words.index("-o") + 1] = str(tree / "build" / PROGRAM)
    subprocess.run(words, cwd=build, check=True)
    return tree / "build" / PROGRAM
