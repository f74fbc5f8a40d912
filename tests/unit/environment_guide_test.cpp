// What the environment guide learns of a scene: from which directions a sky is seen, and how much of its light comes in.

#include "pack/environment_guide.h"
#include "image/equal_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace eikonal {
namespace {

constexpr size_t bins = GUIDE_SIDE * GUIDE_SIDE;

glm::dvec3 directionOf(size_t bin) {
    return directionFromSquare(
        {(static_cast<double>(bin % GUIDE_SIDE) + 0.5) / GUIDE_SIDE, (static_cast<double>(bin / GUIDE_SIDE) + 0.5) / GUIDE_SIDE});
}

/// The probability of a bin in a map.
double pmfOf(const SceneTables& tables, uint map, size_t bin) {
    const alias_entry* entries = tables.guide_aliases.data() + size_t{map} * GUIDE_MAP_ENTRIES;
    return double{entries[bin / GUIDE_SIDE].pmf} * entries[GUIDE_SIDE + bin].pmf;
}

/// Points all over a unit cube, on surfaces that face up.
struct Floor {
    std::vector<vec3> points, normals;
    explicit Floor(size_t count) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> unit(0, 1);
        for (size_t i = 0; i < count; ++i) points.push_back({unit(random), unit(random), unit(random)});
        normals.assign(count, vec3{0, 0, 1});
    }
};

/// Sees the sky where `isOpen` says so.
template <class IsOpen> WeighMaps seen(IsOpen isOpen) {
    return [isOpen](const GuideRepresentatives& from) {
        std::vector<float> weights;
        for (size_t map = 0; map < from.maps; ++map)
            for (size_t bin = 0; bin < bins; ++bin) {
                const glm::dvec3 d = directionOf(bin);
                weights.push_back(isOpen(d) ? static_cast<float>(static_cast<double>(from.perMap) * std::max(d.z, 0.0)) : 0.0f);
            }
        return weights;
    };
}

constexpr size_t manyRays = 1 << 20;

TEST(EnvironmentGuide, KnowsTheCosineBeforeItLearns) {
    SceneTables tables;
    packUnlearnedGuide(tables);
    ASSERT_EQ(tables.guide_aliases.size(), size_t{GUIDE_FACES} * GUIDE_MAP_ENTRIES);
    for (uint map = 0; map < GUIDE_FACES; ++map) {
        double total = 0;
        for (size_t bin = 0; bin < bins; ++bin) total += pmfOf(tables, map, bin);
        EXPECT_NEAR(total, 1, 1e-5) << map;
    }
    /* Face 4 looks up: no surface whose normal is nearest to +z sees what is below by more than 55 degrees */
    for (size_t bin = 0; bin < bins; ++bin) {
        if (directionOf(bin).z < -0.6) { EXPECT_EQ(pmfOf(tables, 4, bin), 0); }
        if (directionOf(bin).z > 0) { EXPECT_GT(pmfOf(tables, 4, bin), 0); }
        EXPECT_NEAR(pmfOf(tables, GUIDE_ALL_DIRECTIONS, bin), 1.0 / bins, 1e-6);
    }
}

// A window over an eighth of the sphere: nine tenths of the samples go there and to the bins around it, and all others that a surface looks
// at get some.
TEST(EnvironmentGuide, AimsAtTheWindow) {
    const auto isWindow = [](glm::dvec3 d) { return d.x > 0 && d.y > 0 && d.z > 0; };
    const auto isNear = [](glm::dvec3 d) { return d.x > -0.45 && d.y > -0.45 && d.z > -0.45; };
    const Floor floor(20000);
    SceneTables tables;
    const double share = learnGuide(tables, floor.points, floor.normals, {manyRays}, seen(isWindow));
    EXPECT_NEAR(share, 0.25, 0.03);   // a quarter of the directions above
    ASSERT_GT(tables.guide_aliases.size(), size_t{GUIDE_FACES} * GUIDE_MAP_ENTRIES);
    const uint maps = static_cast<uint>(tables.guide_aliases.size() / GUIDE_MAP_ENTRIES);
    for (uint map = GUIDE_FACES; map < maps; ++map) {
        double window = 0, around = 0;
        for (size_t bin = 0; bin < bins; ++bin) {
            const glm::dvec3 d = directionOf(bin);
            if (isWindow(d)) window += pmfOf(tables, map, bin);
            if (isNear(d)) around += pmfOf(tables, map, bin);
            if (d.z > 0) { EXPECT_GT(pmfOf(tables, map, bin), 0); }
        }
        ASSERT_GT(window, 0.4);
        ASSERT_GT(around, 0.9);
    }
}

TEST(EnvironmentGuide, CutsEachAxisIntoIntervalsWithAsManyPoints) {
    const Floor floor(16000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays}, seen([](glm::dvec3) { return true; }));
    ASSERT_EQ(tables.guide_edges.size(), size_t{3 * GUIDE_INTERVALS});
    for (size_t axis = 0; axis < 3; ++axis) {
        const float* edges = tables.guide_edges.data() + axis * GUIDE_INTERVALS;
        for (size_t e = 0; e + 1 < GUIDE_INTERVALS; ++e) EXPECT_NEAR(edges[e], (static_cast<double>(e) + 1) / GUIDE_INTERVALS, 0.02);
        EXPECT_EQ(edges[GUIDE_INTERVALS - 1], FAR_AWAY);
    }
}

TEST(EnvironmentGuide, IsTheSameForTheSamePoints) {
    const Floor floor(5000);
    const auto open = seen([](glm::dvec3 d) { return d.x > 0.3; });
    SceneTables a, b;
    EXPECT_EQ(learnGuide(a, floor.points, floor.normals, {manyRays, true}, open),
              learnGuide(b, floor.points, floor.normals, {manyRays, true}, open));
    EXPECT_EQ(a.guide_maps, b.guide_maps);
    EXPECT_EQ(a.guide_edges, b.guide_edges);
    ASSERT_EQ(a.guide_aliases.size(), b.guide_aliases.size());
    for (size_t i = 0; i < a.guide_aliases.size(); ++i) ASSERT_EQ(a.guide_aliases[i].pmf, b.guide_aliases[i].pmf);
}

// Without points the guide is as it was. In a room that nothing comes into no direction has a density, so that no light sample is taken.
TEST(EnvironmentGuide, LearnsNothingWhereThereIsNothing) {
    const std::vector<vec3> points(8, vec3{0, 0, 0}), none(8, vec3{0, 0, 0});
    SceneTables tables;
    EXPECT_EQ(learnGuide(tables, points, none, {manyRays}, seen([](glm::dvec3) { return true; })), 1);
    EXPECT_EQ(tables.guide_aliases.size(), size_t{GUIDE_FACES} * GUIDE_MAP_ENTRIES);
    const Floor floor(1000);
    EXPECT_EQ(learnGuide(tables, floor.points, floor.normals, {manyRays}, seen([](glm::dvec3) { return false; })), 0);
    for (size_t bin = 0; bin < bins; ++bin) EXPECT_EQ(pmfOf(tables, GUIDE_FACES, bin), 0);
}

// A wall across a floor: the cells behind it see nothing, but those that border on cells that do may.
TEST(EnvironmentGuide, LeavesDarkPlacesToThePaths) {
    const Floor floor(40000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays}, [&](const GuideRepresentatives& from) {
        std::vector<float> weights;
        for (size_t map = 0; map < from.maps; ++map)
            for (size_t bin = 0; bin < bins; ++bin) {
                float sum = 0;
                for (size_t k = map * from.perMap; k < (map + 1) * from.perMap; ++k)
                    sum += from.points[k].x < 0.5f ? static_cast<float>(std::max(directionOf(bin).z, 0.0)) : 0.0f;
                weights.push_back(sum);
            }
        return weights;
    });
    /* Of the 16 cells along x, those from the ninth on are behind the wall, and the ninth borders on one that is not; face 4 looks up */
    size_t dark = 0, lit = 0;
    for (size_t cell = 0; cell < size_t{GUIDE_INTERVALS} * GUIDE_INTERVALS * GUIDE_INTERVALS; ++cell) {
        const uint map = tables.guide_maps[4 * size_t{GUIDE_INTERVALS} * GUIDE_INTERVALS * GUIDE_INTERVALS + cell];
        if (map < GUIDE_FACES) continue;
        double total = 0;
        for (size_t bin = 0; bin < bins; ++bin) total += pmfOf(tables, map, bin);
        const size_t x = cell % GUIDE_INTERVALS;
        if (x < 7) { ++lit; EXPECT_NEAR(total, 1, 1e-5) << x; }
        if (x > 9) { ++dark; EXPECT_EQ(total, 0) << x; }
    }
    EXPECT_GT(dark, 100u);
    EXPECT_GT(lit, 100u);
}

// A few maps say that a scene is open; then no more rays are cast, and the guide stays as it was.
TEST(EnvironmentGuide, GivesUpInTheOpen) {
    const Floor floor(40000);
    SceneTables tables;
    size_t maps = 0;
    const auto isOpen = seen([](glm::dvec3) { return true; });
    const double share =
        learnGuide(tables, floor.points, floor.normals, {.rays = manyRays, .openShare = 0.1}, [&](const GuideRepresentatives& from) {
            maps += from.maps;
            return isOpen(from);
        });
    EXPECT_NEAR(share, 1, 0.07);   // bins are looked at in their middle
    EXPECT_LT(maps, 600u);
    EXPECT_EQ(tables.guide_aliases.size(), size_t{GUIDE_FACES} * GUIDE_MAP_ENTRIES);
    EXPECT_EQ(tables.guide_edges[0], FAR_AWAY);
    /* A closed one is learnt as without that look */
    const auto window = seen([](glm::dvec3 d) { return d.z > 0.95; });
    EXPECT_LT(learnGuide(tables, floor.points, floor.normals, {.rays = manyRays, .openShare = 0.2}, window), 0.15);
    EXPECT_GT(tables.guide_aliases.size(), size_t{GUIDE_FACES} * GUIDE_MAP_ENTRIES);
}

TEST(EnvironmentGuide, IsNotForFewSamples) {
    EXPECT_FALSE(GuideBudget::of(512, 512, 1).isEnough());
    EXPECT_FALSE(GuideBudget::of(16, 16, 256).isEnough());
    EXPECT_TRUE(GuideBudget::of(512, 512, 16).isEnough());
    EXPECT_LE(GuideBudget::of(20000, 20000, 4096).rays, size_t{1} << 23);
}

}  // namespace
}  // namespace eikonal
