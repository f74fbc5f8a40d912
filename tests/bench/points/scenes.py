"""Scenes with one kind of noise each, as text: a lens, rough surfaces, motion, many lamps; and pixels without edges or shadows."""

import random

HEAD = 'Film "rgb" "integer xresolution" 96 "integer yresolution" 96\nPixelFilter "box"\nIntegrator "path" "integer maxdepth" 5\n'
SKY = 'LightSource "infinite" "rgb L" [ .4 .45 .5 ]\n'
LAMP = """AttributeBegin
AreaLightSource "diffuse" "rgb L" [ 12 11 9 ] Material "diffuse" "rgb reflectance" [ 0 0 0 ]
Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] "point3 P" [ -2 6 -1  1 6 -1  1 6 2  -2 6 2 ]
AttributeEnd
"""


def quad(*corners):
    return 'Shape "bilinearmesh" "point3 P" [ ' + "  ".join(f"{x} {y} {z}" for x, y, z in corners) + " ]\n"


def ball(before, material, x, y, z, radius):
    return f'AttributeBegin {before} Material {material} Translate {x} {y} {z} Shape "sphere" "float radius" {radius} AttributeEnd\n'


FLOOR = ('Texture "checks" "spectrum" "checkerboard" "float uscale" 20 "float vscale" 20 "rgb tex1" [ .6 .6 .6 ] "rgb tex2" [ .2 .2 .2 ]\n'
         'Material "diffuse" "texture reflectance" "checks"\n' + quad((-10, 0, -10), (10, 0, -10), (-10, 0, 10), (10, 0, 10)))


def on_the_floor(camera, balls):
    return f'LookAt 0 2 -8  0 .5 0  0 1 0\nCamera "perspective" "float fov" 36 {camera}\n{HEAD}WorldBegin\n{SKY}{LAMP}{FLOOR}{"".join(balls)}'


def lens():
    colour = [f'"diffuse" "rgb reflectance" [ {.2 + .15 * (i % 4)} {.7 - .12 * (i % 5)} .4 ]' for i in range(16)]
    return on_the_floor('"float lensradius" .25 "float focaldistance" 8', [ball("", colour[i], (i % 4 - 1.5) * 1.4, .5, i // 4 * 2.2 - 3, .5) for i in range(16)])


def glossy():
    rough = ['"conductor" "float roughness" .3', '"coateddiffuse" "rgb reflectance" [ .6 .2 .1 ] "float roughness" .2', '"conductor" "float roughness" .08',
             '"dielectric" "float roughness" .1']
    return on_the_floor("", [ball("", material, (i - 1.5) * 1.5, .7, 0, .7) for i, material in enumerate(rough)])


def motion():
    paths = [f"ActiveTransform EndTime Translate {.6 + .2 * i} {.3 * (i % 2)} 0 ActiveTransform All" for i in range(4)]
    return on_the_floor("", [ball(path, f'"diffuse" "rgb reflectance" [ .7 .{3 + i} .2 ]', (i - 1.5) * 1.5, .6, i % 2, .5) for i, path in enumerate(paths)])


def lamps(count=64):
    """A hall with columns and small lamps, a quarter of which are bright."""
    rng = random.Random(count)
    text = f'LookAt 0 2.5 -19  0 1.5 0  0 1 0\nCamera "perspective" "float fov" 60\n{HEAD}WorldBegin\nMaterial "diffuse" "rgb reflectance" [ .6 .6 .6 ]\n'
    text += quad((-10, 0, -20), (10, 0, -20), (-10, 0, 20), (10, 0, 20)) + quad((-10, 0, -20), (-10, 6, -20), (-10, 0, 20), (-10, 6, 20))
    for z in range(-16, 20, 4):
        for x in (-5, 5):
            text += ball("", '"diffuse"', x, 3, z, .4)
    for _ in range(count):
        x, y, z = rng.uniform(-9, 9), rng.uniform(1, 5.8), rng.uniform(-18, 19)
        light = f'AreaLightSource "diffuse" "rgb L" [ 1 1 .8 ] "float power" {rng.choice((1, 1, 1, 20))}'
        text += ball(light, '"diffuse"', f"{x:.3f}", f"{y:.3f}", f"{z:.3f}", .1)
    return text


OWN = {"lens": lens, "glossy": glossy, "motion": motion, "lamps": lamps}


def smooth(camera, depth, world):
    return f'{camera} Camera "perspective" "float fov" 20\nFilm "rgb" "integer xresolution" 8 "integer yresolution" 8\nPixelFilter "box"\n' \
           f'Integrator "path" "integer maxdepth" {depth} "float rrthreshold" 0\nWorldBegin\n{world}'


def smooth_lamp():
    """A wall that faces a square lamp, which is sampled by its area: the pixel's and the light's numbers."""
    lamp = 'AttributeBegin AreaLightSource "diffuse" "rgb L" [ 4 4 4 ] Translate .3 .2 5 ' + quad((-2, -2, 0), (-2, 2, 0), (2, -2, 0), (2, 2, 0)) + "AttributeEnd\n"
    wall = 'Material "diffuse" ' + quad((-9, -9, 0), (9, -9, 0), (-9, 9, 0), (9, 9, 0))
    text = smooth("LookAt 0 0 4  0 0 0  0 1 0", 1, lamp + wall)
    return text.replace('Integrator "path"', 'Integrator "whitted"')


def smooth_bounces(bounces):
    """Inside of a ball with a point light: the pixel's numbers, and two for the direction of each bounce."""
    return smooth("LookAt 0 0 0  1 .3 .2  0 0 1", bounces + 1,
                  'LightSource "point" "point3 from" [ .2 -.3 .4 ]\nMaterial "diffuse" "rgb reflectance" [ .7 .7 .7 ]\nShape "sphere" "float radius" 2')


SMOOTH = {"lamp": smooth_lamp, "one bounce": lambda: smooth_bounces(1), "two bounces": lambda: smooth_bounces(2)}
