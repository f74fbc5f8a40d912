// The acceleration structure as the host builds it: what must hold for any input.

#include "bvh/build.h"
#include "bvh/child_order.h"
#include "bvh/padding.h"
#include "leaf_triangles.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace eikonal {
namespace {

/// Triangles and boxes for one hierarchy, owned.
struct Soup {
    std::vector<vec3> positions;
    std::vector<uint> indices;
    std::vector<BoxedElement> others;

    size_t triangles() const { return indices.size() / 3; }
    void add(vec3 a, vec3 b, vec3 c) {
        for (const vec3& p : {a, b, c}) {
            indices.push_back(static_cast<uint>(positions.size()));
            positions.push_back(p);
        }
    }
    TriangleRange range(uint firstElement = 0) const { return {positions.data(), indices.data(), triangles(), firstElement}; }
    BvhRoot build(BvhTables& tables, const BvhOptions& options = {.world = true}) const {
        const TriangleRange all = range();
        return buildBvh(tables, {&all, 1}, others, options);
    }
};

float uniform(std::mt19937& rng, float low, float high) { return std::uniform_real_distribution<float>(low, high)(rng); }
vec3 randomPoint(std::mt19937& rng, float size) {
    return {uniform(rng, -size, size), uniform(rng, -size, size), uniform(rng, -size, size)};
}
vec3 near(std::mt19937& rng, vec3 p, float size) {
    const vec3 d = randomPoint(rng, size);
    return {p.x + d.x, p.y + d.y, p.z + d.z};
}

Soup randomSoup(size_t count, float size, unsigned seed = 1) {
    std::mt19937 rng(seed);
    Soup soup;
    for (size_t i = 0; i < count; ++i) {
        const vec3 p = randomPoint(rng, 1);
        soup.add(p, near(rng, p, size), near(rng, p, size));
    }
    return soup;
}

/// What a walk over all nodes sees.
struct Census {
    std::vector<int> triangleVisits, otherVisits, instanceVisits;
    size_t nodes = 0, leaves = 0, lines = 0;
    int depth = 0;
};

struct Bounds { vec3 low, high; };

bool contains(const bvh_node& node, int lane, vec3 p, float pad) {
    const float (&b)[6][BVH_WIDTH] = node.bounds;
    return p.x - pad >= b[0][lane] && p.x + pad <= b[1][lane] && p.y - pad >= b[2][lane] && p.y + pad <= b[3][lane] &&
           p.z - pad >= b[4][lane] && p.z + pad <= b[5][lane];
}

/// Half of what the box must be padded by, for the largest coordinate of what it holds.
float halfPad(std::initializer_list<vec3> points) {
    float largest = 0;
    for (const vec3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return 0.5f * BOX_PADDING * largest;
}

/// Walks a hierarchy and checks that children lie in their boxes. Every line and element of the soup is counted.
Census inspect(const BvhTables& tables, const BvhRoot& root, const Soup& soup) {
    Census seen;
    seen.triangleVisits.resize(soup.triangles());
    seen.otherVisits.resize(soup.others.size());
    const std::function<void(uint, int)> visit = [&](uint index, int depth) {
        ASSERT_LT(index, tables.nodes.size());
        const bvh_node& node = tables.nodes[index];
        ++seen.nodes;
        seen.depth = std::max(seen.depth, depth);
        for (const uint order : node.order) {
            uint listed = 0;
            for (int i = 0; i < BVH_WIDTH; ++i) listed |= 1u << (order >> 4 * i & 15);
            EXPECT_EQ(listed, 0xffu);
        }
        bvh_node ordered = node;
        orderChildren(ordered);
        EXPECT_TRUE(std::ranges::equal(ordered.order, node.order));
        for (int lane = 0; lane < BVH_WIDTH; ++lane) {
            const uint child = node.child[lane];
            if (child == NONE) {
                EXPECT_GT(node.bounds[0][lane], node.bounds[1][lane]);
                continue;
            }
            if (!(child & LEAF_BIT)) {
                const bvh_node& below = tables.nodes[child];
                for (int i = 0; i < BVH_WIDTH; ++i) {
                    if (below.child[i] == NONE) continue;
                    EXPECT_TRUE(contains(node, lane, {below.bounds[0][i], below.bounds[2][i], below.bounds[4][i]}, 0));
                    EXPECT_TRUE(contains(node, lane, {below.bounds[1][i], below.bounds[3][i], below.bounds[5][i]}, 0));
                }
                visit(child, depth + 1);
                continue;
            }
            ++seen.leaves;
            const uint kind = (child >> LEAF_KIND_SHIFT) & LEAF_KIND_MASK, count = ((child >> LEAF_COUNT_SHIFT) & LEAF_COUNT_MASK) + 1u,
                       first = child & LEAF_FIRST_MASK;
            if (kind == leaf_triangles) {
                seen.lines += (TRIANGLE_WORDS * count + 15) / 16;
                for (const LeafTriangle& triangle : leafTriangles(tables.triangleLines, child)) {
                    ASSERT_LT(triangle.element, seen.triangleVisits.size());
                    ++seen.triangleVisits[triangle.element];
                    const vec3 (&v)[3] = triangle.corner;
                    for (uint k = 0; k < 3; ++k) {
                        const vec3 expected = soup.positions[soup.indices[3 * triangle.element + k]];
                        EXPECT_EQ(std::memcmp(&v[k], &expected, sizeof expected), 0);
                        EXPECT_TRUE(contains(node, lane, v[k], halfPad({v[0], v[1], v[2]})));
                    }
                }
                continue;
            }
            for (uint i = first; i < first + count; ++i) {
                const uint reference = kind == leaf_instances ? i : tables.leafElements[i];
                for (size_t e = 0; e < soup.others.size(); ++e) {
                    const BoxedElement& other = soup.others[e];
                    if (other.reference != reference || other.kind != kind) continue;
                    ++seen.otherVisits[e];
                    EXPECT_TRUE(contains(node, lane, other.low, halfPad({other.low, other.high})));
                    EXPECT_TRUE(contains(node, lane, other.high, halfPad({other.low, other.high})));
                }
            }
            EXPECT_TRUE(kind != leaf_instances || count == 1);
        }
    };
    visit(root.root, 1);
    EXPECT_EQ(seen.nodes, root.nodes);
    EXPECT_EQ(seen.leaves, root.leaves);
    EXPECT_EQ(seen.lines, root.lines);
    EXPECT_EQ(seen.depth, root.depth);
    EXPECT_LE(seen.depth, BVH_MAX_DEPTH);
    return seen;
}

void expectEachOnce(const Soup& soup, const char* what) {
    SCOPED_TRACE(what);
    BvhTables tables;
    const BvhRoot root = soup.build(tables);
    EXPECT_EQ(root.root, 0u);
    EXPECT_EQ(root.elements + root.dropped, soup.triangles() + soup.others.size());
    EXPECT_EQ(root.dropped, 0u);
    const Census seen = inspect(tables, root, soup);
    for (const int visits : seen.triangleVisits) ASSERT_EQ(visits, 1);
    for (const int visits : seen.otherVisits) ASSERT_EQ(visits, 1);
}

TEST(Bvh, HoldsEachElementOnceInsideItsBoxes) {
    for (const size_t count : {1, 2, 3, 7, 8, 9, 17, 100, 1000, 5000, 40000})
        for (const float size : {0.01f, 1.f}) expectEachOnce(randomSoup(count, size), "random soup");
}

TEST(Bvh, SurvivesHardInput) {
    std::mt19937 rng(3);
    Soup same, stack, needles, chain, scales, flat;
    for (int i = 0; i < 20000; ++i) same.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (int i = 0; i < 10000; ++i) {
        const float r = 1 + static_cast<float>(i);
        stack.add({-r, -r, 0}, {r, -r, 0}, {0, r, 0});  // concentric, all overlapping
        const vec3 p = randomPoint(rng, 1);
        needles.add(p, {p.x + 1, p.y + 1, p.z + 1}, {p.x + 1, p.y + 1, p.z + 1.0001f});
        flat.add({p.x, 0, p.z}, {p.x + .01f, 0, p.z}, {p.x, 0, p.z + .01f});
    }
    for (int i = 0; i < 9000; ++i) {
        // Sizes that fall geometrically: a chain of one against the rest
        const float r = std::ldexp(1.f, -(i % 100));
        chain.add({r, 0, 0}, {r, r, 0}, {r, 0, r});
        const float s = std::ldexp(1.f, static_cast<int>(rng() % 60) - 30);
        const vec3 p = randomPoint(rng, s);
        scales.add(p, near(rng, p, s), near(rng, p, s));
    }
    expectEachOnce(same, "all the same");
    expectEachOnce(stack, "concentric");
    expectEachOnce(needles, "diagonal needles");
    expectEachOnce(chain, "geometric sizes");
    expectEachOnce(scales, "all scales");
    expectEachOnce(flat, "in a plane");
}

TEST(Bvh, HugeCoordinatesDoNotOverflow) {
    std::mt19937 rng(4);
    Soup soup;
    for (int i = 0; i < 6000; ++i) {
        const vec3 p = randomPoint(rng, 1e16f);
        soup.add(p, near(rng, p, 1e16f), near(rng, p, 1e16f));
    }
    expectEachOnce(soup, "huge");
}

TEST(Bvh, LeavesHoldOneKind) {
    std::mt19937 rng(5);
    Soup soup = randomSoup(500, 0.1f);
    for (uint i = 0; i < 700; ++i) {
        const vec3 p = randomPoint(rng, 1);
        soup.others.push_back({p, {p.x + .1f, p.y + .1f, p.z + .1f}, i, i % 3 ? leaf_elements : leaf_instances});
    }
    // And a pile of everything in one place, which no plane can cut apart
    for (uint i = 700; i < 760; ++i) {
        soup.others.push_back({{0, 0, 0}, {1, 1, 1}, i, i % 2 ? leaf_elements : leaf_instances});
        soup.add({0, 0, 0}, {1, 1, 0}, {0, 1, 1});
    }
    expectEachOnce(soup, "mixed");
}

TEST(Bvh, DropsWhatCanNeverBeHit) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Soup soup = randomSoup(10, 0.1f);
    soup.add({nan, 0, 0}, {1, 0, 0}, {0, 1, 0});
    soup.add({0, 0, 0}, {1, inf, 0}, {0, 1, 0});
    soup.add({0, 0, 0}, {1, 0, 0}, {0, 0, 0});
    soup.add({0, 0, 0}, {1, 0, 0}, {2, 0, 0});  // without area, but it may close a gap between its neighbours
    soup.others.push_back({{nan, 0, 0}, {1, 1, 1}, 0, leaf_elements});
    BvhTables tables;
    const BvhRoot root = soup.build(tables);
    EXPECT_EQ(root.dropped, 4u);
    EXPECT_EQ(root.elements, 11u);
    const Census seen = inspect(tables, root, soup);
    for (size_t i = 0; i < soup.triangles(); ++i) EXPECT_EQ(seen.triangleVisits[i], i < 10 || i == 13 ? 1 : 0) << i;
}

TEST(Bvh, AnEmptySceneHasARootThatNothingHits) {
    for (const bool world : {true, false}) {
        BvhTables tables;
        const BvhRoot root = buildBvh(tables, {}, {}, {.world = world});
        EXPECT_EQ(root.root, world ? 0u : 1u);
        ASSERT_LT(root.root, tables.nodes.size());
        for (int lane = 0; lane < BVH_WIDTH; ++lane) {
            EXPECT_EQ(tables.nodes[root.root].child[lane], NONE);
            EXPECT_GT(tables.nodes[root.root].bounds[0][lane], tables.nodes[root.root].bounds[1][lane]);
        }
    }
}

TEST(Bvh, ObjectsAndTheWorldShareTables) {
    const Soup first = randomSoup(6000, 0.02f, 1), second = randomSoup(50, 0.1f, 2);
    Soup world = randomSoup(9000, 0.02f, 3);
    world.others.push_back({{-1, -1, -1}, {1, 1, 1}, 0, leaf_instances});
    BvhTables tables;
    const BvhRoot a = first.build(tables, {}), b = second.build(tables, {}), w = world.build(tables);
    EXPECT_EQ(w.root, 0u);
    EXPECT_NE(a.root, b.root);
    EXPECT_EQ(tables.nodes.size(), a.nodes + b.nodes + w.nodes);
    inspect(tables, a, first);
    inspect(tables, b, second);
    inspect(tables, w, world);
}

TEST(Bvh, SeveralRangesKeepTheirNumbers) {
    const Soup one = randomSoup(100, 0.1f, 1), two = randomSoup(200, 0.1f, 2);
    const TriangleRange ranges[] = {one.range(1000), two.range(5000)};
    BvhTables tables;
    buildBvh(tables, ranges, {}, {.world = true});
    std::vector<uint> found;
    for (const bvh_node& node : tables.nodes)
        for (const uint child : node.child)
            if (child != NONE && child & LEAF_BIT)
                for (const LeafTriangle& triangle : leafTriangles(tables.triangleLines, child)) found.push_back(triangle.element);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), 300u);
    for (uint i = 0; i < 300; ++i) EXPECT_EQ(found[i], i < 100 ? 1000 + i : 4900 + i);
}

template <class T> bool sameBytes(const Table<T>& a, const Table<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Bvh, TheTablesDoNotDependOnTheNumberOfThreads) {
    Soup soup = randomSoup(200000, 0.01f);
    soup.add({std::numeric_limits<float>::quiet_NaN(), 0, 0}, {1, 0, 0}, {0, 1, 0});
    BvhTables expected;
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        soup.build(expected);
    }
    for (const size_t threads : {2, 5}) {
        const tbb::global_control some(tbb::global_control::max_allowed_parallelism, threads);
        BvhTables tables;
        soup.build(tables);
        EXPECT_TRUE(sameBytes(tables.nodes, expected.nodes));
        EXPECT_TRUE(sameBytes(tables.triangleLines, expected.triangleLines));
    }
}

TEST(Bvh, LeavesAndNodesOfAMeshAreWellFilled) {
    // A bumpy sheet of 200 x 200 quadrilaterals
    Soup soup;
    const auto point = [](int x, int y) {
        return vec3{.01f * static_cast<float>(x), .01f * static_cast<float>(y), .02f * std::sin(.3f * static_cast<float>(x + 2 * y))};
    };
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            soup.add(point(x, y), point(x + 1, y), point(x, y + 1));
            soup.add(point(x + 1, y), point(x + 1, y + 1), point(x, y + 1));
        }
    BvhTables tables;
    const BvhRoot root = soup.build(tables);
    EXPECT_GT(static_cast<double>(soup.triangles()) / static_cast<double>(root.leaves), 5);
    EXPECT_GT(static_cast<double>(root.leaves + root.nodes - 1) / static_cast<double>(root.nodes), 6.5);
}

}  // namespace
}  // namespace eikonal
