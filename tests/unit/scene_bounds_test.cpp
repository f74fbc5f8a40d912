// Which shapes a scene's space is chosen for, and which origin positions are relative to.

#include "pack/scene_bounds.h"
#include "read/mesh/origin.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

Box cube(glm::dvec3 center, double half) { return {center - half, center + half}; }
PlacedBox seen(const Box& box, double sight) { return {box, sight}; }

void expectBox(const Box& a, const Box& b) {
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
}

TEST(SceneBounds, DistantShapesDoNotCount) {
    const Box ball = cube({0, 0, 5}, 1), floor = cube({0, -3, 0}, 2);
    Box both = ball;
    both.grow(floor);
    for (const double distance : {1e4, 1e6, 1e8, 1e12}) {
        const PlacedBox boxes[] = {seen(cube({distance, 0, 0}, 1), 0.1 / distance / distance), seen(ball, 0.02), seen(floor, 0.3)};
        expectBox(nearBox(boxes, {0, 0, 0}), both);
    }
}

// Both are seen as well: an origin near the first helps it, and hurts the other by as much.
TEST(SceneBounds, WhatFillsTheImageCounts) {
    const PlacedBox equal[] = {seen(cube({0, 0, 1e5}, 1), 0.5), seen(cube({0, 0, 0}, 1), 0.5)};
    const PlacedBox large[] = {seen(cube({0, 0, 1e6}, 1e5), 0.1), seen(cube({0, 0, 3e5}, 1e4), 0.1)};
    for (const std::span<const PlacedBox> boxes : {std::span(equal), std::span(large)}) {
        Box all = boxes[0].box;
        all.grow(boxes[1].box);
        expectBox(nearBox(boxes, {0, 0, 0}), all);
    }
}

TEST(SceneBounds, EmptyAndPointlikeScenes) {
    EXPECT_TRUE(nearBox({}, {0, 0, 0}).empty());
    const PlacedBox point[] = {seen(cube({3, 4, 5}, 0), 0)};
    expectBox(nearBox(point, {0, 0, 0}), cube({3, 4, 5}, 0));
}

TEST(SceneBounds, CoordinatesStayBelowTwoToTheForty) {
    SceneBounds bounds{cube({0, 0, 0}, 1e30), cube({5, 0, 0}, 1)};
    const SceneSpace space = spaceOf(bounds);
    EXPECT_EQ(space.center, glm::dvec3(5, 0, 0));
    const double reach = glm::length(transformPoint(space.sceneFromWorld(), glm::dvec3(-1e30)));
    EXPECT_LE(reach, 0x1p40);
    EXPECT_GT(reach, 0x1p38);
}

TEST(Origin, OfPointsFarAwayIsInTheirMiddle) {
    const std::vector<glm::dvec3> far{{1e7 + 0.1, 0, 0}, {1e7 + 0.3, 1, 2}};
    const glm::dvec3 origin = originOf(far);
    EXPECT_EQ(origin, 0.5 * (far[0] + far[1]));
    const std::vector<glm::vec3> positions = positionsFrom(origin, far);
    for (size_t i = 0; i < 2; ++i) EXPECT_LT(glm::length(origin + glm::dvec3(positions[i]) - far[i]), 1e-6);
}

TEST(Origin, IsZeroWhereFloatsDo) {
    EXPECT_EQ(originOf(std::vector<glm::dvec3>{{100.5, 0, 0}, {100.25, 1, 0}}), glm::dvec3(0)) << "floats hold these";
    EXPECT_EQ(originOf(std::vector<glm::dvec3>{{1.1, 0, 0}, {2.3, 1, 0}}), glm::dvec3(0)) << "these are near";
    EXPECT_EQ(originOf(std::vector<glm::dvec3>{}), glm::dvec3(0));
}

}  // namespace
}  // namespace eikonal
