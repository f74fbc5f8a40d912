"""Media and lights in pbrt's language, chosen at random (random_scene.py)."""
from random_shapes import RandomShapes
from random_surfaces import ASSETS


class RandomLights(RandomShapes):
    """Media, and lights above the scene or all around it."""

    # ---- media

    def medium(self, kind=None, densest=2.5):
        kind = kind or self.pick("homogeneous", "homogeneous", "uniformgrid", "rgbgrid", "cloud")
        x, y, z = (self.random.randint(1, 4) for _ in range(3))
        cells = x * y * z
        grid = f' "integer nx" {x} "integer ny" {y} "integer nz" {z}'
        place = ' "point3 p0" [ -1 -1 -1 ] "point3 p1" [ 1 1 1 ]'
        sigma = lambda: self.spectrum("sigma_a", 0, densest, False) + self.spectrum("sigma_s", 0, densest, False)
        preset = lambda: f' "string preset" "{self.tagged("Skin1")}"' + self.number("scale", .2 * densest, .8 * densest)
        parameters = {
            "homogeneous": lambda: (sigma() if self.chance(.8) else preset()) + self.maybe(.25, lambda: self.rgb("Le", 0, .15 * densest)),
            "uniformgrid": lambda: grid + f' "float density" {self.numbers(cells, 0, 2)}' + sigma() + place +
                                   self.maybe(.3, lambda: self.rgb("Le", 0, .4)),
            "rgbgrid": lambda: grid + f' "rgb sigma_a" {self.numbers(3 * cells, 0, 1.5)}' +
                               f' "rgb sigma_s" {self.numbers(3 * cells, 0, 2)}' + place,
            "cloud": lambda: self.number("density", .5, 2) + self.number("wispiness", 0, 2) + self.number("frequency", 1, 6) + sigma() +
                             place,
        }[kind]()
        name = self.name()
        g = self.maybe(.6, lambda: self.number("g", -.8, .8))
        self.lines.append(f'MakeNamedMedium "{name}" "string type" "{kind}"{parameters}{g}')
        return name

    # ---- lights

    def emission(self, name, brightest):
        if self.chance(.6): return self.rgb(name, brightest / 4, brightest)
        scale = self.number("scale", .3 * brightest, .8 * brightest)
        if self.chance(.5): return f' "blackbody {name}" {self.uniform(2000, 9000):.4g}{scale}'
        return f' "spectrum {name}" "{self.random.choice(["stdillum-D65", "stdillum-A", "stdillum-F11"])}"{scale}'

    def area_light(self):
        self.tagged("area light")
        self.lines += ["AttributeBegin", f"Translate {self.uniform(-3, 3):.4g} {self.uniform(3, 4.5):.4g} {self.uniform(-3, 3):.4g}",
                       f"Rotate {self.uniform(-180, 180):.4g} " + self.numbers(3, -1, 1)[2:-2]]
        power, sides = self.maybe(.15, lambda: self.number("power", 50, 200)), self.maybe(.5, lambda: ' "bool twosided" true')
        if self.chance(.15): colour = f' "string filename" "{ASSETS}/{self.tagged("tiles")}.png"' + self.number("scale", 5, 20)
        else: colour = self.emission("L", 14)
        self.lines += [f'AreaLightSource "diffuse"{power}{colour}{sides}',
                       'Material "diffuse" "rgb reflectance" [ .1 .1 .1 ]', self.shape(emits=True), "AttributeEnd"]

    def small_light(self):
        kind = self.pick("point", "spot", "distant", "goniometric", "projection")
        self.lines.append("AttributeBegin")
        power = self.maybe(.2, lambda: self.number(self.tagged("power"), 300, 1500))
        above = f"[ {self.uniform(-3, 3):.3g} 4 {self.uniform(-4, 0):.3g} ]"
        if kind == "distant": self.lines.append(f'LightSource "distant"{self.emission("L", 3)} "point3 from" {above}' +
                                                  self.maybe(.2, lambda: self.number(self.tagged("illuminance"), 2, 10)))
        elif kind == "point": self.lines.append(f'LightSource "point"{self.emission("I", 30)}{power} "point3 from" {above}')
        elif kind == "spot":
            cones = self.number("coneangle", 15, 50) + self.number("conedeltaangle", 1, 14)
            self.lines.append(f'LightSource "spot"{self.emission("I", 30)}{power} "point3 from" {above} "point3 to" [ 0 .5 0 ]{cones}')
        else:
            file, more = ("sky.exr", "") if kind == "goniometric" else ("tiles.png", self.number("fov", 30, 80))
            self.lines += [f"Translate {self.uniform(-2, 2):.3g} 3.5 -3", f"Rotate {self.uniform(30, 60):.3g} 1 0 0",
                           f'LightSource "{kind}" "string filename" "{ASSETS}/{file}"' + self.number("scale", 10, 40) + more + power]
        self.lines.append("AttributeEnd")

    def sky(self):
        image = f' "string filename" "{ASSETS}/sky.exr"' + self.number("scale", .2, .8)
        self.lines += ["AttributeBegin", f"Rotate {self.uniform(-180, 180):.4g} 1 .3 .2",
                       f'LightSource "infinite"{image if self.chance(.3) else self.emission("L", .6)}{self.illumination()}', "AttributeEnd"]
        self.tagged("sky")

    def portal(self):
        """An environment that shines through a rectangle above the scene."""
        x, y, z = self.uniform(1, 5), self.uniform(4.6, 6), self.uniform(1, 5)
        corners = [(-x, y, -z), (-x, y, z), (x, y, z), (x, y, -z)]
        self.lines.append(f'LightSource "infinite" "string filename" "{ASSETS}/sky.exr" "point3 portal" {self.points(corners)}' +
                          self.number("scale", 1, 4))
        self.tagged("portal")

    def illumination(self):
        return self.maybe(.15, lambda: self.number(self.tagged("illuminance"), .5, 3))
