// The two stages that only media have, alone: queue in, queue out (*_stage_test.cpp have the others).

#include "random_inputs.h"
#include "stage.h"
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

constexpr unsigned items = 4096;
constexpr float sigmaA = 0.5f, sigmaS = 1.5f, way = 0.7f;

/// Scene space is what world space is, since the ball's box has a radius of at most 1.
const PackedScene& scene() {
    static const PackedScene packed = packText(R"(
        Integrator "volpath" "integer maxdepth" 5
        WorldBegin
        LightSource "distant" "rgb L" [ 3 2 1 ] "point3 from" [ 0 0 1 ] "point3 to" [ 0 0 0 ]
        MakeNamedMedium "fog" "string type" "homogeneous" "rgb sigma_a" [ 0.5 0.5 0.5 ] "rgb sigma_s" [ 1.5 1.5 1.5 ] "rgb Le" [ 1 2 4 ]
            "float g" 0.6
        MediumInterface "fog" "" Material "interface" Shape "sphere" "float radius" 0.5)");
    return packed;
}

/// What any path carries; fields that the scene has no use for are not there.
void setTravel(QueueWords& q, unsigned i, unsigned depth) {
    q.set("path", i, items - 1 - i);
    q.set("seed", i, i * 2654435761u);
    q.set("sample", i, i % 7);
    q.set("depth", i, depth);
    q.set("beta", i, spectrum{0.25f, 0.5f, 1});
    for (const char* field : {"time", "eta_scale"}) q.set(field, i, 1.0f);
    for (const char* field : {"has_nonspecular_vertex", "has_nondelta_sample", "within", "uncounted", "around", "around_second",
                              "around_third"}) q.set(field, i, 0u);
    q.set("r_u", i, spectrum{1, 1, 1});
}

void expectClean(const QueueWords& q, unsigned i) {
    for (int w = 0; w < q.layout().words; ++w)
        ASSERT_NE(q.word(w, i), poison) << "queue " << q.layout().name << " item " << i << " word " << w;
}

double lengthOf(vec3 v) { return std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z); }

/// Of four rays each: two in fog, one in vacuum, one dead. Shares of what becomes of those in fog are Beer's; all others stay what they
/// were, word by word.
TEST(MediumStages, ExtinguishRaysTakesWhatIsInMedia) {
    StageBench bench(scene(), items, true, items);
    QueueWords rays = bench.empty("ray"), intersections = bench.empty("intersection");
    for (unsigned i = 0; i < items; ++i) {
        setTravel(rays, i, 1);
        rays.set("o", i, vec3{0, 0, 0});
        rays.set("d", i, vec3{0, 0, 1});
        rays.set("t_max", i, i % 4 == 3 ? -1.0f : FAR_AWAY);
        rays.set("pdf", i, 0.5f);
        rays.set("traveled", i, 0.0f);
        rays.set("r_l", i, spectrum{2, 2, 2});
        rays.set("medium", i, i % 4 == 2 ? NONE : 0u);
        intersections.set("t", i, way);
        intersections.set("element", i, 0u);
        intersections.set("u", i, 0.25f);
        intersections.set("v", i, 0.75f);
        intersections.set("next_queue", i, static_cast<uint>(next_none));
        intersections.set("material", i, 0u);
    }
    bench.write("ray", rays);
    bench.write("intersection", intersections);
    bench.clear("path", 0);
    bench.run("extinguish_rays", 0);
    EXPECT_EQ(bench.read("intersection").words(), intersections.words()) << "no slot was to be touched";
    bench.run("extinguish_rays", items);

    const QueueWords raysOut = bench.read("ray"), intersectionsOut = bench.read("intersection"), states = bench.read("path");
    std::vector<double> counts(3);
    double emitted = 0;
    for (unsigned i = 0; i < items; ++i) {
        const spectrum L = states.get<spectrum>("L", items - 1 - i);
        if (i % 4 >= 2) {
            for (int w = 0; w < rays.layout().words; ++w) ASSERT_EQ(raysOut.word(w, i), rays.word(w, i)) << i;
            for (int w = 0; w < intersections.layout().words; ++w) ASSERT_EQ(intersectionsOut.word(w, i), intersections.word(w, i)) << i;
            ASSERT_EQ(L.g, 0);
            continue;
        }
        const uint next_queue = intersectionsOut.get<uint>("next_queue", i);
        const bool scattered = next_queue == next_scatter, absorbed = next_queue == next_absorbed;
        ++counts[scattered ? 2 : absorbed ? 1 : 0];
        emitted += L.g;
        ASSERT_EQ(intersectionsOut.get<uint>("element", i), scattered || absorbed ? NONE : 0u);
        ASSERT_EQ(intersectionsOut.get<float>("t", i) < way, scattered || absorbed);
        /* A grey medium changes neither throughput nor densities; light sampling would have passed for certain */
        ASSERT_NEAR(raysOut.get<spectrum>("beta", i).g, 0.5, 1e-5);
        ASSERT_NEAR(raysOut.get<spectrum>("r_u", i).b, 1, 1e-5);
        if (!scattered && !absorbed) { EXPECT_NEAR(raysOut.get<spectrum>("r_l", i).r, 2 * std::exp((sigmaA + sigmaS) * way), 1e-4); }
    }
    const double n = items / 2, T = std::exp(-(sigmaA + sigmaS) * way);
    const ChiSquare test = testChiSquare(counts, {n * T, n * (1 - T) * 0.25, n * (1 - T) * 0.75});
    EXPECT_GT(test.probability, significance) << test.describe();
    /* beta sigma_a Le / sigma_t at every event, of which there are n (1 - T) */
    EXPECT_NEAR(emitted / n, 0.5 * 0.25 * 2 * (1 - T), 4.5 * 0.25 * std::sqrt(T * (1 - T) / n));
}

/// One scattering each: a ray on with the phase function's density, and a shadow ray to the light with its value; slot i to slot i.
TEST(MediumStages, ShadeScattersAnswersSlotBySlot) {
    StageBench bench(scene(), items, true, items);
    QueueWords scatters = bench.empty("scatter");
    Random random(4);
    for (unsigned i = 0; i < items; ++i) {
        setTravel(scatters, i, 0);
        scatters.set("p", i, vec3{0.1f, 0.2f, 0.3f});
        scatters.set("wo", i, random.direction());
        scatters.set("medium", i, 0u);
        scatters.set("g", i, 0.6f);
    }
    bench.write("scatter", scatters);
    constexpr unsigned alive = items - 70;
    bench.run("shade_scatters", alive);

    const QueueWords rays = bench.read("next_ray"), shadows = bench.read("shadow");
    const auto phase = [](double cosine) { return (1 - 0.36) / (4 * M_PI * std::pow(1.36 + 1.2 * cosine, 1.5)); };   // of wo and wi
    Accumulator turned;
    for (unsigned i = 0; i < alive; ++i) {
        expectClean(rays, i);
        expectClean(shadows, i);
        const vec3 wo = scatters.get<vec3>("wo", i), wi = rays.get<vec3>("d", i);
        const double cosine = double(wo.x) * wi.x + double(wo.y) * wi.y + double(wo.z) * wi.z;
        turned.add(-cosine);
        ASSERT_NEAR(lengthOf(wi), 1, 1e-5);
        ASSERT_EQ(rays.get<uint>("path", i), items - 1 - i);
        ASSERT_EQ(rays.get<uint>("depth", i), 1u);
        ASSERT_EQ(rays.get<uint>("medium", i), 0u);
        ASSERT_EQ(rays.get<float>("t_max", i), FAR_AWAY);   // no roulette at the first event
        ASSERT_EQ(rays.get<spectrum>("beta", i).r, 0.25f);
        ASSERT_NEAR(rays.get<float>("pdf", i) / phase(cosine), 1, 2e-3);
        ASSERT_NEAR(rays.get<spectrum>("r_l", i).g * rays.get<float>("pdf", i), 1, 1e-4);

        ASSERT_EQ(shadows.get<uint>("path", i), items - 1 - i);
        ASSERT_EQ(shadows.get<vec3>("o", i).y, 0.2f);
        ASSERT_NEAR(shadows.get<vec3>("d", i).z, 1, 1e-6);
        ASSERT_GT(shadows.get<float>("t_max", i), 1);
        const double expected = phase(wo.z);
        ASSERT_NEAR(shadows.get<spectrum>("Ld", i).r / (0.25 * 3 * expected), 1, 2e-3);
        ASSERT_NEAR(shadows.get<spectrum>("Ld", i).b / (1 * 1 * expected), 1, 2e-3);
        ASSERT_EQ(shadows.get<spectrum>("r_u", i).g, 0);    // nothing but light sampling finds a distant light
        ASSERT_EQ(shadows.get<spectrum>("r_l", i).g, 1);
        ASSERT_EQ(shadows.get<uint>("medium", i), 0u);
    }
    EXPECT_NEAR(turned.estimate().mean, 0.6, 4.5 * turned.estimate().error);
    for (unsigned i = alive; i < items / testGroup * testGroup; ++i) {
        const bool untouched = rays.get<uint>("t_max", i) == poison;
        ASSERT_TRUE(untouched || rays.get<float>("t_max", i) < 0) << i;
    }
}

}  // namespace
}  // namespace eikonal
