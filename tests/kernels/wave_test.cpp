// Whole waves, stage after stage: until no ray is left, with no poison in anything that is alive.

#include "stage_fixture.h"

#include <cmath>

namespace eikonal {
namespace {

/// Bounce after bounce until no ray is left, every stage over what the one before it left, with what each leaves checked for poison.
/// Returns how many items each queue had in all.
std::vector<uint> traceWave(StageBench& bench) {
    bench.set(wholeImage, side, side);
    bench.runOver(each_sample, {0, paths});
    std::vector<uint> all(next_queues);
    unsigned rays = paths;
    for (int bounce = 0; bounce < 64 && rays > 0; ++bounce) {
        for (const QueueRow& queue : queueTable)
            if (queue.id != Queue::ray && queue.id != Queue::path) bench.clear(queue.name);
        bench.clear("next_ray");
        bench.resetCounters();
        bench.runOver(each_ray, {0, rays});
        bench.runOver(each_intersection, {0, rays});
        const auto counts = bench.counts();
        for (uint next = 0; next < next_queues; ++next) all[next] += counts[next];
        for (uint next : {next_miss, next_emission})
            if (counts[next]) bench.runOver(next, {0, counts[next]});
        const Segments segments = bench.segments();
        const QueueWords scatters = bench.read("scatter");
        for (unsigned i = 0; i < segments[next_scatter].count; ++i) expectClean(scatters, segments[next_scatter].first + i);
        for (uint next = Segments::first; next <= Segments::last; ++next)
            if (counts[next]) bench.runOver(next, segments[next]);
        rays = segments.slots();
        bench.runOver(each_shadow, {0, rays});
        const QueueWords next = bench.read("next_ray"), shadow = bench.read("shadow");
        for (unsigned i = 0; i < rays; ++i) {
            if (next.get<float>("t_max", i) >= 0) expectClean(next, i);
            if (shadow.get<float>("t_max", i) >= 0) expectClean(shadow, i);
        }
        bench.write("ray", next);
    }
    EXPECT_EQ(rays, 0u) << "the depth limit ends every path";
    const QueueWords states = bench.read("path");
    double sum = 0;
    for (size_t i = 0; i < paths; ++i) {
        const spectrum L = states.get<spectrum>("L", i);
        EXPECT_TRUE(std::isfinite(L.r) && std::isfinite(L.g) && std::isfinite(L.b)) << i;
        EXPECT_GE(std::min({L.r, L.g, L.b}), 0) << i;
        expectClean(states, i);
        sum += static_cast<double>(L.g);
    }
    EXPECT_GT(sum, 0);
    return all;
}

template <class Items> void expectVisited(const Items& items, std::initializer_list<int> wanted) {
    for (int next_queue : wanted) EXPECT_GT(items[static_cast<size_t>(next_queue)], 0u) << "queue " << next_queue << " was not visited";
}

TEST(Wave, EndsFiniteAndClean) {
    StageBench bench(sceneOfEverything(), paths);
    const auto items = traceWave(bench);
    expectVisited(items, {next_diffuse, next_conductor, next_specular_conductor, next_dielectric, next_specular_dielectric,
                          next_thin_dielectric, next_diffuse_transmission, next_miss, next_emission});
}

/// With an integrator that regularizes, polished things are polished for paths that come straight from the camera or off other mirrors,
/// and rough for the others: this scene has nothing rough of its own.
TEST(Wave, RegularizedEndsFiniteAndClean) {
    const PackedScene polished = packText(R"(
        LookAt 0 1 -6  0 0.3 0  0 1 0
        Camera "perspective" "float fov" 40
        Film "rgb" "integer xresolution" 16 "integer yresolution" 16
        Integrator "path" "integer maxdepth" 5 "bool regularize" true
        WorldBegin
        LightSource "infinite" "rgb L" [ 0.5 0.25 1 ]
        Material "diffuse"
        Shape "bilinearmesh" "point3 P" [ -20 -1 -20  20 -1 -20  -20 -1 20  20 -1 20 ]
        AttributeBegin Translate -2.2 0 0 Material "conductor" Shape "sphere" AttributeEnd
        AttributeBegin Translate 0 0 0 Material "dielectric" Shape "sphere" AttributeEnd
        AttributeBegin Translate 2.2 0 0 Material "coatedconductor" Shape "sphere" AttributeEnd
        AttributeBegin Translate 0 2 0 Material "hair" Shape "sphere" "float radius" 0.5 AttributeEnd)");
    ASSERT_TRUE(polished.features.has(Feature::REGULARIZE));
    StageBench bench(polished, paths);
    const auto items = traceWave(bench);
    expectVisited(items, {next_diffuse, next_specular_conductor, next_conductor, next_specular_dielectric, next_dielectric,
                          next_coated_conductor, next_hair});
}

/// The same through two nested media with an interface between them, lamps inside and outside.
TEST(Wave, ThroughMediaEndsFiniteAndClean) {
    const PackedScene fog = packText(R"(
        LookAt 0 0 -5  0 0 0  0 1 0
        Camera "perspective" "float fov" 45
        Film "rgb" "integer xresolution" 16 "integer yresolution" 16
        Sampler "sobol" "integer pixelsamples" 4
        Integrator "volpath" "integer maxdepth" 5
        MakeNamedMedium "thin" "string type" "homogeneous" "rgb sigma_a" [ 0.05 0.1 0.2 ] "rgb sigma_s" [ 0.3 0.2 0.4 ] "float g" 0.4
        MakeNamedMedium "cloud" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 2
            "float density" [ 0 1 2 1 0.5 1 3 1 ]
            "rgb sigma_a" [ 0.2 0.2 0.2 ] "rgb sigma_s" [ 2 2 2 ] "point3 p0" [ -1 -1 -1 ] "point3 p1" [ 1 1 1 ]
        WorldBegin
        LightSource "infinite" "rgb L" [ 0.5 0.5 0.5 ]
        LightSource "point" "rgb I" [ 5 5 5 ] "point3 from" [ 0 3 -3 ]
        AttributeBegin
            Material "interface"
            MediumInterface "thin" ""
            Shape "sphere" "float radius" 1.6
            MediumInterface "cloud" "thin"
            Shape "sphere" "float radius" 0.9
        AttributeEnd
        AttributeBegin
            AreaLightSource "diffuse" "rgb L" [ 3 3 3 ]
            MediumInterface "" "cloud"
            Translate 0 0 0.2
            Shape "sphere" "float radius" 0.2
        AttributeEnd)");
    ASSERT_TRUE(fog.features.has(Feature::MEDIA));
    StageBench bench(fog, paths);
    const auto items = traceWave(bench);
    expectVisited(items, {next_crossing, next_scatter, next_miss, next_emission});
}

}  // namespace
}  // namespace eikonal
