// Every light of the list LIGHTS is tested somewhere; here, those of a point or one direction.

#include "light_sampling.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace eikonal {
namespace {

/// A point gives E = I / r^2 along the line to it; a distant light its irradiance from one direction; a spot what its cubic
/// between the cosines of the two cones says.
TEST(DeltaLights, GiveTheirIrradiance) {
    light point = newLight(kind_point_light), spot = newLight(kind_spot_light), distant = newLight(kind_distant_light);
    point.p = spot.p = {0.5f, -1, 2};
    spot.n = {0, 0.6f, -0.8f};
    spot.cos_inner = 0.9f; spot.cos_outer = 0.7f;
    distant.n = {0, 0.6f, 0.8f};
    Random random(44);
    for (int i = 0; i < 200; ++i) {
        const vec3 p = random.box(3);
        const glm::dvec3 to = toGlm(point.p) - toGlm(p), w = glm::normalize(to);
        const double r2 = glm::dot(to, to);
        const auto one = [&](const light& l) { return sample(sceneOf(l), p, {0.5f}, {{0.5f, 0.5f}}).front(); };
        const LightResult a = one(point), b = one(spot), c = one(distant);
        for (const LightResult& r : {a, b, c}) { EXPECT_TRUE(r.isDelta); EXPECT_EQ(r.pdf, 1); }
        EXPECT_NEAR(a.L.b, 3 / r2, 1e-5 * 3 / r2);
        EXPECT_NEAR(a.distance, std::sqrt(r2), 1e-5 * std::sqrt(r2));
        EXPECT_NEAR(glm::dot(toGlm(a.wi), w), 1, 1e-6);
        const double x = std::clamp((glm::dot(-w, toGlm(spot.n)) - 0.7) / 0.2, 0.0, 1.0);
        EXPECT_NEAR(b.L.b, 3 / r2 * (3 - 2 * x) * x * x, 1e-5 * 3 / r2);
        EXPECT_EQ(c.L.r, 1);
        EXPECT_EQ(c.wi.y, 0.6f);
        EXPECT_EQ(c.distance, FAR_AWAY);
    }
}

/// Every kind of the list is in one of the tests here, in area_light_test.cpp or in environment_test.cpp.
TEST(LightList, IsCovered) {
    const std::set<std::string> tested{"point",          "spot",        "distant",    "triangle",       "bilinear",
                                       "sphere",         "ellipsoid",   "disk",       "cylinder",       "uniform_infinite",
                                       "image_infinite", "goniometric", "projection", "portal_infinite" /* image_light_test.cpp */,
                                       "implicit" /* implicit_light_test.cpp */};
#define EXPECT_TESTED(name, FEATURE, PLACE) \
    EXPECT_TRUE(tested.count(#name)) << "no test knows what a " #name " light should give: add one here";
    LIGHTS(EXPECT_TESTED)
#undef EXPECT_TESTED
}

}  // namespace
}  // namespace eikonal
