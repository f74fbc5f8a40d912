// Where a scene stands, and what else stands far away, do not change its image.

#include "image/compare.h"
#include "rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

/// Points of a scene that has been moved by `offset`.
struct Place {
    glm::dvec3 offset{0};
    template <class... P> std::string operator()(P... points) const {
        std::string text;
        for (const glm::dvec3& p : {glm::dvec3(points)...})
            text += fmt::format("{:.17g} {:.17g} {:.17g} ", p.x + offset.x, p.y + offset.y, p.z + offset.z);
        return text;
    }
};
using P = glm::dvec3;

std::string block(const Place& at, double x, double z, double width, double height) {
    const double y = 0.01;
    return "Shape \"trianglemesh\" \"integer indices\" [0 1 2 2 1 3 4 6 5 5 6 7 0 4 1 1 4 5 2 3 6 6 3 7 0 2 4 4 2 6 1 5 3 3 5 7] "
           "\"point3 P\" [" + at(P(x, y, z), P(x + width, y, z), P(x, height, z), P(x + width, height, z), P(x, y, z + width),
                                 P(x + width, y, z + width), P(x, height, z + width), P(x + width, height, z + width)) + "]\n";
}

/// Blocks and one shape of each other kind on a floor, under a lamp, a point light and a sky. Lengths are written out.
std::string contents(const Place& at) {
    std::string text =
        "LightSource \"infinite\" \"rgb L\" [.3 .35 .4]\n"
        "LightSource \"point\" \"rgb I\" [9 8 7] \"point3 from\" [" + at(P(2.3, 4.1, -3.7)) + "]\n"
        "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [5 5 5] Shape \"bilinearmesh\" \"point3 P\" [" +
        at(P(-1.1, 3.3, -1.1), P(1.3, 3.3, -1.1), P(-1.1, 3.3, 1.2), P(1.3, 3.3, 1.2)) + "] AttributeEnd\n"
        "Shape \"bilinearmesh\" \"point3 P\" [" + at(P(-5.1, 0, -5.3), P(5.4, 0, -5.3), P(-5.1, 0, 5.2), P(5.4, 0, 5.2)) + "]\n"
        "Shape \"curve\" \"point3 P\" [" + at(P(1.1, .1, -1.1), P(1.3, .9, -1.2), P(1.9, .8, -1.3), P(2.1, 1.6, -1)) +
        "] \"float width\" .15\n"
        "Shape \"loopsubdiv\" \"integer levels\" 2 \"integer indices\" [0 1 2 0 2 3 0 3 1 1 3 2] \"point3 P\" [" +
        at(P(-2.1, .1, -1.3), P(-1.1, .1, -1.2), P(-1.6, 1.1, -1.1), P(-1.7, .3, -.3)) + "]\n"
        "AttributeBegin Translate " + at(P(.3, .5, -1.7)) + "Material \"conductor\" Shape \"sphere\" \"float radius\" .5 AttributeEnd\n"
        "AttributeBegin Translate " + at(P(1.7, .5, .7)) + "Rotate 90 1 0 0 Shape \"cylinder\" \"float radius\" .4 \"float zmin\" -.4 "
        "\"float zmax\" .4 Shape \"disk\" \"float radius\" .4 \"float height\" -.4 AttributeEnd\n";
    for (int i = 0; i < 8; ++i)
        text += block(at, std::fmod(-2.3 + 1.31 * i, 4) - (i > 3), 0.5 + 0.37 * (i % 4), .2 + .03 * i, .4 + .17 * (i % 5));
    return text;
}

const std::string image = "Camera \"perspective\" \"float fov\" 40 Film \"rgb\" \"integer xresolution\" 32 \"integer yresolution\" 24\n"
                          "Sampler \"zsobol\" \"integer pixelsamples\" 4 Integrator \"volpath\" \"integer maxdepth\" 4\n";

FilmImage imageWrittenOut(const Place& at, const std::string& more = "") {
    return render("LookAt " + at(P(.3, 2.1, -6), P(0, .7, 0)) + "0 1 0\n" + image + "WorldBegin\n" + contents(at) + more).image;
}
FilmImage imageMoved(P by) {
    return render("LookAt .3 2.1 -6 0 .7 0 0 1 0 Translate " + Place{}(-by) + image + "WorldBegin Translate " + Place{}(by) + contents({}))
        .image;
}

struct Named { const char* name; std::string text; };
const Named outliers[] = {
    {"sphere", "Shape \"sphere\""},
    {"disk", "Shape \"disk\""},
    {"cylinder", "Shape \"cylinder\""},
    {"triangle", "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 1]"},
    {"patch", "Shape \"bilinearmesh\" \"point3 P\" [0 0 0 1 0 0 0 1 1 1 1 0]"},
    {"curve", "Shape \"curve\" \"point3 P\" [0 0 0 1 0 0 1 1 0 1 1 1]"},
    {"implicit surface", "Shape \"implicit\" \"string F\" \"x^2 + y^2 + z^2 - 1\" \"point3 bounds\" [-1 -1 -1 1 1 1]"},
    {"instance", "ObjectInstance \"far\""},
};

// An object that stands twice in the scene is an instance; a third one far away does not move it.
TEST(Place, DistantShapesChangeNoBit) {
    const std::string object =
        "ObjectBegin \"far\" Shape \"sphere\" ObjectEnd ObjectInstance \"far\" Translate 0 1 1 ObjectInstance \"far\"\n";
    const FilmImage alone = imageWrittenOut({}), withInstance = imageWrittenOut({}, object);
    for (const Named& outlier : outliers) {
        const bool isInstance = outlier.name == std::string("instance");
        for (const double distance : {1e4, 1e6, 1e8})
            expectSameBits(isInstance ? withInstance : alone,
                           imageWrittenOut({}, (isInstance ? object : "") +
                                                   "AttributeBegin Material \"diffuse\" \"rgb reflectance\" [0 0 0] Translate " +
                                                   Place{}(distance * P(1, -.3, -.5)) + outlier.text + " AttributeEnd"),
                           fmt::format("{} at {:g}", outlier.name, distance));
    }
}

// Squares of squared distances would not fit into a float; the scene is then smaller than 1 in its space.
TEST(Place, AScaleIsChosenThatHoldsAll) {
    const FilmImage alone = imageWrittenOut({});
    for (const double distance : {1e12, 1e16})
        expectSameBits(alone, imageWrittenOut({}, "Translate " + Place{}(distance * P(1, -.3, -.5)) + "Shape \"sphere\""),
                       fmt::format("at {:g}", distance));
}

TEST(Place, AMovedSceneKeepsItsBits) {
    const FilmImage here = imageMoved(P(0));
    for (const double distance : {1e3, 1e6})
        expectSameBits(here, imageMoved(distance * P(1, -.7, .3)), fmt::format("moved by {:g}", distance));
}

// The coordinates of the scene have rounding errors of 2^-53 of the distance: 1e-9 at 1e7.
TEST(Place, CoordinatesMayBeWrittenFarFromTheOrigin) {
    const FilmImage here = imageWrittenOut({});
    for (const double distance : {1e3, 1e5, 1e6, 1e7, 1e8})
        EXPECT_LT(compare(imageWrittenOut({distance * P(1, -.7, .3)}), here).relativeMse, 1e-6) << distance;
}

// A sun of half a degree's order: a ball of a hundredth of its distance lights the scene alike at every distance.
TEST(Place, ALampFarAwayLightsTheScene) {
    const auto lit = [](double distance) {
        return render({"LookAt 0 3 -6 0 .5 0 0 1 0\n" + image + "WorldBegin " + block({}, -.5, 0, 1, 1.3) +
                       "Shape \"bilinearmesh\" \"point3 P\" [-5 0 -5 5 0 -5 -5 0 5 5 0 5]\n"
                       "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [9000 9000 9000] Translate " +
                       Place{}(distance * P(.6, .8, 0)) +
                       fmt::format("Shape \"sphere\" \"float radius\" {:g} AttributeEnd", distance / 100)})
            .image;
    };
    const FilmImage near = lit(1e3);
    for (const double distance : {1e5, 1e8}) EXPECT_LT(compare(lit(distance), near).relativeMse, 1e-3) << distance;
}

}  // namespace
}  // namespace eikonal
