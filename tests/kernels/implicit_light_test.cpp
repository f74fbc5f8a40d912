// Light samples of implicit surfaces are directions.

#include "light_sampling.h"
#include "pack/space.h"
#include "random_inputs.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

light roundLight() {
    light l = newLight(kind_implicit_light);
    l.p = {0.2f, 0.1f, -0.3f};
    l.radius = 0.7f;
    l.inverse_area = 1;
    return l;
}

/// Pearson's test that directions are uniform in the cone around `axis` whose half angle has the cosine `least`, in 16 rings and 16 sectors
/// of equal solid angle.
double probabilityOfUniform(const std::vector<LightResult>& results, glm::dvec3 axis, double least) {
    constexpr int rings = 16, sectors = 16;
    const glm::dvec3 x = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.8, -0.6))), y = glm::cross(axis, x);
    std::vector<double> counts(rings * sectors, 0);
    const std::vector<double> expected(counts.size(), static_cast<double>(results.size()) / (rings * sectors));
    for (const LightResult& r : results) {
        const glm::dvec3 w = toGlm(r.wi);
        const int ring = static_cast<int>((glm::dot(w, axis) - least) / (1 - least) * rings),
                  sector = static_cast<int>((std::atan2(glm::dot(w, y), glm::dot(w, x)) / (2 * M_PI) + .5) * sectors);
        ++counts[static_cast<size_t>(std::clamp(ring, 0, rings - 1) * sectors + std::clamp(sector, 0, sectors - 1))];
    }
    return testChiSquare(counts, expected).probability;
}

// In the cone of the sphere around it, of half angle asin(r / d), and from inside of the sphere in all directions: with the density that
// says so, for rays that hit it as well. The sample ends beyond the sphere, where the shadow ray looks for the surface no further.
TEST(ImplicitLightSamples, AreUniformDirections) {
    const light l = roundLight();
    Random random(71);
    const std::vector<float> u(100000, .5f);
    const auto v = generate(u.size(), [&] { return random.square(); });
    for (const vec3 p : {vec3{0.2f, 0.1f, 0.5f}, vec3{1, 1, 1}, vec3{-30, 5, 2}, vec3{0.2f, 0.1f, -0.3f}, vec3{0.6f, 0.2f, -0.1f}}) {
        const glm::dvec3 to = toGlm(l.p) - toGlm(p);
        const double d = glm::length(to), r = double{l.radius}, least = d > r ? std::sqrt(1 - r * r / (d * d)) : -1;
        const double pdf = 1 / (2 * M_PI * (1 - least));
        const auto results = sample(sceneOf(l), p, u, v);
        for (const LightResult& s : results) {
            ASSERT_NEAR(s.pdf / pdf, 1, 1e-4);
            ASSERT_EQ(s.pdfHit, s.pdf);
            ASSERT_NEAR(dot(s.wi, s.wi), 1, 1e-5);
            ASSERT_GE(glm::dot(toGlm(s.wi), to), least * d - 1e-5 * d);
            ASSERT_GT(s.distance, d + r);
            ASSERT_EQ(s.L.g, 2);
        }
        const glm::dvec3 axis = d > 0 ? to / d : glm::dvec3(0, 0, 1);
        EXPECT_GT(probabilityOfUniform(results, axis, least), significance) << p.x << " " << p.y << " " << p.z;
    }
}

}  // namespace
}  // namespace eikonal
