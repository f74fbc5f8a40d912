"""A scene in pbrt's language, made of statements chosen at random: combinations that no author chose.

Scene(seed, without_coats).text(samples) is the whole file; `tags` says what is in it. Its images are those of scenes/assets. Left out
is what pbrt-v4 is known to render otherwise (docs/accuracy.md): parts of spheres and disks as lights, alpha on closed shapes, motion of
mirrored objects, an environment behind a medium without an end, filters other than EWA; and coats, where it says so.
"""
from random_surfaces import ASSETS, RandomSurfaces

BOX = "0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3"
OCTAHEDRON = "0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5"


class Scene(RandomSurfaces):
    # ---- shapes, about as large as the unit ball

    def box(self):
        x, y, z = (self.uniform(.4, .8) for _ in range(3))
        corners = [(i * x, j * y, k * z) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
        return f'Shape "trianglemesh" "integer indices" [ {BOX} ] "point3 P" {self.points(corners)}'

    def octahedron(self, kind, is_plain):
        corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
        corners = [tuple(c * self.uniform(.7, 1.1) + self.uniform(-.1, .1) for c in p) for p in corners]
        text = f'Shape "{kind}" "integer indices" [ {OCTAHEDRON} ] "point3 P" {self.points(corners)}'
        if kind == "loopsubdiv": return text + f' "integer levels" {self.random.randint(0, 4)}'
        if is_plain: return text
        return (text + self.maybe(.5, lambda: f' "normal N" {self.points(corners)}') +
                self.maybe(.4, lambda: f' "point2 uv" {self.numbers(12, -.2, 2)}'))

    def patch(self, is_plain):
        corners = [(x * self.uniform(.6, 1), y * self.uniform(.6, 1), self.uniform(-.4, .4)) for y in (-1, 1) for x in (-1, 1)]
        normals = [(self.uniform(-.4, .4), self.uniform(-.4, .4), 1) for _ in corners]
        text = f'Shape "bilinearmesh" "point3 P" {self.points(corners)}'
        if is_plain: return text
        return (text + self.maybe(.4, lambda: f' "point2 uv" {self.numbers(8, -.2, 2)}') +
                self.maybe(.4, lambda: f' "normal N" {self.points(normals)}') + self.alpha())

    def alpha(self):
        return self.maybe(.3, lambda: self.float(self.tagged("alpha"), .2, 1))

    def curve(self):
        kind = self.random.choice(["flat", "cylinder", "ribbon"])
        return (f'Shape "curve" "string type" "{kind}" "point3 P" {self.numbers(12, -1, 1)}' + self.number("width0", .05, .3) +
                self.number("width1", .05, .3) + (f' "normal N" {self.numbers(6, -1, 1)}' if kind == "ribbon" else ""))

    def shape(self, emits=False):
        turn = lambda: "" if emits else self.maybe(.4, lambda: self.number("phimax", 90, 340))
        kind = self.pick("sphere", "disk", "cylinder", "trianglemesh", "bilinearmesh", "box", *([] if emits else ["loopsubdiv", "curves"]))
        return {
            "sphere": lambda: 'Shape "sphere"' + self.number("radius", .6, 1.1) + turn() +
                              ("" if emits else self.maybe(.4, lambda: self.number("zmin", -1, -.2) + self.number("zmax", .1, .9))),
            "disk": lambda: 'Shape "disk"' + self.number("radius", .6, 1.1) + turn() +
                            ("" if emits else self.maybe(.4, lambda: self.number("innerradius", .1, .5)) + self.alpha()),
            "cylinder": lambda: 'Shape "cylinder"' + self.number("radius", .4, .9) + self.number("zmin", -1, -.2) +
                                self.number("zmax", .2, 1) + turn(),
            "trianglemesh": lambda: self.octahedron("trianglemesh", emits),
            "loopsubdiv": lambda: self.octahedron("loopsubdiv", emits),
            "bilinearmesh": lambda: self.patch(emits),
            "box": self.box,
            "curves": lambda: "\n".join(self.curve() for _ in range(self.random.randint(3, 8))),
        }[kind]()

    # ---- media

    def medium(self, kind=None, densest=2.5):
        kind = kind or self.pick("homogeneous", "homogeneous", "uniformgrid", "rgbgrid", "cloud")
        x, y, z = (self.random.randint(1, 4) for _ in range(3))
        cells = x * y * z
        grid = f' "integer nx" {x} "integer ny" {y} "integer nz" {z}'
        place = ' "point3 p0" [ -1 -1 -1 ] "point3 p1" [ 1 1 1 ]'
        sigma = lambda: self.spectrum("sigma_a", 0, densest, False) + self.spectrum("sigma_s", 0, densest, False)
        parameters = {
            "homogeneous": lambda: sigma() + self.maybe(.25, lambda: self.rgb("Le", 0, .15 * densest)),
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
        self.lines += [f'AreaLightSource "diffuse"{power}{self.emission("L", 14)}{sides}',
                       'Material "diffuse" "rgb reflectance" [ .1 .1 .1 ]', self.shape(emits=True), "AttributeEnd"]

    def small_light(self):
        kind = self.pick("point", "spot", "distant", "goniometric", "projection")
        self.lines.append("AttributeBegin")
        above = f"[ {self.uniform(-3, 3):.3g} 4 {self.uniform(-4, 0):.3g} ]"
        if kind == "distant": self.lines.append(f'LightSource "distant"{self.emission("L", 3)} "point3 from" {above}')
        elif kind == "point": self.lines.append(f'LightSource "point"{self.emission("I", 30)} "point3 from" {above}')
        elif kind == "spot":
            cones = self.number("coneangle", 15, 50) + self.number("conedeltaangle", 1, 14)
            self.lines.append(f'LightSource "spot"{self.emission("I", 30)} "point3 from" {above} "point3 to" [ 0 .5 0 ]{cones}')
        else:
            file, more = ("sky.exr", "") if kind == "goniometric" else ("tiles.png", self.number("fov", 30, 80))
            self.lines += [f"Translate {self.uniform(-2, 2):.3g} 3.5 -3", f"Rotate {self.uniform(30, 60):.3g} 1 0 0",
                           f'LightSource "{kind}" "string filename" "{ASSETS}/{file}"' + self.number("scale", 10, 40) + more]
        self.lines.append("AttributeEnd")

    def sky(self):
        image = f' "string filename" "{ASSETS}/sky.exr"' + self.number("scale", .2, .8)
        self.lines += ["AttributeBegin", f"Rotate {self.uniform(-180, 180):.4g} 1 .3 .2",
                       f'LightSource "infinite"{image if self.chance(.3) else self.emission("L", .6)}', "AttributeEnd"]
        self.tagged("sky")

    # ---- the whole

    def object_at(self, x, z, outside):
        self.lines += ["AttributeBegin", f"Translate {x:.3g} {self.uniform(.7, 1.3):.3g} {z:.3g}"]
        self.moves = self.chance(.12)
        self.transform()
        if self.moves:
            self.lines += ["ActiveTransform EndTime", f"Translate {self.numbers(3, -.4, .4)[2:-2]}",
                           f"Rotate {self.uniform(-40, 40):.3g} 0 1 0", "ActiveTransform All"]
            self.tagged("motion")
        if self.chance(.25):
            self.lines.append(f'MediumInterface "{self.medium()}" "{outside}"')
            glass = self.chance(.4)
            self.lines.append('Material "dielectric"' + self.number("eta", 1.05, 1.6) if glass else 'Material "interface"')
            self.lines.append(self.box() if self.chance(.3) else 'Shape "sphere"' + self.number("radius", .7, 1))
        elif self.chance(.15):
            name = self.name()
            self.lines.append(f'ObjectBegin "{name}"')
            self.material()
            self.lines += [self.shape(), "ObjectEnd", f'ObjectInstance "{name}"', "Translate .3 .6 .5", "Scale .5 .6 .6",
                           f'ObjectInstance "{name}"']
            self.tagged("instance")
        else:
            self.material()
            if self.chance(.1): self.lines.append("ReverseOrientation")
            self.lines.append(self.shape())
        self.lines.append("AttributeEnd")
        self.moves = False

    def camera(self):
        kind = self.pick("perspective", "perspective", "perspective", "orthographic", "spherical")
        lens = lambda: self.number("lensradius", .02, .2) + self.number("focaldistance", 4, 8)
        more = {"perspective": lambda: self.number("fov", 28, 40) + self.maybe(.3, lens),
                "orthographic": lambda: ' "float screenwindow" [ -2 2.2 -1.6 1.9 ]',
                "spherical": lambda: f' "string mapping" "{self.random.choice(["equirectangular", "equalarea"])}"'}[kind]()
        eye = f"{self.uniform(-3, 3):.3g} {self.uniform(1.6, 3):.3g} {self.uniform(-7, -5.5):.3g}"
        if kind == "spherical": eye = "0.2 1.4 -3.2"
        shutter = self.maybe(.3, lambda: self.number("shutteropen", 0, .4) + self.number("shutterclose", .5, 1))
        return [f"LookAt {eye}  0 .95 0  {self.uniform(-.2, .2):.2g} 1 0", f'Camera "{kind}"{more}{shutter}']

    def text(self, samples):
        fog = self.medium(self.tagged("homogeneous"), .06) if self.chance(.12) else ""
        around = [*self.lines, f'MediumInterface "" "{fog}"'] if fog else []
        self.lines = []
        head = around + self.camera()
        filter_ = self.pick("box", "gaussian", "mitchell", "triangle", "sinc")
        head += [f'PixelFilter "{filter_}"', f'Sampler "independent" "integer pixelsamples" {samples}',
                 f'Integrator "volpath" "integer maxdepth" {self.random.choice([3, 5, 8, 12])}',
                 'Film "rgb" "integer xresolution" 64 "integer yresolution" 48' +
                 self.maybe(.1, lambda: ' "string sensor" "canon_eos_100d"'), "WorldBegin"]
        if fog: self.lines.append(f'MediumInterface "" "{fog}"')
        if self.chance(.85): self.area_light()
        if self.chance(.6) or (fog and not self.tags.count("area light")): self.small_light()
        if not fog and (self.chance(.75) or not self.lines): self.sky()
        self.lines.append("AttributeBegin")
        self.material()
        self.lines += ['Shape "bilinearmesh" "point3 P" [ -6 0 -6  6 0 -6  -6 0 6  6 0 6 ]', "AttributeEnd"]
        for x, z in [(-1, 0), (1, .3), (0, 2.3)]:
            if x or self.chance(.3): self.object_at(x + self.uniform(-.3, .3), z + self.uniform(-.5, .5), fog)
        return "\n".join([*head, *self.lines]) + "\n"
