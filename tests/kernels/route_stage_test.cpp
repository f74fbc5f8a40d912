// The stages that say what comes next and deliver it, alone: queue in, queue out. Empty, with one item, and full;
// no word of an item that is alive may be the poison of a forgotten field.

#include "stage_fixture.h"

#include <set>

namespace eikonal {
namespace {

/// The counts are those of the queues that the intersections were given; nothing is counted twice, and dead intersections not at all.
TEST_F(StageTest, ClassifyIntersectionsCountsByQueue) {
    intersect();
    bench.resetCounters();
    bench.run("classify_intersections", 0);
    for (uint n : bench.counts()) EXPECT_EQ(n, 0u);
    bench.run("classify_intersections", 1);
    EXPECT_EQ(bench.rays(), 1u);

    bench.resetCounters();
    bench.run("classify_intersections", paths);
    const QueueWords intersections = bench.read("intersection");
    std::vector<uint> found(next_queues);
    for (size_t i = 0; i < paths; ++i) {
        expectClean(intersections, i);
        const uint next_queue = intersections.get<uint>("next_queue", i), element = intersections.get<uint>("element", i);
        if (next_queue < next_queues) ++found[next_queue];
        ASSERT_EQ(next_queue == next_miss, element == NONE);
        if (element != NONE) {
            const shape& s = sceneOfEverything().tables.shapes[sceneOfEverything().tables.element_shapes[element]];
            found[next_emission] += s.first_light != NONE;
            ASSERT_LT(next_queue, static_cast<uint>(next_miss)) << "a surface scatters";
            ASSERT_EQ(sceneOfEverything().tables.materials[intersections.get<uint>("material", i)].next_queue, next_queue)
                << "mixes are resolved";
        }
    }
    EXPECT_EQ(bench.counts(), found);
    EXPECT_EQ(bench.rays(), paths);
    EXPECT_GT(found[next_emission], 0u);
    EXPECT_GT(found[next_diffuse], 0u);
}

/// Every intersection arrives once, in the queue of its next_queue, in a segment of its own; nothing else is written.
TEST_F(StageTest, RouteIntersectionsDeliversEveryIntersectionOnce) {
    classify();
    const auto counts = bench.counts();
    bench.run("route_intersections", paths);
    const QueueWords intersections = bench.read("intersection"), hits = bench.read("hit"), misses = bench.read("miss"),
                     emissions = bench.read("emission");

    std::vector<std::set<uint>> wanted(next_queues), found(next_queues);
    for (size_t i = 0; i < paths; ++i) {
        const uint next_queue = intersections.get<uint>("next_queue", i);
        if (next_queue < next_queues) wanted[next_queue].insert(static_cast<uint>(i));
        const uint element = intersections.get<uint>("element", i);
        if (element != NONE && sceneOfEverything().tables.shapes[sceneOfEverything().tables.element_shapes[element]].first_light != NONE)
            wanted[next_emission].insert(static_cast<uint>(i));
    }
    const std::vector<int> parameterWords{
#define WORDS_OF(q, type, name, FEATURE) +WORDS_##type
#define PARAMETER_WORDS(name, FEATURE, PARAMETERS) 0 PARAMETERS(WORDS_OF, name),
        BSDFS(PARAMETER_WORDS)
#undef PARAMETER_WORDS
#undef WORDS_OF
    };
    const int common = queueLayout("hit", sceneOfEverything().features).words;
    size_t covered = 0;
    for (uint next_queue = 0; next_queue < next_queues; ++next_queue) {
        const QueueWords& queue = next_queue == next_miss ? misses : next_queue == next_emission ? emissions : hits;
        const unsigned start = next_queue < next_miss ? segmentStart(next_queue) : 0;
        for (unsigned i = start; i < start + counts[next_queue]; ++i) {
            const int words =
                next_queue < next_miss && next_queue >= next_diffuse ? common + parameterWords[next_queue - next_diffuse] : -1;
            expectClean(queue, i, words);
            found[next_queue].insert(queue.get<uint>("path", i));
        }
        EXPECT_EQ(found[next_queue], wanted[next_queue]) << "queue " << next_queue;
        EXPECT_EQ(found[next_queue].size(), counts[next_queue]) << "queue " << next_queue << ": some path is there twice";
        if (next_queue < next_miss) covered += counts[next_queue];
    }
    size_t written = 0;
    for (size_t i = 0; i < hits.capacity(); ++i) written += hits.get<uint>("path", i) != poison;
    EXPECT_EQ(written, covered) << "hits outside of all segments";
    EXPECT_GT(covered, paths / 4);

    /* Frames are made of unit vectors, on the side that the path came from or the other, but perpendicular where they must be */
    for (size_t i = 0; i < hits.capacity(); ++i) {
        if (hits.get<uint>("path", i) == poison) continue;
        const vec3 ng = hits.get<vec3>("ng", i), ns = hits.get<vec3>("ns", i), wo = hits.get<vec3>("wo", i),
                   tangent = hits.get<vec3>("tangent", i);
        ASSERT_NEAR(lengthOf(ng), 1, 1e-5);
        ASSERT_NEAR(lengthOf(ns), 1, 1e-5);
        ASSERT_NEAR(lengthOf(wo), 1, 1e-5);
        ASSERT_NEAR(lengthOf(tangent), 1, 1e-5);
        ASSERT_NEAR(ns.x * tangent.x + ns.y * tangent.y + ns.z * tangent.z, 0, 1e-5);
        ASSERT_GE(ng.x * ns.x + ng.y * ns.y + ng.z * ns.z, 0);
        ASSERT_GT(hits.get<float>("offset", i), 0);
    }
}

TEST_F(StageTest, RouteIntersectionsOfNothingWritesNothing) {
    intersect();
    bench.resetCounters();
    bench.run("classify_intersections", 0);
    bench.run("route_intersections", 0);
    for (const char* queue : {"hit", "miss", "emission", "next_ray"})
        EXPECT_EQ(bench.read(queue).words(), bench.empty(queue).words()) << queue;
}

}  // namespace
}  // namespace eikonal
