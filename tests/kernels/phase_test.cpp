// The phase function against its closed form.

#include "device_function.h"
#include "random_inputs.h"
#include "statistics.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// The phase function is a density, is what it is sampled with, and turns light by the cosine g on average.
TEST(Phase, IsTheDensityOfItsSamples) {
    struct Phase { vec3 wi; float value; };
    const DeviceFunction<Phase> function({.include = "medium/phase.clh",
                                          .type = "phase_sample",
                                          .body = "result.wi = sample_phase(g, wo, u); result.value = eval_phase(g, wo, result.wi);",
                                          .inputs = {"float g", "vec3 wo", "vec2 u"},
                                          .declarations = "typedef struct { vec3 wi; float value; } phase_sample;"});
    Random random(5);
    constexpr size_t n = 20000, cosines = 20, turns = 8;
    for (const double g : {-0.99, -0.6, -1e-4, 0., 0.3, 0.9, 0.99}) {
        const vec3 wo = random.direction();
        std::vector<vec2> u;
        for (size_t i = 0; i < n; ++i) u.push_back(random.square());
        std::vector<double> counts(cosines * turns), expected;
        /* Any two directions that are perpendicular to wo and each other */
        const glm::dvec3 z = glm::normalize(glm::dvec3(wo.x, wo.y, wo.z)),
                         x = glm::normalize(glm::cross(z, std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                         y = glm::cross(z, x);
        Accumulator turned;
        for (const Phase& s : function(std::vector<float>(n, float(g)), std::vector<vec3>(n, wo), u)) {
            const glm::dvec3 wi(s.wi.x, s.wi.y, s.wi.z);
            const double cosine = -glm::dot(wi, z), phi = std::atan2(glm::dot(wi, y), glm::dot(wi, x)) / (2 * M_PI) + 0.5;
            turned.add(cosine);
            const double closed = (1 - g * g) / (4 * M_PI * std::pow(std::max(1 + g * g - 2 * g * cosine, 1e-12), 1.5));
            EXPECT_NEAR(s.value, closed, 1e-3 * closed + 1e-2 * std::abs(g) * closed * closed) << "g " << g << " cosine " << cosine;
            ++counts[std::min(size_t((cosine + 1) / 2 * cosines), cosines - 1) * turns + std::min(size_t(phi * turns), turns - 1)];
        }
        /* The integral from cosine -1 on, in closed form */
        const auto below = [&](double cosine) {
            return std::abs(g) < 1e-3 ? (cosine + 1) / 2
                                      : (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * cosine) - 1 / (1 + g));
        };
        for (size_t i = 0; i < cosines; ++i)
            for (size_t j = 0; j < turns; ++j)
                expected.push_back(n / double(turns) * (below(-1 + 2. * double(i + 1) / cosines) - below(-1 + 2. * double(i) / cosines)));
        const ChiSquare test = testChiSquare(counts, expected);
        EXPECT_GT(test.probability, significance) << "g " << g << ": " << test.describe();
        EXPECT_NEAR(turned.estimate().mean, g, 4.5 * turned.estimate().error + 1e-3);
    }
}

}  // namespace
}  // namespace eikonal
