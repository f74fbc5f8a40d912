// Light from every kind of source on a diffuse floor, with the irradiance derived in each test (lit_floor.h).

#include "lit_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

// E = I cos / d^2 from (1, 2, .5): d^2 = 5.25, cos = 2 / d.
TEST(Light, APointFallsOffWithTheSquareOfTheDistance) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 2 1] \"point3 from\" [1 2 .5]"),
                   rho / pi * glm::dvec3(3, 2, 1) * 2. / std::pow(5.25, 1.5));
}

// From straight above at height 2 with the axis turned away by an angle: all of I inside of the inner cone (20 degrees), none outside of
// the outer one (30), and smoothstep of the cosine between them.
TEST(Light, ASpotHasACone) {
    const double inner = std::cos(20 * pi / 180), outer = std::cos(30 * pi / 180);
    for (double angle : {0., 15., 24., 27., 35.}) {
        SCOPED_TRACE(angle);
        const double cosine = std::cos(angle * pi / 180), t = std::clamp((cosine - outer) / (inner - outer), 0., 1.);
        const Rendered r =
            onTheFloor(fmt::format("LightSource \"spot\" \"rgb I\" [3 3 3] \"float coneangle\" 30 \"float conedeltaangle\" 10 \"point3 "
                                   "from\" [0 2 0] \"point3 to\" [{} 0 0]",
                                   2 * std::tan(angle * pi / 180)));
        /* The cosine is rounded to a float: near the rim that shows */
        const Estimate e = estimate(r.image);
        EXPECT_NEAR(e.mean.g, rho / pi * 3 / 4 * t * t * (3 - 2 * t), 2e-5);
    }
}

// E = L cos, whatever the distance.
TEST(Light, ADistantOneLosesTheCosine) {
    expectRadiance(onTheFloor("LightSource \"distant\" \"rgb L\" [3 2 1] \"point3 from\" [3 4 0] \"point3 to\" [0 0 0]"),
                   rho / pi * glm::dvec3(3, 2, 1) * 0.8);
}

// E = pi L for a sky all over.
TEST(Light, ASkyLightsTheFloorEvenly) { expectRadiance(onTheFloor("LightSource \"infinite\" \"rgb L\" [1 1 1]"), rho); }

// A disk of radius R parallel to the floor at height h: E = pi L R^2 / (R^2 + h^2).
TEST(Light, ADisk) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5")),
                   rho * Le * 2.25 / (2.25 + 4));
}
// A ring is the difference of two.
TEST(Light, ARing) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" 1.5 \"float innerradius\" 1")),
                   rho * Le * (2.25 / (2.25 + 4) - 1. / (1 + 4)));
}

// A sphere of radius r with its centre at height d: E = pi L (r / d)^2, as if all of it came from straight above.
TEST(Light, ASphere) {
    expectRadiance(onTheFloor(emitter("Translate 0 2 0 Shape \"sphere\" \"float radius\" .8")), rho * Le * 0.16);
}

// A dome around the point that shines inwards, from height a up, is a cap of the sky: E = pi L (1 - (a / R)^2), and a fourth of it missing
// in the round. Squashed to half its height: its rim of radius R sqrt(3) / 2 is at the height R / 4. Its power is that of the area that
// there is.
TEST(Light, APartOfASphereOrAnEllipsoid) {
    const std::string dome = "ReverseOrientation Rotate -90 1 0 0 ", part = "Shape \"sphere\" \"float radius\" 3 \"float zmin\" 1.5";
    expectRadiance(onTheFloor(emitter(dome + part)), rho * Le * .75);
    expectRadiance(onTheFloor(emitter(dome + part + " \"float phimax\" 270")), rho * Le * .75 * .75);
    expectRadiance(onTheFloor(emitter(dome + "Scale 1 1 .5 " + part)), rho * Le * (.75 / (.75 + 1. / 16)));
    expectRadiance(onTheFloor(emitter(dome + "Scale 1 -1 .5 " + part, "\"bool twosided\" true")), rho * Le * (.75 / (.75 + 1. / 16)));
    expectRadiance(onTheFloor(emitter(dome + part, "\"float power\" 100")), rho * Le * .75 * 100 / (pi * 2 * pi * 3 * 1.5));
}

// A wall around the point, from height a to b at distance R, fills a band of angles: E = pi L (sin^2 - sin^2) = pi L R^2 (1 / (R^2 + a^2) -
// 1 / (R^2 + b^2)) where it is whole, and as much of that as of the circle. Its outside does not shine.
TEST(Light, ACylinder) {
    const double band = 9 / (9 + .25) - 9 / (9 + 9.);
    const std::string wall = "Rotate -90 1 0 0 Shape \"cylinder\" \"float radius\" 3 \"float zmin\" .5 \"float zmax\" 3";
    expectRadiance(onTheFloor(emitter("ReverseOrientation " + wall)), rho * Le * band);
    expectRadiance(onTheFloor(emitter("ReverseOrientation " + wall + " \"float phimax\" 270")), rho * Le * band * 0.75);
    expectRadiance(onTheFloor(emitter(wall)), 0);
}

TEST(Light, ARectangleOfTriangles) {
    expectRadiance(
        onTheFloor(emitter("Shape \"trianglemesh\" \"point3 P\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7] \"integer indices\" [0 1 2 0 2 3]")),
        rho / pi * irradianceOfRectangle(1.2, .7));
}
TEST(Light, ARectangleAsABilinearPatch) {
    expectRadiance(onTheFloor(emitter("Shape \"bilinearmesh\" \"point3 P\" [0 1 0  1.2 1 0  0 1 .7  1.2 1 .7]")),
                   rho / pi * irradianceOfRectangle(1.2, .7));
}

// Only one side shines, unless both are asked to.
TEST(Light, TheBackOfAnEmitterIsDarkUnlessItIsTwoSided) {
    const std::string away = "Shape \"trianglemesh\" \"point3 P\" [0 1 0  0 1 .7  1.2 1 .7  1.2 1 0] \"integer indices\" [0 1 2 0 2 3]";
    EXPECT_EQ(estimate(onTheFloor(emitter(away)).image).mean, glm::dvec3(0));
    expectRadiance(onTheFloor(emitter(away, "\"bool twosided\" true")), rho / pi * irradianceOfRectangle(1.2, .7));
}

// What shines looks as bright from everywhere, and no light is added to it at maxdepth 0.
TEST(Light, AnEmitterLooksAsBrightAsItIs) {
    for (const char* shape :
         {"Shape \"sphere\" \"float radius\" .3", "Rotate 20 1 1 0 ReverseOrientation Shape \"disk\" \"float radius\" .3"}) {
        SCOPED_TRACE(shape);
        View view;
        view.maxDepth = 0;
        expectRadiance(render(sceneText(view, emitter(shape)), surfaces()), Le);
    }
}

// Lights add up, whichever is picked how often.
TEST(Light, ManyLightsAddUp) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\nLightSource \"distant\" \"rgb L\" [.1 .1 "
                              ".1] \"point3 from\" [1 1 0] \"point3 to\" [0 0 0]\n" +
                              emitter("Translate 0 2.5 0 Shape \"sphere\" \"float radius\" .1") +
                              "\nLightSource \"point\" \"rgb I\" [.01 .01 .01] \"point3 from\" [0 .1 0]"),
                   rho / pi * (3. / 4 + 0.1 * std::sqrt(0.5) + Le * pi * 0.0016 + 1), 0.06);
}

// Whoever chooses the lights, they add up to the same.
TEST(Light, EverySamplerAddsUpToTheSame) {
    for (const char* sampler : {"bvh", "power", "uniform"}) {
        SCOPED_TRACE(sampler);
        View view = atTheOrigin();
        view.more = fmt::format("Integrator \"volpath\" \"integer maxdepth\" 1 \"string lightsampler\" \"{}\"", sampler);
        const std::string lights =
            "LightSource \"infinite\" \"rgb L\" [.2 .2 .2]\nLightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\n"
            "LightSource \"distant\" \"rgb L\" [.1 .1 .1] \"point3 from\" [1 1 0] \"point3 to\" [0 0 0]\n" +
            emitter("Translate 0 2.5 0 Shape \"sphere\" \"float radius\" .1") +
            "\nLightSource \"point\" \"rgb I\" [.01 .01 .01] \"point3 from\" [0 .1 0]";
        /* The lamp hides a part of the sky: that of its cone, which is (r / h)^2 of the cosine-weighted half */
        expectRadiance(render(sceneText(view, lights + "\n" + floorShape), surfaces()),
                       rho / pi * (3. / 4 + 0.1 * std::sqrt(0.5) + Le * pi * 0.0016 + 1 + 0.2 * pi * (1 - 0.0016)), 0.06);
    }
}

}  // namespace
}  // namespace eikonal
