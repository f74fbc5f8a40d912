#!/usr/bin/env python3
"""Makes docs/gallery.md and its pictures: one for each thing that the tables of the README's "What it renders" name.

    docs/gallery.py --program build/eikonal [NAME ...]   renders the pictures (of these names), and writes the page
    docs/gallery.py --program build/eikonal --check      renders them in a temporary folder; status 1 if one differs from the kept one
    docs/gallery.py --page                               writes the page only
    docs/gallery.py --complete                           renders nothing; status 1 if the README names
                                                         something without a picture, or the page is not up to date

A picture is declared once, below: what of the README it shows, its scene, and options of its own. Its sentence is the first line
of its scene, or stands here. Another compiler may round differently, so --check allows a mean FLIP error of 0.05, of
images compressed as JPEG.
"""
import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE, PICTURES, SCENES = ROOT / "docs" / "gallery.md", ROOT / "docs" / "pictures", ROOT / "scenes"
LARGEST_FLIP = 0.05
COLUMNS, WIDTH = 3, ' width="280"'  # of all pictures but those whose pixels are to be told apart
# What may stay of the README's text when all names are taken out of it.
CONNECTING = {"and", "or", "with", "of", "a", "by", "for", "the", "in", "them", "meshes", "noise", "environments", "filters", "files",
              "integrators", "compared"}


def show(names, scene, options="", sentence="", name=""):
    """A picture of what the README calls `names` (separated by ;), of scenes/gallery/SCENE.pbrt or of scenes/SCENE with its extension."""
    path = SCENES / scene if "." in scene else SCENES / "gallery" / f"{scene}.pbrt"
    first = path.read_text(encoding="utf-8").splitlines()[0].lstrip("# ")
    return {"names": [n.strip() for n in names.split(";")], "scene": path, "options": options, "sentence": sentence or first,
            "name": name or path.stem}


GALLERY = {
    "shapes": [
        show("triangle; bilinear", "meshes"),
        show("PLY; displacement", "ply-displacement"),
        show("spheres; disks; cylinders", "quadrics"),
        show("curves", "curves"),
        show("Loop subdivision", "loopsubdiv"),
        show("implicit surfaces given by a formula", "implicit.pbrt", "--resolution 480x160",
             "A gyroid of gold, a torus of glass, Steiner's Roman surface and Barth's sextic, each given by its equation"),
        show("object instances", "instances.pbrt", "--resolution 320x200", "A stool that is stored once, and seen nine times"),
        show("alpha cut-outs; bump; normal maps", "textures.pbrt", "--resolution 480x180 --spp 96",
             "Bricks as colour, with bumps, and as normals of a metal; a leaf that its alpha cuts out; a mixture of two colours"),
    ],
    "materials": [
        show("diffuse", "diffuse"),
        show("coated diffuse", "coateddiffuse"),
        show("conductor", "conductor"),
        show("coated conductor", "coatedconductor"),
        show("dielectric; dispersion", "dielectric"),
        show("thin dielectric", "thindielectric"),
        show("diffuse transmission", "diffusetransmission"),
        show("hair", "hair"),
        show("measured", "measured"),
        show("subsurface; diffusion; random walk", "subsurface", "--color rgb --spp 256"),
        show("principled (OBJ)", "model.obj",
             "--resolution 320x240 --spp 256 --camera 1.7,2.1,5.4 --look-at 0,.9,-.3 --fov 30 --exposure 1 --integrator vcm",
             "Materials of an OBJ file: painted wood, brass and glass, under a lamp", "principled"),
        show("mix", "mix"),
        show("interface", "interface"),
    ],
    "textures": [
        show("images", "image"),
        show("checkerboards", "checkerboard"),
        show("dots", "dots"),
        show("bilinear", "bilerp"),
        show("mix", "mixed"),
        show("scale", "scaled"),
        show("fBm noise", "fbm"),
        show("wrinkled", "wrinkled"),
        show("windy", "windy"),
        show("marble", "marble"),
    ],
    "lights": [
        show("point", "point"),
        show("spot", "spot"),
        show("distant", "distant"),
        show("goniometric", "goniometric"),
        show("projection", "projection"),
        show("area", "area"),
        show("constant", "environment-constant"),
        show("image", "environment-image"),
        show("portals", "portal"),
        show("a light tree for many", "many"),
    ],
    "media": [
        show("homogeneous", "homogeneous", "--spp 256"),
        show("grids of density", "grid"),
        show("colour", "rgbgrid"),
        show("clouds", "cloud", "--spp 48"),
        show("NanoVDB", "nanovdb"),
        show("nested", "nested"),
        show("emissive", "emissive", "--exposure 1"),
        show("chromatic", "chromatic"),
        show("the camera inside", "medium.pbrt", "--resolution 256x160 --spp 384",
             "Thin fog in the whole room, around the camera too; a cloud in it, and a ball of tinted water"),
    ],
    "cameras": [
        show("perspective; thin lens", "thinlens"),
        show("orthographic", "orthographic"),
        show("spherical", "spherical"),
        show("realistic lenses", "realistic"),
        show("motion of cameras", "motion-camera"),
        show("shapes; instances", "motion-shapes"),
        show("box", "filter-box"),
        show("triangle", "filter-triangle"),
        show("Gaussian", "filter-gaussian"),
        show("Mitchell", "filter-mitchell"),
        show("sinc", "filter-sinc"),
    ],
    "transport": [
        show("path tracing; next-event estimation; multiple importance sampling; Russian roulette", "cornell-box.pbrt",
             "--resolution 240x240 --spp 256", "Paths from the camera: at each of their points a light is sampled, too"),
        show("paths from the lights for caustics", "water-pool.pbrt", "--spp 128 --exposure 1.3",
             "Waves focus the light of a lamp on the bottom of a pool; paths from both ends merge there"),
        show("beams in fog", "fog-caustic", "--spp 512 --exposure .7"),
        show("adaptive sampling", "environment.pbrt", "--resolution 320x240 --max-error 3% --spp 1024",
             "Samples where they lower the error most, until it is 3 %"),
        show("Whitted ray tracing; ray splitting", "whitted"),
        show("direct lighting", "cornell-box.pbrt", "--resolution 240x240 --spp 128 --integrator direct",
             "Light that was scattered once", "direct"),
        show("ambient occlusion", "instances.pbrt", "--resolution 320x200 --integrator ambientocclusion",
             "How much of the sky each point sees", "ambient-occlusion"),
        show("Owen-scrambled Sobol'", "cornell-box.pbrt", "--resolution 160x160 --spp 4",
             "Four samples a pixel, whose errors cancel among neighbours", "sobol"),
        show("Owen-scrambled Sobol'", "cornell-box.pbrt", "--resolution 160x160 --spp 4 --sampler independent",
             "The same with independent random numbers", "independent"),
    ],
}


def picture(row):
    return PICTURES / f"{row['name']}.jpg"


def command(row, image):
    return f"eikonal render {row['scene'].relative_to(ROOT)} {row['options']}{' ' * bool(row['options'])}-o {image}"


def page():
    """The text of docs/gallery.md."""
    lines = ["# Gallery", "",
             "A picture of everything that the tables of the [README](../README.md#what-it-renders) name, with its scene and the command",
             "that makes it.",
             "`docs/gallery.py` declares the pictures, renders them, and writes this page; `docs/gallery.py --check` compares them",
             "with what the program renders now.", ""]
    for section, rows in GALLERY.items():
        lines += [f"## {section[0].upper()}{section[1:]}", "", "<table>"]
        for i in range(0, len(rows), COLUMNS):
            lines.append("<tr>")
            for row in rows[i:i + COLUMNS]:
                scene, width = row["scene"].relative_to(ROOT), WIDTH * ("filter" not in row["name"])
                lines += ['<td valign="top">', f'<img src="pictures/{picture(row).name}"{width} alt="{row["sentence"]}"><br>',
                          f"<b>{', '.join(row['names'])}</b>: {row['sentence']}<br>",
                          f'<a href="../{scene}">{scene.name}</a>: <code>{command(row, picture(row).name)}</code>', "</td>"]
            lines.append("</tr>")
        lines += ["</table>", ""]
    return "\n".join(lines)


def problems():
    """What the README names and no picture shows, pictures that are not there, and a page that is not up to date."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8").split("## What it renders")[1].split("\n## ")[0]
    tables = dict(re.findall(r"^\| (\w+) \| (.+) \|$", readme, re.MULTILINE))
    for section in tables.keys() ^ GALLERY.keys():
        yield f"{section}: a row of the README or a section of the gallery, but not both"
    for section in tables.keys() & GALLERY.keys():
        text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", tables[section])
        names = {name for row in GALLERY[section] for name in row["names"]}
        for name in sorted(names, key=len, reverse=True):
            found = re.sub(rf"(?<!\w){re.escape(name)}(?!\w)", "", text, count=1)
            if found == text:
                yield f"{section}: the README does not name {name}"
            text = found
        for word in re.findall(r"[\w'-]+", text):
            if word not in CONNECTING:
                yield f"{section}: the README names {word}, of which there is no picture"
    rows = [row for section in GALLERY.values() for row in section]
    for row in rows:
        if not picture(row).exists():
            yield f"{picture(row).relative_to(ROOT)} does not exist: docs/gallery.py --program build/eikonal {row['name']}"
    for unused in {p.name for p in PICTURES.glob("*.jpg")} - {picture(row).name for row in rows}:
        yield f"docs/pictures/{unused} is not in the gallery"
    if not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        yield "docs/gallery.md is not up to date: docs/gallery.py --page"


def render(program, row, image):
    words = command(row, image).split()
    subprocess.run([program, *words[1:], "--log-level", "error"], check=True, cwd=ROOT)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", help="pictures to make; all if there is none")
    parser.add_argument("--program", type=Path, default=ROOT / "build" / "eikonal")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--complete", action="store_true")
    options = parser.parse_args()
    if options.complete:
        found = list(problems())
        print("\n".join(found))
        return int(bool(found))
    rows = [row for section in GALLERY.values() for row in section if not options.names or row["name"] in options.names]
    program, differing = options.program.resolve(), 0
    with tempfile.TemporaryDirectory() as folder:
        for row in [] if options.page else rows:
            image = Path(folder) / picture(row).name if options.check else picture(row)
            render(program, row, image)
            agrees = not options.check or subprocess.run([program, "compare", image, picture(row), "--fail-above", str(LARGEST_FLIP)],
                                                         stdout=subprocess.DEVNULL).returncode == 0
            differing += not agrees
            print(f"{picture(row).relative_to(ROOT)}: {'DIFFERS' if not agrees else 'agrees' if options.check else 'made'}", flush=True)
    if not options.check:
        PAGE.write_text(page(), encoding="utf-8")
    return int(differing > 0)


if __name__ == "__main__":
    sys.exit(main())
