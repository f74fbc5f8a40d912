// What the environment guide learns of a scene: where the light of a sky enters, and how much of it comes in.

#include "pack/environment_guide.h"
#include "pack/guide_map.h"
#include "pack/guide_openings.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace eikonal {
namespace {

constexpr size_t manyRays = 1 << 20;

/// The probability of an opening in a map.
double pmfOf(const SceneTables& tables, uint map, size_t opening) {
    return openingProbability(std::span(tables.guide_sums).subspan(size_t{map} * GUIDE_MAP_WORDS, GUIDE_MAP_WORDS), opening);
}
double totalOf(const SceneTables& tables, uint map) {
    double total = 0;
    for (size_t i = 0; i < GUIDE_OPENINGS; ++i) total += pmfOf(tables, map, i);
    return total;
}
uint mapsOf(const SceneTables& tables) { return static_cast<uint>(tables.guide_sums.size() / GUIDE_MAP_WORDS); }

glm::dvec3 vectorOf(const vec3& v) { return {v.x, v.y, v.z}; }

/// Where a ray from inside of the guide's box leaves it through the top, side 5; others leave it as well, at a texel of side 0.
struct Exit { glm::dvec3 point; uint texel; };
Exit exitOf(const LightTables& tables, glm::dvec3 p, glm::dvec3 d) {
    const glm::dvec3 low = vectorOf(tables.guide_box[0]), size = vectorOf(tables.guide_box[1]);
    if (d.z <= 0) return {p, 0};
    const glm::dvec3 q = p + d * ((low.z + size.z - p.z) / d.z), at = (q - low) / size;
    if (at.x < 0 || at.x >= 1 || at.y < 0 || at.y >= 1) return {q, 0};
    return {q, (5 * GUIDE_TEXELS + static_cast<uint>(at.y * GUIDE_TEXELS)) * GUIDE_TEXELS + static_cast<uint>(at.x * GUIDE_TEXELS)};
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

    /// Sees the sky where `isOpen(from, where)` says so of a point and of where the ray leaves the box.
    SurveyRays rays(const std::function<bool(glm::dvec3, glm::dvec3)>& isOpen) const {
        const auto exits = [this, isOpen](const LightTables& tables, size_t count) {
            std::mt19937 random(11);
            std::uniform_real_distribution<double> unit(0, 1);
            std::vector<uint> texels;
            for (size_t i = 0; i < count; ++i) {
                const double z = std::sqrt(unit(random)), phi = 2 * M_PI * unit(random), r = std::sqrt(1 - z * z);
                const glm::dvec3 p = vectorOf(points[i * points.size() / count]);
                const Exit exit = exitOf(tables, p, {r * std::cos(phi), r * std::sin(phi), z});
                texels.push_back(isOpen(p, exit.point) ? exit.texel : NONE);
            }
            return texels;
        };
        const auto weigh = [isOpen](const LightTables& tables, const GuideRepresentatives& from) {
            std::vector<float> pairs;
            for (size_t map = 0; map < from.maps; ++map)
                for (const guide_opening& o : tables.guide_openings) {
                    double seen = 0, possible = 0;
                    for (size_t k = map * from.perMap; k < (map + 1) * from.perMap && o.inverse_area > 0; ++k) {
                        const glm::dvec3 p = vectorOf(from.points[k]), q = vectorOf(o.corner) + 0.5 * (vectorOf(o.a) + vectorOf(o.b));
                        possible += 1;
                        seen += isOpen(p, q);
                    }
                    pairs.push_back(static_cast<float>(seen));
                    pairs.push_back(static_cast<float>(possible));
                }
            return pairs;
        };
        return {exits, weigh};
    }
};

/// A window in the ceiling.
bool isWindow(glm::dvec3 q) { return q.z > 0.99 && q.x > 0.25 && q.x < 0.5 && q.y > 0.5 && q.y < 0.75; }
bool throughWindow(glm::dvec3, glm::dvec3 q) { return isWindow(q); }

// A map has the probabilities of its weights to a unit, but for the largest, which takes what rounding leaves; what weighs little has a
// unit, and what weighs nothing has none, wherever it is. A dark map has no probability at all.
TEST(EnvironmentGuide, MapsHoldTheirWeights) {
    std::vector<double> weights(GUIDE_OPENINGS);
    for (size_t i = 0; i < weights.size(); ++i) weights[i] = i % 3 == 0 ? 0 : i % 7 == 1 ? 1e-9 : 0.5 + static_cast<double>(i);
    weights[GUIDE_OPENINGS - 2] = weights[GUIDE_OPENINGS - 1] = 0;
    double total = 0;
    for (const double w : weights) total += w;
    std::vector<uint> map(GUIDE_MAP_WORDS, 12345u);
    writeGuideMap(map, weights);
    double sum = 0;
    constexpr double unit = 1.0 / GUIDE_UNITS;
    const auto largest = static_cast<size_t>(std::ranges::max_element(weights) - weights.begin());
    for (size_t i = 0; i < weights.size(); ++i) {
        const double p = openingProbability(map, i);
        sum += p;
        if (weights[i] == 0) EXPECT_EQ(p, 0) << i;
        else EXPECT_GE(p, 0.999 * unit) << i;
        EXPECT_NEAR(p, weights[i] / total, (i == largest ? GUIDE_OPENINGS : 1) * unit) << i;
    }
    EXPECT_NEAR(sum, 1, 1e-12);

    writeDarkGuideMap(map);
    for (size_t i = 0; i < weights.size(); ++i) EXPECT_EQ(openingProbability(map, i), 0);
}

TEST(EnvironmentGuide, HasNoDensityBeforeItLearns) {
    SceneTables tables;
    packUnlearnedGuide(tables);
    ASSERT_EQ(mapsOf(tables), 1u);
    EXPECT_EQ(totalOf(tables, 0), 0);
    ASSERT_EQ(tables.guide_texels.size(), size_t{GUIDE_BOX_TEXELS});
    EXPECT_EQ(std::ranges::count(tables.guide_texels, NONE), GUIDE_BOX_TEXELS);
    for (const guide_opening& o : tables.guide_openings) EXPECT_EQ(o.inverse_area, 0);
}

// The openings cover the window and a texel around it, without overlap, and each texel names the opening that it lies in.
TEST(EnvironmentGuide, FindsTheWindow) {
    const Floor floor(20000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays}, floor.rays(throughWindow));
    double area = 0;
    for (const guide_opening& o : tables.guide_openings) {
        ASSERT_GT(o.inverse_area, 0);
        area += 1.0 / double{o.inverse_area};
        EXPECT_EQ(o.n.z, 1);
        const glm::dvec3 middle = vectorOf(o.corner) + 0.5 * (vectorOf(o.a) + vectorOf(o.b)), low = vectorOf(tables.guide_box[0]);
        const glm::dvec3 at = (middle - low) / vectorOf(tables.guide_box[1]) * double{GUIDE_TEXELS} - 0.01;
        const uint texel = (5 * GUIDE_TEXELS + static_cast<uint>(at.y)) * GUIDE_TEXELS + static_cast<uint>(at.x);
        EXPECT_EQ(tables.guide_texels[texel], static_cast<uint>(&o - tables.guide_openings.data()));
    }
    const double texels = GUIDE_BOX_TEXELS - static_cast<double>(std::ranges::count(tables.guide_texels, NONE));
    const double side = double{tables.guide_box[1].x} * tables.guide_box[1].y;
    EXPECT_NEAR(area, texels * side / (double{GUIDE_TEXELS} * GUIDE_TEXELS), 1e-3 * area);
    EXPECT_GT(area, 0.0625);
    const double texel = std::sqrt(side) / GUIDE_TEXELS;
    EXPECT_LT(area, std::pow(0.25 + 4 * texel, 2));   // cut texels on both ends, and one more
    for (uint map = 0; map < mapsOf(tables); ++map) EXPECT_NEAR(totalOf(tables, map), 1, 1e-5);
}

// A map uses the openings that its place sees, here half of the ceiling. The others are chosen sqrt(0.002) as often, since none of the few
// rays got through; a few lie across the border.
TEST(EnvironmentGuide, EachPlaceUsesTheOpeningsThatItSees) {
    const Floor floor(40000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays},
               floor.rays([](glm::dvec3 p, glm::dvec3 q) { return q.z > 0.99 && (p.x < 0.5) == (q.x < 0.5); }));
    constexpr size_t n = GUIDE_INTERVALS;
    for (size_t cell = 0; cell < n * n * n; ++cell) {
        const uint map = tables.guide_maps[4 * n * n * n + cell];
        if (map == 0 || cell % n == 7 || cell % n == 8) continue;
        const bool isLow = cell % n < 8;
        double own = 0;
        for (size_t i = 0; i < GUIDE_OPENINGS; ++i) {
            const guide_opening& o = tables.guide_openings[i];
            own += (o.corner.x + 0.5f * o.a.x < 0.5f) == isLow ? pmfOf(tables, map, i) : 0;
        }
        EXPECT_GT(own, 0.8) << cell;
    }
}

// Points outside of a room, as its windows show them, do not enlarge the box.
TEST(EnvironmentGuide, BoxIsThatOfTheRoom) {
    Floor floor(20000);
    for (size_t i = 0; i < 100; ++i) floor.points[i] = {100, -50, 20};
    SceneTables tables;
    packGuideBox(tables, floor.points);
    const vec3 low = tables.guide_box[0], size = tables.guide_box[1];
    for (const float x : {low.x, low.y, low.z}) EXPECT_NEAR(x, 0, 0.03);
    for (const float x : {size.x, size.y, size.z}) EXPECT_NEAR(x, 1, 0.05);
}

TEST(EnvironmentGuide, CutsEachAxisIntoIntervalsWithAsManyPoints) {
    const Floor floor(16000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays}, floor.rays(throughWindow));
    ASSERT_EQ(tables.guide_edges.size(), size_t{3 * GUIDE_INTERVALS});
    for (size_t axis = 0; axis < 3; ++axis) {
        const float* edges = tables.guide_edges.data() + axis * GUIDE_INTERVALS;
        for (size_t e = 0; e + 1 < GUIDE_INTERVALS; ++e) EXPECT_NEAR(edges[e], (static_cast<double>(e) + 1) / GUIDE_INTERVALS, 0.02);
        EXPECT_EQ(edges[GUIDE_INTERVALS - 1], FAR_AWAY);
    }
}

TEST(EnvironmentGuide, IsTheSameForTheSamePoints) {
    const Floor floor(5000);
    SceneTables a, b;
    EXPECT_EQ(learnGuide(a, floor.points, floor.normals, {manyRays, true}, floor.rays(throughWindow)),
              learnGuide(b, floor.points, floor.normals, {manyRays, true}, floor.rays(throughWindow)));
    EXPECT_EQ(a.guide_maps, b.guide_maps);
    EXPECT_EQ(a.guide_edges, b.guide_edges);
    EXPECT_EQ(a.guide_texels, b.guide_texels);
    EXPECT_EQ(a.guide_sums, b.guide_sums);
}

// Without points the guide is as it was, and so it is in a room that no light comes into.
TEST(EnvironmentGuide, LearnsNothingWhereThereIsNothing) {
    SceneTables tables;
    const Floor floor(1000);
    EXPECT_EQ(learnGuide(tables, {}, {}, {manyRays}, floor.rays(throughWindow)), 1);
    EXPECT_EQ(totalOf(tables, 0), 0);
    EXPECT_EQ(learnGuide(tables, floor.points, floor.normals, {manyRays}, floor.rays([](auto, auto) { return false; })), 0);
    EXPECT_EQ(mapsOf(tables), 1u);
    EXPECT_EQ(totalOf(tables, 0), 0);
}

// A wall across a floor: the cells behind it see nothing, but those that border on cells that do may.
TEST(EnvironmentGuide, LeavesDarkPlacesToThePaths) {
    const Floor floor(40000);
    SceneTables tables;
    learnGuide(tables, floor.points, floor.normals, {manyRays}, floor.rays([](glm::dvec3 p, glm::dvec3) { return p.x < 0.5; }));
    /* Of the 16 cells along x, those from the ninth on are behind the wall, and the ninth borders on one that is not; face 4 looks up */
    size_t dark = 0, lit = 0;
    for (size_t cell = 0; cell < size_t{GUIDE_INTERVALS} * GUIDE_INTERVALS * GUIDE_INTERVALS; ++cell) {
        const uint map = tables.guide_maps[4 * size_t{GUIDE_INTERVALS} * GUIDE_INTERVALS * GUIDE_INTERVALS + cell];
        if (map == 0) continue;
        const size_t x = cell % GUIDE_INTERVALS;
        if (x < 7) { ++lit; EXPECT_NEAR(totalOf(tables, map), 1, 1e-5) << x; }
        if (x > 9) { ++dark; EXPECT_EQ(totalOf(tables, map), 0) << x; }
    }
    EXPECT_GT(dark, 100u);
    EXPECT_GT(lit, 100u);
}

// A few rays say that a scene is open; then no more are cast, and the guide has no openings.
TEST(EnvironmentGuide, GivesUpInTheOpen) {
    const Floor floor(40000);
    SceneTables tables;
    size_t cast = 0;
    SurveyRays open = floor.rays([](auto, auto) { return true; });
    const double share = learnGuide(tables, floor.points, floor.normals, {.rays = manyRays, .openShare = 0.1},
                                    {[&](const LightTables& t, size_t count) { cast += count; return open.exits(t, count); }, open.weigh});
    EXPECT_EQ(share, 1);
    EXPECT_LT(cast, manyRays / 64);
    EXPECT_EQ(mapsOf(tables), 1u);
    EXPECT_EQ(tables.guide_edges[0], FAR_AWAY);
    /* A closed one is learnt as without that look. Its share of light: how many rays go through the window */
    const double closed = learnGuide(tables, floor.points, floor.normals, {.rays = manyRays, .openShare = 0.2}, floor.rays(throughWindow));
    EXPECT_GT(closed, 0.01);
    EXPECT_LT(closed, 0.15);
    EXPECT_GT(mapsOf(tables), 1u);
}

TEST(EnvironmentGuide, IsNotForFewSamples) {
    EXPECT_FALSE(GuideBudget::of(512, 512, 1).isEnough());
    EXPECT_FALSE(GuideBudget::of(16, 16, 256).isEnough());
    EXPECT_TRUE(GuideBudget::of(512, 512, 16).isEnough());
    EXPECT_LE(GuideBudget::of(20000, 20000, 4096).rays, size_t{1} << 23);
}

}  // namespace
}  // namespace eikonal
