"""Textures and materials in pbrt's language, chosen at random (random_scene.py)."""
import pathlib
import random

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "assets"
METALS = ["Cu", "Au", "Ag", "Al", "CuZn", "MgO", "TiO2"]
GLASSES = ["BK7", "BAF10", "F11", "F5", "LASF9"]
SPACES = ["aces2065-1", "rec2020", "dci-p3"]


class RandomSurfaces:
    """Statements of a scene, and textures and materials among them."""

    def __init__(self, seed, without_coats=False):
        self.random = random.Random(seed)
        self.lines, self.tags = [], []
        self.names = self.depth = 0
        self.moves = self.disperses = False   # what is being made moves; the scene has glass that disperses
        self.without_coats = without_coats

    # ---- values: parameters as text

    def chance(self, p): return self.random.random() < p
    def pick(self, *choices): return self.tagged(self.random.choice(choices))
    def uniform(self, low, high): return self.random.uniform(low, high)
    def numbers(self, count, low, high): return "[ " + " ".join(f"{self.uniform(low, high):.5g}" for _ in range(count)) + " ]"
    def points(self, points): return "[ " + "  ".join(" ".join(f"{c:.4g}" for c in p) for p in points) + " ]"
    def number(self, name, low, high): return f' "float {name}" {self.uniform(low, high):.5g}'
    def rgb(self, name, low, high): return f' "rgb {name}" {self.numbers(3, low, high)}'
    def maybe(self, p, make): return make() if self.chance(p) else ""

    def tagged(self, word):
        self.tags.append(word)
        return word

    def name(self):
        self.names += 1
        return f"n{self.names}"

    def spectrum(self, name, low=.05, high=.85, textures=True):
        if textures and self.chance(.35): return f' "texture {name}" "{self.texture(False, low, high)}"'
        if self.chance(.7): return self.rgb(name, low, high)
        wavelengths = sorted(self.random.sample(range(380, 720, 10), 5))
        return f' "spectrum {name}" [ ' + " ".join(f"{w} {self.uniform(low, high):.4g}" for w in wavelengths) + " ]"

    def float(self, name, low, high):
        return f' "texture {name}" "{self.texture(True, low, high)}"' if self.chance(.25) else self.number(name, low, high)

    # ---- textures, of values in [low, high]

    def mapping(self):
        if self.chance(.6):
            return self.number("uscale", 1, 9) + self.number("vscale", 1, 9) + self.maybe(.4, lambda: self.number("udelta", -1, 1))
        kind = self.random.choice(["spherical", "cylindrical", "planar"])
        sides = f' "vector3 v1" {self.numbers(3, -2, 2)} "vector3 v2" {self.numbers(3, -2, 2)}'
        return f' "string mapping" "{kind}"' + (sides if kind == "planar" else "")

    def texture(self, is_float, low, high):
        plain = lambda name: self.number(name, low, high) if is_float else self.rgb(name, low, high)

        def value(name):
            if self.depth < 2 and self.chance(.3): return f' "texture {name}" "{self.texture(is_float, low, high)}"'
            return plain(name)

        def amount(name):
            return f' "texture {name}" "{self.texture(True, 0, 1)}"' if self.depth < 2 and self.chance(.5) else self.number(name, 0, 1)

        self.depth += 1
        kind = self.pick("constant", "scale", "mix", "directionmix", "bilerp", "imagemap", "checkerboard", "solid checkerboard", "dots",
                         "fbm", "wrinkled", "windy", *([] if is_float else ["marble"]))
        begun = self.chance(.4)
        mine = self.name()
        if kind in ("fbm", "wrinkled", "windy"):   # of unknown range: they mix two values
            noise = self.name()
            more = "" if kind == "windy" else f' "integer octaves" {self.random.randint(1, 8)}' + self.number("roughness", .2, .8)
            self.lines.append(f'Texture "{noise}" "float" "{kind}"{more}')
            kind, parameters = "mix", plain("tex1") + plain("tex2") + f' "texture amount" "{noise}"'
        else:
            parameters = {
                "constant": lambda: plain("value"),
                "scale": lambda: value("tex") + self.number("scale", .6, 1),
                "mix": lambda: value("tex1") + value("tex2") + amount("amount"),
                "directionmix": lambda: value("tex1") + value("tex2") + f' "vector3 dir" {self.numbers(3, -1, 1)}',
                "bilerp": lambda: "".join(plain(corner) for corner in ("v00", "v01", "v10", "v11")) + self.mapping(),
                "imagemap": lambda: f' "string filename" "{ASSETS}/tiles{"-height" if is_float else ""}.png"' +
                                    ' "string filter" "ewa" "float maxanisotropy" 1e4' + self.mapping() +
                                    f' "string wrap" "{self.random.choice(["repeat", "black"])}"' + self.number("scale", .4, .9) +
                                    self.maybe(.2, lambda: ' "string encoding" "linear"') + self.maybe(.3, lambda: ' "bool invert" true'),
                "checkerboard": lambda: value("tex1") + value("tex2") + self.mapping(),
                "solid checkerboard": lambda: value("tex1") + value("tex2") + ' "integer dimension" 3',
                "dots": lambda: value("inside") + value("outside") + self.mapping(),
                "marble": lambda: self.number("scale", .5, 4) + self.number("variation", .05, .6),
            }[kind]()
        if begun:
            self.lines.append("AttributeBegin")
            self.transform(.3, 2)
        self.lines.append(f'Texture "{mine}" "{"float" if is_float else "spectrum"}" "{kind.split()[-1]}"{parameters}')
        if begun: self.lines.append("AttributeEnd")
        self.depth -= 1
        return mine

    def transform(self, low=.6, high=1.3):
        for _ in range(self.random.randint(0, 2)):
            kind = self.random.random()
            if kind < .5: self.lines.append(f"Rotate {self.uniform(-180, 180):.4g} " + self.numbers(3, -1, 1)[2:-2])
            elif kind < .8:
                sign = lambda: -1 if not self.moves and self.chance(.2) else 1
                self.lines.append("Scale " + " ".join(f"{sign() * self.uniform(low, high):.4g}" for _ in range(3)))
            else:
                off = lambda: f"{self.uniform(-.3, .3):.4g}"
                rows = [f"1 {off()} {off()} 0", f"{off()} 1 {off()} 0", f"{off()} {off()} 1 0", "0 0 0 1"]
                self.lines.append(f"ConcatTransform [ {' '.join(rows)} ]")

    # ---- materials

    def roughness(self, low, high, prefix=""):
        one = lambda: self.float(prefix + "roughness", low, high)
        two = lambda: self.float(prefix + "uroughness", low, high) + self.float(prefix + "vroughness", low, high)
        return (one() if self.chance(.5) else two()) + self.maybe(.3, lambda: ' "bool remaproughness" false')

    def bumps(self):
        if self.chance(.07): return f' "string normalmap" "{ASSETS}/{self.tagged("tiles-normal")}.png"'
        if not self.chance(.15): return ""
        noise, height = self.name(), self.name()
        self.lines.append(f'Texture "{noise}" "float" "{self.pick("fbm", "wrinkled", "windy")}"')
        self.lines.append(f'Texture "{height}" "float" "scale" "texture tex" "{noise}"' + self.number("scale", .01, .06))
        return f' "texture displacement" "{height}"'

    def coat(self):
        return (self.maybe(.5, lambda: self.float("thickness", .001, .3)) +
                self.maybe(.3, lambda: f' "integer maxdepth" {self.random.randint(5, 40)}') +
                self.maybe(.4, lambda: self.spectrum("albedo", .1, .95) + self.number("g", -.8, .8)))

    def metal(self, prefix=""):
        if self.chance(.4): return self.spectrum("reflectance", .2, .95)
        metal = self.random.choice(METALS)
        return f' "spectrum {prefix}eta" "metal-{metal}-eta" "spectrum {prefix}k" "metal-{metal}-k"'

    def index(self):
        if self.disperses and self.chance(.6): return f' "spectrum eta" "glass-{self.tagged(self.random.choice(GLASSES))}"'
        return self.maybe(.6, lambda: self.number("eta", 1.05, 2.3))

    def hair(self):
        colour = self.pick("sigma_a", "reflectance", "eumelanin", "pheomelanin")
        colour = self.spectrum(colour, .1, .9) if colour in ("sigma_a", "reflectance") else self.float(colour, .1, 3)
        return (colour + self.float("beta_m", .15, .8) + self.float("beta_n", .15, .8) +
                self.maybe(.5, lambda: self.number("eta", 1.2, 1.8)) + self.maybe(.5, lambda: self.float("alpha", 0, 6)))

    def material_words(self, is_part=False):
        """The kind of a material and its parameters."""
        coats = [] if self.without_coats else ["coateddiffuse", "coatedconductor"]
        kind = self.pick("diffuse", "diffuse", "diffusetransmission", "dielectric", "thindielectric", "conductor", "conductor", *coats,
                         *([] if is_part else ["mix"]))
        if kind == "mix":
            return kind, f' "string materials" [ "{self.named_material(True)}" "{self.named_material(True)}" ]' + self.float("amount", 0, 1)
        parameters = {
            "diffuse": lambda: self.spectrum("reflectance"),
            "diffusetransmission": lambda: self.spectrum("reflectance", .05, .45) + self.spectrum("transmittance", .05, .45),
            "dielectric": lambda: self.index() + self.maybe(.6, lambda: self.roughness(.1, .6)),
            "thindielectric": lambda: self.number("eta", 1.1, 2.2),
            "conductor": lambda: self.metal() + self.maybe(.8, lambda: self.roughness(.05, .7)),
            "coateddiffuse": lambda: self.spectrum("reflectance") + self.roughness(.02, .5) + self.number("eta", 1.1, 2.2) + self.coat(),
            "coatedconductor": lambda: self.metal("conductor.") + self.float("interface.roughness", .01, .4) +
                                       self.float("conductor.roughness", .05, .5) + self.coat(),
        }[kind]()
        return kind, parameters + self.bumps()

    def named_material(self, is_part=False):
        kind, parameters = self.material_words(is_part)
        name = self.name()
        self.lines.append(f'MakeNamedMaterial "{name}" "string type" "{kind}"{parameters}')
        return name

    def material(self):
        space = self.chance(.1)
        if space: self.lines.append(f'ColorSpace "{self.tagged(self.random.choice(SPACES))}"')
        self.material_of_space()
        if space: self.lines.append('ColorSpace "srgb"')

    def material_of_space(self):
        if self.chance(.3): return self.lines.append(f'NamedMaterial "{self.named_material()}"')
        kind, parameters = self.material_words()
        self.lines.append(f'Material "{kind}"{parameters}')
