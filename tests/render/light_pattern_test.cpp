// Areas that do not shine alike all over: cut out, or by an image.

#include "lit_floor.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace eikonal {
namespace {

const std::string leftHalf = "Texture \"half\" \"float\" \"checkerboard\" \"float uscale\" 2\n";
const std::string rectanglePatch = "Shape \"bilinearmesh\" \"point3 P\" [0 1 0  1.2 1 0  0 1 .7  1.2 1 .7] ";
const std::string rectangleTriangles =
    "Shape \"trianglemesh\" \"point3 P\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7] \"point2 uv\" [0 0  1 0  1 1  0 1] \"integer indices\" [0 1 2 "
    "0 2 3] ";

/// As in light_test.cpp: a wall around the point, from height .5 to 3 at distance 3.
const std::string wallAround =
    "ReverseOrientation Rotate -90 1 0 0 Shape \"cylinder\" \"float radius\" 3 \"float zmin\" .5 \"float zmax\" 3 ";
constexpr double wallBand = 9 / (9 + .25) - 9 / (9 + 9.);

// Where alpha is 0 nothing shines: half of a rectangle; half of a disk or a sphere above the floor, by symmetry; and any alpha between
// takes its share.
TEST(LightPattern, WhatIsCutOutIsDark) {
    const std::string half = "\"texture alpha\" \"half\"";
    for (const std::string& rectangle : {rectanglePatch, rectangleTriangles}) {
        SCOPED_TRACE(rectangle);
        expectRadiance(onTheFloor(leftHalf + emitter(rectangle + half)), rho / pi * irradianceOfRectangle(.6, .7));
        expectRadiance(onTheFloor(emitter(rectangle + "\"float alpha\" .3")), rho / pi * .3 * irradianceOfRectangle(1.2, .7));
    }
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5 " + half)),
                   rho * Le * 2.25 / (2.25 + 4) / 2);
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"sphere\" \"float radius\" .8 " + half)),
                   rho * Le * 0.16 / 2);
    expectRadiance(onTheFloor(leftHalf + emitter(wallAround + half)), rho * Le * wallBand / 2);
}

// Vertex normals choose the side that shines, as in pbrt-v4: of those that turn over, half of the rectangle shines down. Light samples know
// it, too: an alpha of 0 hides the lamp from all other rays.
TEST(LightPattern, NormalsThatTurnChooseTheSide) {
    const std::string turning = "\"normal N\" [0 -1 0  0 1 0  0 {0} 0  0 {1} 0] ";
    for (const char* alpha : {"", "\"float alpha\" 0"}) {
        SCOPED_TRACE(alpha);
        const double half = rho / pi * irradianceOfRectangle(.6, .7), both = rho / pi * irradianceOfRectangle(1.2, .7);
        const std::string patch = rectanglePatch + fmt::format(fmt::runtime(turning), -1, 1) + alpha,
                          triangles = rectangleTriangles + fmt::format(fmt::runtime(turning), 1, -1) + alpha;
        expectRadiance(onTheFloor(emitter(patch)), half);
        expectRadiance(onTheFloor(emitter(triangles)), half);
        expectRadiance(onTheFloor(emitter(triangles, "\"bool twosided\" true")), both);
    }
}

// Without its lower half (u < 1/2 is y > 0), a sphere that shines inside as well looks like a disk of its radius at its centre.
TEST(LightPattern, TheFarSideOfASphereIsSeenThroughItsHole) {
    expectRadiance(onTheFloor(leftHalf + emitter("Translate 0 2 0 Shape \"sphere\" \"float radius\" .8 \"texture alpha\" \"half\"",
                                                 "\"bool twosided\" true")),
                   rho * Le * 0.64 / (0.64 + 4));
}

// An image of a red and a blue texel on the rectangle: blue rises from u = 1/4 to u = 3/4, red falls; E by quadrature.
TEST(LightPattern, AnImageShinesWhereItIsBright) {
    const auto file = std::filesystem::temp_directory_path() / fmt::format("eikonal_light_{}.ppm", ::getpid());
    std::ofstream(file) << "P3\n2 1\n255\n255 0 0 0 0 255\n";
    glm::dvec3 E(0);
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + .5) / n, blue = std::clamp(2 * u - .5, 0., 1.),
                         d2 = 1 + std::pow(1.2 * u, 2) + std::pow(.7 * (j + .5) / n, 2);
            E += glm::dvec3(1 - blue, 0, blue) * Le * (1.2 * .7 / (n * n)) / (d2 * d2);
        }
    for (const std::string& rectangle : {rectanglePatch, rectangleTriangles}) {
        SCOPED_TRACE(rectangle);
        const std::string L = fmt::format("AreaLightSource \"diffuse\" \"string filename\" \"{}\" ", file.string());
        const auto lit = [&](const std::string& more) {
            return onTheFloor("AttributeBegin " + L + more + " Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n" + rectangle +
                              "\nAttributeEnd");
        };
        expectRadiance(lit("\"float scale\" 4"), rho / pi * E);
        /* In watts, of each triangle or patch (as in pbrt-v4): pi times the area times the mean luminance, of which red has 0.2126 and blue
         * 0.0722 */
        const double elements = rectangle == rectangleTriangles ? 2 : 1;
        expectRadiance(lit("\"float power\" 3"), rho / pi * E / Le * 3. * elements / (pi * 1.2 * .7 * (0.2126 + 0.0722) / 2));
    }
    /* Around the axis of a disk, a ball and a wall, on both sides: each colour takes half of the circle, and what one loses to the other at
     * one end it gets at the other */
    const auto round = [&](const std::string& shape) {
        return onTheFloor(
            fmt::format("AttributeBegin AreaLightSource \"diffuse\" \"string filename\" \"{}\" \"float scale\" 4 \"bool twosided\" true "
                        "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n{}\nAttributeEnd",
                        file.string(), shape));
    };
    const glm::dvec3 each = rho * Le * glm::dvec3(.5, 0, .5);
    expectRadiance(round("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5"), each * (2.25 / (2.25 + 4)));
    expectRadiance(round("Translate 0 2 0 Rotate 90 1 0 0 Shape \"sphere\" \"float radius\" .8"), each * .16);
    expectRadiance(round(wallAround), each * wallBand);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace eikonal
