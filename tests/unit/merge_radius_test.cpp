// How far vertices of light paths merge at first, chosen by what a first look at a scene finds.

#include "pack/merge_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

/// Points at random on a square of side `side` in the plane y = 0.
SurfacePoints square(size_t count, float side, unsigned seed) {
    std::mt19937 numbers(seed);
    std::uniform_real_distribution<float> along(0, side);
    SurfacePoints all;
    for (size_t i = 0; i < count; ++i) {
        all.points.push_back({along(numbers), 0, along(numbers)});
        all.normals.push_back({0, 1, 0});
    }
    return all;
}

TEST(MergeRadius, FindsTheAreaOnWhichPointsLie) {
    for (const size_t count : {500, 2000}) {
        std::vector<vec3> points = square(count, 3, 1).points;
        EXPECT_NEAR(surfaceOf(points).value(), 9, 1);
        /* Points that were found twice count once */
        points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count * 3 / 4));
        EXPECT_NEAR(surfaceOf(points).value(), 9, 1);
    }
}

TEST(MergeRadius, NeedsSixteenPoints) {
    EXPECT_FALSE(surfaceOf(square(15, 1, 1).points));
    EXPECT_FALSE(surfaceOf(std::vector<vec3>(100, vec3{1, 2, 3})));
    EXPECT_FALSE(chooseMergeRadius({square(15, 1, 1), 2048, square(100, 1, 2), 100}, 100, 100, 1));
}

/// An image of 64 x 64 pixels that shows a square of side 64: a pixel is as wide as 1.
constexpr double pixels = 64 * 64;

TEST(MergeRadius, IsThreePixelsWhereLightIsDense) {
    const MergeView view{square(2000, 64, 1), 2000, square(20000, 64, 2), 4096};
    EXPECT_NEAR(chooseMergeRadius(view, pixels, pixels, 100).value(), 3, 0.3);
    /* Half of the paths from the camera see nothing: those that do lie as densely on what half of the pixels show */
    const MergeView half{square(2000, 64, 1), 4000, square(20000, 64, 2), 4096};
    EXPECT_NEAR(chooseMergeRadius(half, pixels, pixels, 100).value(), 3 * std::sqrt(2.0), 0.4);
}

TEST(MergeRadius, HoldsOneLightVertexWhereLightIsSparse) {
    /* One vertex in 64 squares of side 1. Half of the fourth neighbours lie within sqrt(3.67 / (pi n)) */
    const MergeView view{square(2000, 64, 1), 2000, square(64, 64, 2), 4096};
    const double one = std::sqrt(3.67 / 4 * 64 / M_PI);
    EXPECT_NEAR(chooseMergeRadius(view, pixels, pixels, 100).value(), one, 0.25 * one);
    EXPECT_EQ(chooseMergeRadius(view, pixels, pixels, 3.5).value(), 3.5);
    /* As many times as many paths in a pass as were followed: as many vertices */
    EXPECT_NEAR(chooseMergeRadius(view, pixels, 2 * pixels, 100).value(), one / std::sqrt(2.0), 0.25 * one);
}

TEST(MergeRadius, NeverExceedsTheMost) {
    const MergeView dense{square(2000, 64, 1), 2000, square(20000, 64, 2), 4096}, dark{square(2000, 64, 1), 2000, {}, 4096};
    EXPECT_EQ(chooseMergeRadius(dense, pixels, pixels, 0.5).value(), 0.5);
    EXPECT_EQ(chooseMergeRadius(dark, pixels, pixels, 7).value(), 7);
}

TEST(MergeRadius, VerticesAroundACornerDoNotCount) {
    MergeView view{square(2000, 64, 1), 2000, square(20000, 64, 2), 4096};
    for (vec3& n : view.lit.normals) n = {1, 0, 0};
    EXPECT_EQ(chooseMergeRadius(view, pixels, pixels, 7).value(), 7);
}

}  // namespace
}  // namespace eikonal
