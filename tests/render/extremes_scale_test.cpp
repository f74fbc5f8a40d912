// A scene and a copy of it that is 2^k times as large have the same bits, by a transform and with all of its lengths written out.

#include "rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include <unistd.h>

namespace eikonal {
namespace {

/// Lengths of a scene in a unit of 2^k.
struct Lengths {
    int k = 0;
    /// Numbers of the scene, in scene units, times the unit to the power `dimension`.
    template <class... N> std::string operator()(N... numbers) const { return power(1, numbers...); }
    template <class... N> std::string power(int dimension, N... numbers) const {
        std::string text;
        for (const double x : {static_cast<double>(numbers)...}) text += fmt::format("{:.17g} ", std::ldexp(x, k * dimension));
        return text;
    }
};

constexpr int scales[] = {-100, -70, -30, 30, 70, 100};

std::string image(const std::string& camera) {
    return "Camera " + camera +
           "\nFilm \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16 Sampler \"zsobol\" \"integer pixelsamples\" 4\n";
}
const std::string pinhole = "\"perspective\" \"float fov\" 50";

/// The contents of a scene with lengths written out.
using Contents = std::string (*)(const Lengths&);

void expectSameBitsWrittenOut(const std::string& what, Contents contents, const std::function<std::string(const Lengths&)>& camera) {
    const auto at = [&](int k) {
        const Lengths l{k};
        return render("LookAt " + l(0, 1, -4) + l(0, 0, 0) + "0 1 0\n" + image(camera(l)) +
                      "WorldBegin LightSource \"infinite\" \"rgb L\" [.5 .5 .5]\n" + contents(l))
            .image;
    };
    const FilmImage one = at(0);
    for (const int k : scales) expectSameBits(one, at(k), fmt::format("{} times 2^{}", what, k));
}

void expectSameBitsTransformed(const std::string& what, const std::string& contents, const std::string& camera) {
    const auto at = [&](int k) {
        const std::string grow = fmt::format("Scale {0:.17g} {0:.17g} {0:.17g}\n", std::ldexp(1.0, k)),
                          shrink = fmt::format("Scale {0:.17g} {0:.17g} {0:.17g}\n", std::ldexp(1.0, -k));
        return render("LookAt 0 1 -4 0 0 0 0 1 0\n" + shrink + image(camera) + "WorldBegin\n" + grow +
                      "LightSource \"infinite\" \"rgb L\" [.5 .5 .5]\n" + contents)
            .image;
    };
    const FilmImage one = at(0);
    for (const int k : scales) expectSameBits(one, at(k), fmt::format("{} transformed by 2^{}", what, k));
}

struct Named { const char* name; Contents contents; };
const std::string ball = "Shape \"sphere\" \"float radius\" ";
const Named contents[] = {
    {"sphere", [](const Lengths& l) { return ball + l(1); }},
    {"part of a sphere", [](const Lengths& l) { return ball + l(1) + "\"float zmin\" " + l(-.5) + "\"float phimax\" 200"; }},
    {"disk", [](const Lengths& l) {
         return "Shape \"disk\" \"float radius\" " + l(1) + "\"float innerradius\" " + l(.2) + "\"float height\" " + l(.5);
     }},
    {"cylinder", [](const Lengths& l) {
         return "Shape \"cylinder\" \"float radius\" " + l(1) + "\"float zmin\" " + l(-.5) + "\"float zmax\" " + l(.5);
     }},
    {"triangles", [](const Lengths& l) { return "Shape \"trianglemesh\" \"point3 P\" [" + l(-3, -1, -3, 3, -1, -3, 0, -1, 3) + "]"; }},
    {"patch", [](const Lengths& l) { return "Shape \"bilinearmesh\" \"point3 P\" [" + l(-1, -1, 0, 1, -1, 0, -1, 1, .5, 1, 1, 0) + "]"; }},
    {"curve", [](const Lengths& l) {
         return "Shape \"curve\" \"point3 P\" [" + l(-1, -1, 0, -.5, 0, 0, .5, 0, 0, 1, 1, 0) + "] \"float width\" " + l(.2);
     }},
    {"subdivision", [](const Lengths& l) {
         return "Shape \"loopsubdiv\" \"integer levels\" 2 \"integer indices\" [0 1 2 0 2 3 0 3 1 1 3 2] \"point3 P\" [" +
                l(-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1) + "]";
     }},
    {"point light", [](const Lengths& l) {
         return "LightSource \"spot\" \"rgb I\" [1 1 1] \"float power\" " + l.power(2, 40) + "\"point3 from\" [" + l(0, 3, -3) +
                "] \"point3 to\" [" + l(0, 0, 0) + "] " + ball + l(1);
     }},
    {"lamps", [](const Lengths& l) {
         return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [3 3 3] Translate " + l(0, 2, 0) + ball + l(.4) + " AttributeEnd " +
                "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [3 3 3] Translate " + l(2, 2, 0) + " Rotate 90 1 0 0 " +
                "Shape \"disk\" \"float radius\" " + l(.4) + " AttributeEnd " + ball + l(1);
     }},
    {"fog", [](const Lengths& l) {
         const std::string sigma = "[" + l.power(-1, 1, 1, 1) + "]";
         return "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" " + sigma + " \"rgb sigma_s\" " + sigma +
                "MediumInterface \"fog\" \"\" Material \"interface\" " + ball + l(1);
     }},
};

TEST(Scale, LengthsWrittenOut) {
    for (const Named& c : contents) expectSameBitsWrittenOut(c.name, c.contents, [](const Lengths&) { return pinhole; });
}
// Except for what is per unit of the world, whatever the transform: coefficients of fog, and the power of a point light.
TEST(Scale, Transformed) {
    for (const Named& c : contents)
        if (c.name != std::string("fog") && c.name != std::string("point light"))
            expectSameBitsTransformed(c.name, c.contents(Lengths{}), pinhole);
}

TEST(Scale, Cameras) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / fmt::format("eikonal-scale-{}.dat", getpid());
    std::ofstream(file) << "50 .02 1.5 20\n-50 .02 1 20\n0 50 0 20\n";
    const std::string lens =
        fmt::format("\"realistic\" \"string lensfile\" \"{}\" \"float aperturediameter\" 1.6 \"float focusdistance\" 2", file.string());
    const Contents sphere = contents[0].contents;
    const auto thin = [](const Lengths& l) { return pinhole + " \"float lensradius\" " + l(.1) + "\"float focaldistance\" " + l(4); };
    const auto parallel = [](const Lengths& l) { return "\"orthographic\" \"float screenwindow\" [" + l(-2, 2, -2, 2) + "]"; };
    const auto around = [](const Lengths&) { return std::string("\"spherical\""); };
    expectSameBitsWrittenOut("thin lens", sphere, thin);
    expectSameBitsWrittenOut("orthographic camera", sphere, parallel);
    expectSameBitsWrittenOut("spherical camera", sphere, around);
    expectSameBitsTransformed("thin lens", sphere({}), thin({}));
    expectSameBitsTransformed("orthographic camera", sphere({}), parallel({}));
    expectSameBitsTransformed("realistic camera", sphere({}), lens);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace eikonal
