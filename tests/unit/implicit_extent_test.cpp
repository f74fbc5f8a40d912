// Where an implicit surface is, and how large: for light samples.

#include "pack/implicit.h"
#include "pack/implicit_bounds.h"
#include "pack/implicit_extent.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

std::vector<implicit_instruction> programOf(const std::string& F) {
    const SourceLocation where;
    return implicitProgram(readExpression(F, where), where);
}
ImplicitExtent extentOf(const std::string& F, const glm::dmat4& m = glm::dmat4(1), double half = 1.1) {
    return extentOf(programOf(F), {glm::dvec3(-half), glm::dvec3(half)}, m);
}

// The cells of the surface are a 64th of the box wide, so the sphere reaches at most one diagonal, .06, beyond. A mesh inside of a ball of
// curvature 1 with edges up to .06 lacks less than .06^2 / 4 of its area.
TEST(ImplicitExtent, OfABallAndARing) {
    const ImplicitExtent ball = extentOf("x^2 + y^2 + z^2 - 1");
    EXPECT_LT(glm::length(ball.center), 1e-6);
    EXPECT_GE(ball.radius, 1);
    EXPECT_LT(ball.radius, 1.06);
    EXPECT_NEAR(ball.area / (4 * M_PI), 1, .001);
    const ImplicitExtent ring = extentOf("(sqrt(x^2 + z^2) - .7)^2 + y^2 - .0625");
    EXPECT_NEAR(ring.area / (4 * M_PI * M_PI * .7 * .25), 1, .015);
    EXPECT_GE(ring.radius, .95);
    EXPECT_LT(ring.radius, 1.01);
}

// Only half of the ball is in the box; a transform moves and stretches what the device will see: 3 times as long, 9 times the area.
TEST(ImplicitExtent, IsThatOfThePartInTheBoxTransformed) {
    const glm::dmat4 m = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(5, 6, 7)), glm::dvec3(3, -3, 3));
    const ImplicitExtent half = extentOf(programOf("x^2 + y^2 + z^2 - 1"), {{-1.1, 0, -1.1}, {1.1, 1.1, 1.1}}, m);
    EXPECT_NEAR(half.area / (9 * 2 * M_PI), 1, .001);
    EXPECT_NEAR(half.center.y, 6 - 1.5, .1);
    EXPECT_LT(half.radius, 3 * std::sqrt(1.25) + .2);
}

// Where F only touches 0, or a shell is thinner than a cell, the number of cells tells the area: to a factor of two.
TEST(ImplicitExtent, OfWhatHasNoThickness) {
    for (const char* F : {"(x^2 + y^2 + z^2 - 1)^2", "abs(x^2 + y^2 + z^2 - 1) - 1e-4"}) {
        const ImplicitExtent thin = extentOf(F);
        EXPECT_GT(thin.area, 2 * M_PI) << F;
        EXPECT_LT(thin.area, 8 * M_PI) << F;
        EXPECT_GE(thin.radius, 1) << F;
    }
    for (const char* F : {"x^2 + y^2 + 1", "sqrt(x - 3)", "log(0 - 1 - x^2)"}) EXPECT_EQ(extentOf(F).radius, 0) << F;
}

// Bounds over a box contain F at its points, for every operation.
TEST(ImplicitBounds, ContainTheValues) {
    struct { const char* text; double (*f)(double, double, double); } const functions[] = {
        {"x*y - 3/z + 2", [](double x, double y, double z) { return x * y - 3 / z + 2; }},
        {"(x - y)^3 + z^4 - x^2", [](double x, double y, double z) { return std::pow(x - y, 3) + std::pow(z, 4) - x * x; }},
        {"x^1.5 + sqrt(y) - log(z)", [](double x, double y, double z) { return std::pow(x, 1.5) + std::sqrt(y) - std::log(z); }},
        {"sin(5*x) + cos(7*y) - tanh(z)", [](double x, double y, double z) { return std::sin(5 * x) + std::cos(7 * y) - std::tanh(z); }},
        {"asin(x/3) + acos(y/3) + atan(z)",
         [](double x, double y, double z) { return std::asin(x / 3) + std::acos(y / 3) + std::atan(z); }},
        {"atan2(y, x)*exp(z)", [](double x, double y, double z) { return std::atan2(y, x) * std::exp(z); }},
        {"max(abs(x) - 1, min(y, z))", [](double x, double y, double z) { return std::max(std::abs(x) - 1, std::min(y, z)); }},
    };
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const auto& [text, f] : functions) {
        const auto program = programOf(text);
        for (int i = 0; i < 2000; ++i) {
            Box box;
            const double size = std::pow(10, -4 * unit(random));
            box.grow(glm::dvec3(-2 + 4 * unit(random), -2 + 4 * unit(random), -2 + 4 * unit(random)));
            box.grow(box.low + size * glm::dvec3(unit(random), unit(random), unit(random)));
            const glm::dvec3 p = glm::mix(box.low, box.high, glm::dvec3(unit(random), unit(random), unit(random)));
            const double value = f(p.x, p.y, p.z);
            if (!std::isfinite(value)) continue;
            const auto bounds = boundsOver(program, box);
            ASSERT_TRUE(bounds) << text;
            ASSERT_GE(value, bounds->low) << text;
            ASSERT_LE(value, bounds->high) << text;
        }
    }
}

}  // namespace
}  // namespace eikonal
