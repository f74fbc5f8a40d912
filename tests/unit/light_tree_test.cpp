// Building the light tree: every light is in it once, below bounds that hold it.

#include "pack/light_tree.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>

namespace eikonal {
namespace {

std::vector<LightBounds> crowd(size_t count) {
    std::mt19937 engine(1);
    std::normal_distribution<double> normal;
    std::vector<LightBounds> lights(count);
    for (LightBounds& b : lights) {
        const glm::dvec3 p(normal(engine), normal(engine), normal(engine)), size(0.01 * std::abs(normal(engine)));
        b.box = {p, p + size};
        b.axis = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        b.emission = M_PI / 2;
        b.intensity = std::exp(normal(engine));
    }
    return lights;
}

void expectValid(const LightTree& tree, const std::vector<LightBounds>& lights) {
    size_t found = 0;
    for (size_t i = 0; i < lights.size(); ++i) {
        if (!(lights[i].intensity > 0)) { EXPECT_EQ(tree.leaves[i], NONE); continue; }
        uint at = tree.leaves[i];
        ASSERT_NE(at, NONE);
        EXPECT_EQ(tree.nodes[at / LIGHT_TREE_WIDTH].child[at % LIGHT_TREE_WIDTH], LIGHT_BIT | i);
        ++found;
        for (int depth = 0; at != NONE; ++depth) {
            ASSERT_LE(depth, tree.depth);
            const light_node& n = tree.nodes[at / LIGHT_TREE_WIDTH];
            const size_t lane = at % LIGHT_TREE_WIDTH;
            const glm::dvec3 center(n.x[lane], n.y[lane], n.z[lane]), axis(n.axis_x[lane], n.axis_y[lane], n.axis_z[lane]);
            for (const glm::dvec3& corner : {lights[i].box.low, lights[i].box.high})
                EXPECT_LE(glm::length(corner - center), n.radius[lane]);
            if (n.cos_normals[lane] > -1) {
                EXPECT_GE(glm::dot(axis, lights[i].axis), std::cos(std::acos(n.cos_normals[lane]) - lights[i].normals) - 1e-6);
            }
            EXPECT_LE(n.cos_emission[lane], std::cos(lights[i].emission) + 1e-6);
            EXPECT_GE(n.intensity[lane], lights[i].intensity * (1 - 1e-6));
            at = n.parent;
        }
    }
    EXPECT_EQ(found, tree.lights);
}

TEST(LightTree, HoldsEveryLightOnce) {
    for (size_t count : {1u, 2u, 8u, 9u, 300u}) {
        const auto lights = crowd(count);
        expectValid(buildLightTree(lights), lights);
    }
}

TEST(LightTree, LeavesOutWhatDoesNotShine) {
    auto lights = crowd(20);
    for (size_t i = 0; i < lights.size(); i += 3) lights[i].intensity = 0;
    expectValid(buildLightTree(lights), lights);
    for (LightBounds& b : lights) b.intensity = 0;
    EXPECT_TRUE(buildLightTree(lights).nodes.empty());
    EXPECT_TRUE(buildLightTree({}).nodes.empty());
}

// At one place nothing separates them; on a line of growing distances a tree by cost would be as deep as there are lights.
TEST(LightTree, StandsWhatDoesNotSplitWell) {
    auto together = crowd(1000), apart = crowd(1000);
    for (LightBounds& b : together) b.box = {glm::dvec3(1), glm::dvec3(1)};
    for (size_t i = 0; i < apart.size(); ++i) {
        const glm::dvec3 p(std::pow(2.0, -0.2 * static_cast<double>(i)), 0, 0);
        apart[i].box = {p, p};
    }
    for (const auto& lights : {together, apart}) {
        const LightTree tree = buildLightTree(lights);
        expectValid(tree, lights);
        EXPECT_LT(tree.depth, 40);
    }
}

// n log n: a hundred times as many lights take far less than ten thousand times as long.
TEST(LightTree, IsBuiltQuickly) {
    const auto time = [](size_t count) {
        const auto lights = crowd(count);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(buildLightTree(lights).lights, count);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    time(1000);
    EXPECT_LT(time(100000), 1500 * std::max(time(1000), 1e-4));
}

}  // namespace
}  // namespace eikonal
