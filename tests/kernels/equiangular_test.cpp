// Ways through a medium that are sampled towards point lights.

#include "medium_walk.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace eikonal {
namespace {

/// The brighter light has the larger share, and only what scatters has any, in RGB and at wavelengths.
TEST(Equiangular, ShareWaysByBrightness) {
    for (ColorMode color : {ColorMode::rgb, ColorMode::spectral}) {
        const auto pack = [&](const std::string& sigma) {
            return packText(
                "WorldBegin\nLightSource \"point\" \"rgb I\" [ 1 .5 .2 ] LightSource \"point\" \"rgb I\" [ 3 1.5 .6 ] \"point3 from\" [ 1 "
                "0 0 ]\n"
                "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" " +
                    sigma + " MediumInterface \"fog\" \"\" Material \"interface\" Shape \"sphere\"",
                color);
        };
        const PackedScene fog = pack("\"rgb sigma_s\" [ 1 1 1 ]");
        ASSERT_EQ(fog.tables.point_lights.size(), 2u);
        EXPECT_NEAR(fog.tables.point_lights[0].share, 0.75, 1e-5);
        EXPECT_FALSE(pack("\"rgb sigma_a\" [ 1 1 1 ] \"rgb sigma_s\" [ 0 0 0 ]").features.has(Feature::EQUIANGULAR));
    }
}

/// Ways that are sampled towards point lights: the density that they are weighted with is theirs, and means are right in every channel.
TEST(Equiangular, WaysTowardsThemAreWeightedRight) {
    const PackedScene packed =
        sceneWith("homogeneous", parametersOf("homogeneous"),
                  R"(LightSource "point" "point3 from" [ 0 0.32 0.1 ] LightSource "spot" "rgb I" [ 3 3 3 ] "point3 from" [ 0.4 0.6 0.3 ])");
    ASSERT_TRUE(packed.features.has(Feature::EQUIANGULAR));
    ASSERT_EQ(packed.tables.media[0].equiangular_lights, 2u);
    const DeviceScene onDevice(testContext(), packed);

    /* Distances against their density, integrated over bins */
    const DeviceFunction<vec3> function({.include = "medium/medium.clh",
                                         .type = "vec3",
                                         .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        float sum = 0.0f, step = 2.0f / 40.0f / 64.0f;
        for (int i = 0; i < 64; ++i) sum += pdf_equiangular(medium_set.point_lights, 2u, o, d, 2.0f,
            u.x * 2.0f + ((float)i + 0.5f) * step) * step;
        result = make_vec3(sample_equiangular(medium_set.point_lights, 2u, o, d, 2.0f, u.x, u.y), sum,
            equiangular_share(medium_set.point_lights, 2u, o, d, 2.0f, 3.0f));)",
                                         .inputs = {"vec3 o", "vec3 d", "vec2 u"},
                                         .tables = "MEDIUM_TABLES(TABLE)"});
    Random random(13);
    constexpr size_t n = 20000, bins = 40;
    for (const MediumRay& ray : rays) {
        std::vector<vec2> u;
        for (size_t i = 0; i < n; ++i) u.push_back(random.square());
        std::vector<double> counts(bins), expected;
        for (const vec3& r : function.with(onDevice, std::vector<vec3>(n, ray.o), std::vector<vec3>(n, ray.d), u)) {
            ++counts[std::min(static_cast<size_t>(r.x / wayLength * bins), bins - 1)];
            ASSERT_GE(r.z, 0);
            ASSERT_LE(r.z, 0.25f);
        }
        std::vector<vec2> starts;
        for (size_t i = 0; i < bins; ++i) starts.push_back({static_cast<float>(i) / bins, 0.5f});
        for (const vec3& r : function.with(onDevice, std::vector<vec3>(bins, ray.o), std::vector<vec3>(bins, ray.d), starts))
            expected.push_back(n * double(r.y));
        const ChiSquare test = testChiSquare(counts, expected);
        EXPECT_GT(test.probability, significance) << test.describe();
        expectWeights(onDevice, ray);
    }
}

}  // namespace
}  // namespace eikonal
