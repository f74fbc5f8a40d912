"""A scene in pbrt's language, made of statements chosen at random: combinations that no author chose.

Scene(seed, without_coats).text(samples) is the whole file; `tags` says what is in it. Its images are those of scenes/assets. What
pbrt-v4 is known to render otherwise is left out (docs/accuracy.md, "Random scenes"), as are environments behind a medium without an end.
"""
from random_lights import RandomLights


class Scene(RandomLights):
    def motion(self, offset, turn, axis):
        """Moves what follows, from where it is."""
        return ["ActiveTransform EndTime", f"Translate {self.numbers(3, -offset, offset)[2:-2]}",
                f"Rotate {self.uniform(-turn, turn):.3g} {axis}", "ActiveTransform All"]

    def boundary(self, chance_of_glass):
        return 'Material "dielectric"' + self.number("eta", 1.05, 1.6) if self.chance(chance_of_glass) else 'Material "interface"'

    def object_at(self, x, z, outside):
        self.lines += ["AttributeBegin", f"Translate {x:.3g} {self.uniform(.7, 1.3):.3g} {z:.3g}"]
        self.moves = self.chance(.12)
        self.transform()
        if self.moves:
            self.lines += self.motion(.4, 40, "0 1 0")
            self.tagged("motion")
        if self.chance(.25) and not self.moves and not self.disperses:
            inside = self.medium()
            self.lines += [f'MediumInterface "{inside}" "{outside}"', self.boundary(.4)]
            self.lines.append(self.box() if self.chance(.3) else 'Shape "sphere"' + self.number("radius", .7, 1))
            if self.chance(.3):
                self.tagged("nested")
                innermost = self.medium("homogeneous") if self.chance(.5) else ""
                self.lines += [f'MediumInterface "{innermost}" "{inside}"', self.boundary(.6), "Scale .4 .35 .4", 'Shape "sphere"']
        elif self.chance(.15):
            name = self.name()
            self.lines.append(f'ObjectBegin "{name}"')
            self.material()
            self.lines += [self.shape(), "ObjectEnd", f'ObjectInstance "{name}"', "Translate .3 .6 .5", "Scale .5 .6 .6",
                           f'ObjectInstance "{name}"']
            self.tagged("instance")
        elif self.chance(.1):
            self.lines += [f'Material "{self.tagged("hair")}"{self.hair()}', *(self.curve() for _ in range(6))]
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
        if kind == "perspective": more += self.maybe(.1, lambda: self.number("frameaspectratio", .8, 2))
        moves = self.motion(.2, 5, ".2 1 .1") if self.chance(.1) else []
        if moves: self.tagged("moving camera")
        mirror = ["Scale -1 1 1"] if self.chance(.2) and not moves else []
        if mirror: self.tagged("mirrored camera")
        return [*mirror, *moves, f"LookAt {eye}  0 .95 0  {self.uniform(-.2, .2):.2g} 1 0", f'Camera "{kind}"{more}{shutter}']

    def room(self):
        """Walls around the scene, of one material."""
        self.tagged("room")
        self.lines.append("AttributeBegin")
        self.material()
        x, y, z = self.uniform(4, 6), self.uniform(5, 7), self.uniform(8, 10)
        walls = [[(s * x, 0, -z), (s * x, 0, z), (s * x, y, -z), (s * x, y, z)] for s in (-1, 1)]
        walls += [[(-x, 0, s * z), (x, 0, s * z), (-x, y, s * z), (x, y, s * z)] for s in (-1, 1)]
        if self.chance(.5): walls.append([(-x, y, -z), (x, y, -z), (-x, y, z), (x, y, z)])
        self.lines += [*(f'Shape "bilinearmesh" "point3 P" {self.points(wall)}' for wall in walls), "AttributeEnd"]

    def text(self, samples):
        self.disperses = self.chance(.3)
        fog = self.medium(self.tagged("homogeneous"), .06) if not self.disperses and self.chance(.15) else ""
        around = [*self.lines, f'MediumInterface "" "{fog}"'] if fog else []
        self.lines = []
        head = ['Option "rendercoordsys" "world"', *around, *self.camera()]
        filter_ = self.pick("box", "gaussian", "mitchell", "triangle", "sinc")
        head += [f'PixelFilter "{filter_}"', f'Sampler "independent" "integer pixelsamples" {samples}',
                 f'Integrator "volpath" "integer maxdepth" {self.random.choice([3, 5, 8, 12])}',
                 'Film "rgb" "integer xresolution" 64 "integer yresolution" 48' +
                 self.maybe(.1, lambda: ' "string sensor" "canon_eos_100d"'), "WorldBegin"]
        if fog: self.lines.append(f'MediumInterface "" "{fog}"')
        if self.chance(.85): self.area_light()
        if self.chance(.6) or (fog and not self.tags.count("area light")): self.small_light()
        if not fog and (self.chance(.75) or not self.lines): self.portal() if self.chance(.12) else self.sky()
        if self.chance(.2): self.room()
        self.lines.append("AttributeBegin")
        self.material()
        self.lines += ['Shape "bilinearmesh" "point3 P" [ -6 0 -6  6 0 -6  -6 0 6  6 0 6 ]', "AttributeEnd"]
        for x, z in [(-1, 0), (1, .3), (0, 2.3)]:
            if x or self.chance(.3): self.object_at(x + self.uniform(-.3, .3), z + self.uniform(-.5, .5), fog)
        return "\n".join([*head, *self.lines]) + "\n"
