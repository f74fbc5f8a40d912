"""Shapes in pbrt's language, chosen at random (random_scene.py)."""
from random_surfaces import RandomSurfaces

BOX = "0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3"
OCTAHEDRON = "0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5"


class RandomShapes(RandomSurfaces):
    """Shapes, about as large as the unit ball."""

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
        u, v = (sorted(self.uniform(-.5, 2) for _ in range(2)) for _ in range(2))
        uvs = [(i, j) for j in v for i in u]
        return (text + self.maybe(.4, lambda: f' "point2 uv" {self.points(uvs)}') +
                self.maybe(.4, lambda: f' "normal N" {self.points(normals)}') + self.alpha())

    def alpha(self):
        return self.maybe(.3, lambda: self.float(self.tagged("alpha"), .2, 1))

    def curve(self):
        kind = self.random.choice(["flat", "cylinder", "ribbon"])
        if self.chance(.3):
            degree, count = self.random.choice([(2, 6), (3, 6)])
            return (f'Shape "curve" "string type" "{kind}" "string basis" "bspline" "integer degree" {degree}' +
                    f' "point3 P" {self.numbers(3 * count, -1.2, 1.2)}' + self.number("width", .02, .06) +
                    (f' "normal N" {self.numbers(3 * (count - degree + 1), -1, 1)}' if kind == "ribbon" else ""))
        return (f'Shape "curve" "string type" "{kind}" "point3 P" {self.numbers(12, -1, 1)}' + self.number("width0", .02, .06) +
                self.number("width1", .02, .06) + (f' "normal N" {self.numbers(6, -1, 1)}' if kind == "ribbon" else ""))

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
