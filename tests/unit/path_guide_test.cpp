// What the path guide learns of recorded paths: from where light comes, and where it comes from elsewhere.

#include "pack/guide_place.h"
#include "pack/path_guide.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eikonal {
namespace {

/// The probability of each texel of a map sums to 1.
double totalOf(const LightTables& tables, uint map) {
    const alias_entry* entries = tables.path_guide_aliases.data() + size_t{map} * PATH_GUIDE_ENTRIES;
    double total = 0;
    for (size_t y = 0; y < PATH_GUIDE_SIDE; ++y)
        for (size_t x = 0; x < PATH_GUIDE_SIDE; ++x)
            total += double{entries[y].pmf} * entries[PATH_GUIDE_SIDE + y * PATH_GUIDE_SIDE + x].pmf;
    return total;
}

/// The map of a point on a floor, as kernels/light/guide_place.clh finds it.
uint mapAt(const LightTables& tables, const vec3& p) {
    path_guide_node node = tables.path_guide_nodes[4];   // the face +z
    while (node.axis != PATH_GUIDE_LEAF)
        node = tables.path_guide_nodes[node.next + (coordinate(p, node.axis) < node.at ? 0 : 1)];
    return node.next;
}

/// The share of a map in the quarter of the square where x and y of the direction are both negative, or both positive.
double shareOf(const LightTables& tables, uint map, bool negative) {
    const alias_entry* entries = tables.path_guide_aliases.data() + size_t{map} * PATH_GUIDE_ENTRIES;
    constexpr size_t half = PATH_GUIDE_SIDE / 2;
    double share = 0;
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x) {
            const size_t i = negative ? x : x + half, j = negative ? y : y + half;
            share += double{entries[j].pmf} * entries[PATH_GUIDE_SIDE + j * PATH_GUIDE_SIDE + i].pmf;
        }
    return share;
}

/// Records of a unit floor, lit by `light(p, d)`, their directions even over the hemisphere.
template <class Light> std::vector<GuideRecord> recordFloor(size_t count, Light&& light) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<GuideRecord> records;
    for (size_t i = 0; i < count; ++i) {
        const float z = unit(random), phi = 6.2831853f * unit(random), r = std::sqrt(1 - z * z);
        const vec3 p{unit(random), unit(random), 0}, d{r * std::cos(phi), r * std::sin(phi), z};
        records.push_back({p, {0, 0, 1}, d, light(p, d), 0.15915494f});
    }
    return records;
}

TEST(PathGuide, GuidesNothingBeforeItLearns) {
    LightTables tables;
    packUnlearnedPathGuide(tables);
    EXPECT_EQ(tables.path_guide_nodes.size(), size_t{GUIDE_FACES});
    EXPECT_EQ(mapAt(tables, {0.5f, 0.5f, 0}), 0u);
    EXPECT_EQ(learnPathGuide(tables, {}, true), 0u);
    EXPECT_EQ(learnPathGuide(tables, recordFloor(10000, [](vec3, vec3) { return 0.0f; }), false), 0u);
    EXPECT_EQ(mapAt(tables, {0.5f, 0.5f, 0}), 0u);
}

// The left half of a floor is lit from one side, the right half from the other.
TEST(PathGuide, EachPlaceLearnsItsOwnLight) {
    const auto records = recordFloor(40000, [](vec3 p, vec3 d) {
        const bool isFromLow = d.x < -0.2f && d.y < -0.2f, isFromHigh = d.x > 0.2f && d.y > 0.2f;
        return (p.x < 0.5f ? isFromLow : isFromHigh) ? 3.0f : 0.0f;
    });
    LightTables tables;
    const size_t maps = learnPathGuide(tables, records, false);
    EXPECT_GT(maps, 8u);
    for (uint map = 1; map <= maps; ++map) EXPECT_NEAR(totalOf(tables, map), 1, 1e-5);
    for (const float y : {0.1f, 0.4f, 0.9f}) {
        EXPECT_GT(shareOf(tables, mapAt(tables, {0.1f, y, 0}), true), 0.8);
        EXPECT_GT(shareOf(tables, mapAt(tables, {0.9f, y, 0}), false), 0.8);
    }
    /* Surfaces that face another way have learned nothing */
    for (const uint face : {0u, 1u, 2u, 3u, 5u, 6u}) EXPECT_EQ(tables.path_guide_nodes[face].next, 0u);
}

TEST(PathGuide, SurfacesLitFromBothSidesLearnFromAll) {
    LightTables tables;
    learnPathGuide(tables, recordFloor(20000, [](vec3, vec3 d) { return d.x > 0 ? 1.0f : 0.0f; }), true);
    EXPECT_NE(tables.path_guide_nodes[GUIDE_ALL_DIRECTIONS].axis, PATH_GUIDE_LEAF);
}

// One path that is brighter than all others together does not take a map.
TEST(PathGuide, OnePathDecidesNothing) {
    auto records = recordFloor(2000, [](vec3, vec3 d) { return d.x < 0 && d.y < 0 ? 1.0f : 0.0f; });
    for (GuideRecord& r : records)
        if (r.d.x > 0.3f && r.d.y > 0.3f) { r.light = 1e6f; break; }
    LightTables tables;
    learnPathGuide(tables, records, false);
    for (const float x : {0.1f, 0.9f}) EXPECT_LE(shareOf(tables, mapAt(tables, {x, 0.5f, 0}), false), 1);
    double even = 0;
    for (const float x : {0.05f, 0.35f, 0.65f, 0.95f}) even += shareOf(tables, mapAt(tables, {x, 0.5f, 0}), true) / 4;
    EXPECT_GT(even, 0.5);
}

}  // namespace
}  // namespace eikonal
