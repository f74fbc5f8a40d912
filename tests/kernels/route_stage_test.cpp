// The stages that say what comes next and deliver it, alone: queue in, queue out. Empty, with one item, and full;
// no word of an item that is alive may be the poison of a forgotten field.

#include "stage_fixture.h"

#include <set>

namespace eikonal {
namespace {

/// The counts are those of the hops that the flights were given; nothing is counted twice, and dead flights not at all.
TEST_F(StageTest, ClassifyFlightsCountsItsHops) {
    intersect();
    bench.resetCounters();
    bench.run("classify_flights", 0);
    for (uint n : bench.counts()) EXPECT_EQ(n, 0u);
    bench.run("classify_flights", 1);
    EXPECT_EQ(bench.rays(), 1u);

    bench.resetCounters();
    bench.run("classify_flights", paths);
    const QueueWords flights = bench.read("flight");
    std::vector<uint> found(hops);
    for (size_t i = 0; i < paths; ++i) {
        expectClean(flights, i);
        const uint hop = flights.get<uint>("hop", i), element = flights.get<uint>("element", i);
        if (hop < hops) ++found[hop];
        ASSERT_EQ(hop == hop_miss, element == NONE);
        if (element != NONE) {
            const shape& s = sceneOfEverything().tables.shapes[sceneOfEverything().tables.element_shapes[element]];
            found[hop_emission] += s.first_light != NONE;
            ASSERT_LT(hop, static_cast<uint>(hop_miss)) << "a surface scatters";
            ASSERT_EQ(sceneOfEverything().tables.materials[flights.get<uint>("material", i)].hop, hop) << "mixes are resolved";
        }
    }
    EXPECT_EQ(bench.counts(), found);
    EXPECT_EQ(bench.rays(), paths);
    EXPECT_GT(found[hop_emission], 0u);
    EXPECT_GT(found[hop_diffuse], 0u);
}

/// Every flight arrives once, in the queue of its hop, in a segment of its own; nothing else is written.
TEST_F(StageTest, RouteFlightsDeliversEveryFlightOnce) {
    classify();
    const auto counts = bench.counts();
    bench.run("route_flights", paths);
    const QueueWords flights = bench.read("flight"), hits = bench.read("hit"), misses = bench.read("miss"), emissions = bench.read("emission");

    std::vector<std::set<uint>> wanted(hops), found(hops);
    for (size_t i = 0; i < paths; ++i) {
        const uint hop = flights.get<uint>("hop", i);
        if (hop < hops) wanted[hop].insert(static_cast<uint>(i));
        const uint element = flights.get<uint>("element", i);
        if (element != NONE && sceneOfEverything().tables.shapes[sceneOfEverything().tables.element_shapes[element]].first_light != NONE) wanted[hop_emission].insert(static_cast<uint>(i));
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
    for (uint hop = 0; hop < hops; ++hop) {
        const QueueWords& queue = hop == hop_miss ? misses : hop == hop_emission ? emissions : hits;
        const unsigned start = hop < hop_miss ? segmentStart(hop) : 0;
        for (unsigned i = start; i < start + counts[hop]; ++i) {
            const int words = hop < hop_miss && hop >= hop_diffuse ? common + parameterWords[hop - hop_diffuse] : -1;
            expectClean(queue, i, words);
            found[hop].insert(queue.get<uint>("path", i));
        }
        EXPECT_EQ(found[hop], wanted[hop]) << "hop " << hop;
        EXPECT_EQ(found[hop].size(), counts[hop]) << "hop " << hop << ": some path is there twice";
        if (hop < hop_miss) covered += counts[hop];
    }
    size_t written = 0;
    for (size_t i = 0; i < hits.capacity(); ++i) written += hits.get<uint>("path", i) != poison;
    EXPECT_EQ(written, covered) << "hits outside of all segments";
    EXPECT_GT(covered, paths / 4);

    /* Frames are made of unit vectors, on the side that the path came from or the other, but perpendicular where they must be */
    for (size_t i = 0; i < hits.capacity(); ++i) {
        if (hits.get<uint>("path", i) == poison) continue;
        const vec3 ng = hits.get<vec3>("ng", i), ns = hits.get<vec3>("ns", i), wo = hits.get<vec3>("wo", i), tangent = hits.get<vec3>("tangent", i);
        ASSERT_NEAR(lengthOf(ng), 1, 1e-5);
        ASSERT_NEAR(lengthOf(ns), 1, 1e-5);
        ASSERT_NEAR(lengthOf(wo), 1, 1e-5);
        ASSERT_NEAR(lengthOf(tangent), 1, 1e-5);
        ASSERT_NEAR(ns.x * tangent.x + ns.y * tangent.y + ns.z * tangent.z, 0, 1e-5);
        ASSERT_GE(ng.x * ns.x + ng.y * ns.y + ng.z * ns.z, 0);
        ASSERT_GT(hits.get<float>("offset", i), 0);
    }
}

TEST_F(StageTest, RouteFlightsOfNothingWritesNothing) {
    intersect();
    bench.resetCounters();
    bench.run("classify_flights", 0);
    bench.run("route_flights", 0);
    for (const char* queue : {"hit", "miss", "emission", "next_ray"}) EXPECT_EQ(bench.read(queue).words(), bench.empty(queue).words()) << queue;
}

}  // namespace
}  // namespace eikonal
