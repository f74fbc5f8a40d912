// The stages that shade and the one that tests shadows, alone: queue in, queue out. Empty, with one item, and full;
// no word of an item that is alive may be the poison of a forgotten field.

#include "brute_force.h"
#include "kind_features.h"
#include "stage_fixture.h"

#include <cmath>
#include <set>

namespace eikonal {
namespace {

/// A camera ray (pdf 0: no light could have sampled it) that leaves the scene brings the whole radiance of the environment.
TEST_F(StageTest, ShadeMissesAddsTheEnvironment) {
    route();
    const unsigned count = bench.counts()[next_miss];
    const QueueWords misses = bench.read("miss");
    bench.run("shade_misses", count);
    const QueueWords states = bench.read("path");
    std::set<uint> missed;
    for (unsigned i = 0; i < count; ++i) missed.insert(misses.get<uint>("path", i));
    const color L = sceneOfEverything().tables.lights[sceneOfEverything().tables.environments.at(0)].L;
    for (uint i = 0; i < paths; ++i) {
        const spectrum got = states.get<spectrum>("L", i);
        ASSERT_FLOAT_EQ(got.r, missed.count(i) ? L.c0 : 0);
        ASSERT_FLOAT_EQ(got.b, missed.count(i) ? L.c2 : 0);
    }
    /* Run again over no items: no path state changes */
    bench.run("shade_misses", 0);
    const QueueWords again = bench.read("path");
    for (uint i = 0; i < paths; ++i) ASSERT_EQ(again.get<spectrum>("L", i).r, states.get<spectrum>("L", i).r);
}

TEST_F(StageTest, ShadeEmittersAddsWhatIsEmittedTowardsThePath) {
    route();
    const unsigned count = bench.counts()[next_emission];
    const QueueWords emissions = bench.read("emission");
    bench.run("shade_emitters", count);
    const QueueWords states = bench.read("path");
    std::vector<float> wanted(paths);
    for (unsigned i = 0; i < count; ++i) {
        wanted[emissions.get<uint>("path", i)] = emissions.get<spectrum>("Le", i).r;
        ASSERT_GE(emissions.get<float>("pdf_light", i), 0);
    }
    for (uint i = 0; i < paths; ++i) ASSERT_FLOAT_EQ(states.get<spectrum>("L", i).r, wanted[i]);
}

/// Each BSDF over its own segment: slot i to slot i, what is alive is whole, what lies beyond the count is dead, and the two rays
/// belong to the path of the hit.
TEST_F(StageTest, ShadeHitsAnswersSlotBySlot) {
    route();
    const auto counts = bench.counts();
    const QueueWords hits = bench.read("hit");
    size_t rays = 0, shadows = 0;
    const auto shade = [&](const std::string& bsdf, uint next_queue, Feature feature) {
        const std::string stage = "shade_hits " + bsdf;
        if (!sceneOfEverything().features.has(feature) || !hasKernelFile("bsdf/" + bsdf + ".clh")) return;
        const unsigned start = segmentStart(next_queue), count = counts[next_queue], end = (count + testGroup - 1) / testGroup * testGroup;
        for (unsigned n : {0u, std::min(count, 1u), count}) {
            bench.clear("next_ray");
            bench.clear("shadow");
            bench.run(stage, n, start);
            const QueueWords next = bench.read("next_ray"), shadow = bench.read("shadow");
            for (unsigned i = start; i < start + std::max(end, testGroup) && i < bench.capacity(); ++i) {
                if (i >= start + (n + testGroup - 1) / testGroup * testGroup) continue;
                const bool alive = i < start + n;
                for (const QueueWords* q : {&next, &shadow}) {
                    const float tMax = q->get<float>("t_max", i);
                    ASSERT_TRUE(std::isfinite(tMax)) << stage << " slot " << i;
                    if (tMax < 0) continue;
                    ASSERT_TRUE(alive) << stage << ": a ray beyond the last item";
                    expectClean(*q, i);
                    ASSERT_EQ(q->get<uint>("path", i), hits.get<uint>("path", i));
                    ASSERT_NEAR(lengthOf(q->get<vec3>("d", i)), 1, 1e-4) << stage;
                    const vec3 o = q->get<vec3>("o", i), p = hits.get<vec3>("p", i);
                    ASSERT_LT(lengthOf({o.x - p.x, o.y - p.y, o.z - p.z}), 1e-3);
                    (q == &next ? rays : shadows) += n == count;
                }
                if (next.get<float>("t_max", i) < 0) continue;
                ASSERT_EQ(next.get<uint>("seed", i), hits.get<uint>("seed", i));
                ASSERT_EQ(next.get<uint>("sample", i), hits.get<uint>("sample", i));
                ASSERT_EQ(next.get<uint>("depth", i), hits.get<uint>("depth", i) + 1);
                ASSERT_GE(next.get<float>("pdf", i), 0);
            }
        }
    };
#define SHADE(bsdf, FEATURE, PARAMETERS) shade(#bsdf, next_##bsdf, KindFeature::FEATURE);
    BSDFS(SHADE)
#undef SHADE
    EXPECT_GT(rays, 100u);
    EXPECT_GT(shadows, 50u);
}

/// A shadow ray adds Ld to its own path or nothing: nothing behind a sphere, all of it where the way is free; dead slots add nothing.
TEST_F(StageTest, TestShadowsAddsWhereTheWayIsFree) {
    const object_space& q = sceneOfEverything().tables.object_spaces.at(0);
    const vec3 center = placedCenter(q);
    QueueWords shadow = bench.empty("shadow");
    for (unsigned i = 0; i < 96; ++i) {
        /* The first object_space is the lamp, a flat disk at height 0 of its own space: straight through it, past it (far outside), dead */
        const float aside = i % 3 == 1 ? 50.0f : 0.0f;
        const vec3 n{q.scene_from_object.xz, q.scene_from_object.yz, q.scene_from_object.zz};
        const float length = static_cast<float>(lengthOf(n));
        const vec3 d{n.x / length, n.y / length, n.z / length};
        shadow.set("path", i, 95 - i);
        shadow.set("o", i,
                   vec3{center.x + aside - 0.01f * d.x + 0.003f, center.y + aside - 0.01f * d.y + 0.002f, center.z + aside - 0.01f * d.z});
        shadow.set("d", i, d);
        shadow.set("t_max", i, i % 3 == 2 ? -1.0f : 0.02f);
        shadow.set("Ld", i, spectrum{static_cast<float>(i + 1), 2, 3});
    }
    bench.write("shadow", shadow);
    bench.clear("path", 0);
    bench.resetCounters();
    bench.run("test_shadows", 0);
    EXPECT_EQ(bench.shadowRays(), 0u);
    bench.run("test_shadows", 96);
    EXPECT_EQ(bench.shadowRays(), 64u);
    const QueueWords states = bench.read("path");
    for (unsigned i = 0; i < 96; ++i) ASSERT_EQ(states.get<spectrum>("L", 95 - i).r, i % 3 == 1 ? static_cast<float>(i + 1) : 0) << i;
}

}  // namespace
}  // namespace eikonal
