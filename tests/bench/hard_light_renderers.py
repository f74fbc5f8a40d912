"""The renderers of hard_light.py: what renders a scene with so many samples for each pixel, and says how long rendering took.

All render at wavelengths into PFM files, images WIDTH pixels wide. Seconds are of rendering alone, as each program prints them: without reading the scene,
compiling kernels and building hierarchies; what an integrator learns before its first sample counts.
"""

import json
import pathlib
import re
import subprocess

HEAD_DIRECTIVE = r'\b{}\s+"[^"]*"(?:\s*"\w+\s+\w+"\s*(?:\[[^\]]*\]|"[^"]*"|[^\s"\[\]]+))*'


def run(*command):
    """Standard output and errors of a program that has to succeed."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))} failed:\n{done.stdout[-2000:]}")
    return done.stdout


class Scene:
    """A pbrt scene, and what is asked of its image."""

    def __init__(self, name, path, width, program):
        self.name, self.path = name, path.resolve()
        about = json.loads(run(program, "info", self.path, "--json"))
        self.depth, self.media = about["maxDepth"], about["counts"]["media"] > 0
        self.width, self.height = width, max(1, round(width * about["height"] / about["width"]))


class Eikonal:
    """options: of the command line, which select the integrator."""

    def __init__(self, program, threads, *options):
        self.command = [program, "render", "--color", "spectral", "--nthreads", threads, "--stats", *options]

    def render(self, scene, samples, seed, image):
        told = run(*self.command, scene.path, "--resolution", f"{scene.width}x{scene.height}", "--spp", samples, "--seed", seed, "-o", image)
        return float(re.findall(r"^  render +([\d.]+) s", told, re.MULTILINE)[-1])


class Pbrt:
    """pbrt-v4 with one of its integrators. Files that a scene names are found beside its copy in `folder`, by links.

    Samples are iterations of sppm, and mutations per pixel of mlt, which begins with fewer paths than by default: those take longer than a short render."""

    BOOTSTRAP_PATHS = 200000   # of all lengths together; by default 100,000 of each

    def __init__(self, program, threads, integrator, folder, radius=None):
        self.program, self.threads, self.integrator, self.folder, self.radius = program, threads, integrator, folder, radius

    def copy(self, scene):
        """The scene with another integrator, sampler and resolution."""
        self.folder.mkdir(parents=True, exist_ok=True)
        for file in scene.path.parent.iterdir():
            link = self.folder / file.name
            if not link.is_symlink():
                link.symlink_to(file)
        head, world, rest = scene.path.read_text().partition("WorldBegin")
        head = re.sub(r'#[^\n"]*$', "", head, flags=re.MULTILINE)
        for directive in ("Integrator", "Sampler"):
            head = re.sub(HEAD_DIRECTIVE.format(directive), "", head)
        for axis, size in (("x", scene.width), ("y", scene.height)):
            head = re.sub(rf'("integer {axis}resolution"\s*)(\[[^\]]*\]|\S+)', rf"\g<1>[ {size} ]", head)
        more = {"sppm": f'"float radius" {self.radius}', "mlt": f'"integer bootstrapsamples" {self.BOOTSTRAP_PATHS // (scene.depth + 1)}'}.get(self.integrator, "")
        file = self.folder / f"hard-light-{scene.name}-{self.integrator}.pbrt"
        file.write_text(f'Integrator "{self.integrator}" "integer maxdepth" {scene.depth} {more}\nSampler "halton" "integer pixelsamples" 16\n{head}{world}{rest}')
        return file

    def render(self, scene, samples, seed, image):
        told = run(self.program, "--nthreads", self.threads, "--spp", samples, "--seed", seed, "--outfile", image, self.copy(scene))
        ended = [re.findall(r"\(([\d.]+)s\)", line) for line in told.split("\n")]   # each phase rewrites its own line until it has ended
        return sum(float(seconds[-1]) for seconds in ended if seconds)


def first_radius(program, scene, image):
    """World units within which Eikonal's sppm merges in its first pass. None: it does not merge in this scene."""
    told = run(program, "render", scene.path, "--integrator", "sppm", "--resolution", f"{scene.width}x{scene.height}", "--spp", 1, "--stats", "-o", image)
    found = re.search(r"merged within ([\d.e+-]+)", told)
    return float(found[1]) if found else None


def samples_for(renderer, scene, seconds, image):
    """How many samples fill the seconds, by two short renders: a constant time and a time for each sample."""
    samples, before = 1, None
    while True:
        taken = renderer.render(scene, samples, 1, image)
        if before and (taken > 0.15 * seconds or samples >= 1 << 16):
            each = max(taken - before[1], 0.2 * taken) / (samples - before[0])
            return max(1, round(samples + (seconds - taken) / each))
        samples, before = (samples * 4, (samples, taken))
