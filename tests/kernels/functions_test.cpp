// Elementary functions as expressions: their errors against double precision are those that functions.clh promises.

#include "device_function.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

struct Values { float exp, log, angle, asin, bessel; };

TEST(Functions, KeepTheirPromises) {
    const DeviceFunction<Values> function({.include = "math/functions.clh",
                                           .type = "values",
                                           .body = "result.exp = exp1(x); result.log = log1(positive); result.angle = atan2_1(at.y, at.x); "
                                                   "result.asin = asin1(unit); result.bessel = scaled_bessel_i0(fabs(x));",
                                           .inputs = {"float x", "float positive", "vec2 at", "float unit"},
                                           .declarations = "typedef struct { float exp, log, angle, asin, bessel; } values;"});
    Random random(3);
    std::vector<float> x{0, -87, 87}, positive{1, 0x1p-126f, 0x1p126f}, unit{0, 1, -1};
    std::vector<vec2> at{{1, 0}, {-1, 0}, {0, -1}};
    for (int i = 0; i < 100000; ++i) {
        x.push_back(random.between(-87, 87));
        positive.push_back(random.logBetween(1e-30f, 1e30f));
        at.push_back({random.between(-2, 2), random.between(-2, 2)});
        unit.push_back(random.between(-1, 1));
    }
    const std::vector<Values> results = function(x, positive, at, unit);
    for (size_t i = 0; i < results.size(); ++i) {
        const double e = x[i], p = positive[i], bessel = std::cyl_bessel_i(0., std::fabs(e)) * std::exp(-std::fabs(e));
        ASSERT_NEAR(results[i].exp / std::exp(e), 1, 3e-7) << e;
        ASSERT_NEAR(results[i].log, std::log(p), std::max(3e-7 * std::fabs(std::log(p)), 1e-7)) << p;
        ASSERT_NEAR(results[i].angle, std::atan2(double(at[i].y), double(at[i].x)), 4e-7) << at[i].x << " " << at[i].y;
        ASSERT_NEAR(results[i].asin, std::asin(double(unit[i])), 6e-7) << unit[i];
        ASSERT_NEAR(results[i].bessel / bessel, 1, 1e-6) << e;
    }
}

TEST(Functions, TheExponentialEndsInZeroAndDoesNotOverflow) {
    const DeviceFunction<float> function(
        {.include = "math/functions.clh", .type = "float", .body = "result = exp1(x);", .inputs = {"float x"}});
    const std::vector<float> results = function(std::vector<float>{-88, -1e30f, 89, 1e30f});
    EXPECT_EQ(results[0], 0);
    EXPECT_EQ(results[1], 0);
    EXPECT_TRUE(std::isfinite(results[2]));
    EXPECT_TRUE(std::isfinite(results[3]));
}

}  // namespace
}  // namespace eikonal
