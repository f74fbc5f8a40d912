// Every stage alone: queue in, queue out. The queues of one wave are made by the stages before it, each checked on its own:
// empty, with one item, and full; no word of an item that is alive may be the poison of a forgotten field.

#include "stage.h"

#include "eikonal/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace eikonal {
namespace {

constexpr unsigned side = 16, samples = 4, paths = side * side * samples;

/// Something of everything: all BSDFs but media, textures, bumps, a mix, instances, cut-outs, emitters, an environment.
const char* const everything = R"(
    LookAt 0 1 -9  0 0.5 0  0 1 0
    Camera "perspective" "float fov" 40 "float lensradius" 0.05 "float focaldistance" 9
    Film "rgb" "integer xresolution" 16 "integer yresolution" 16
    PixelFilter "gaussian" "float xradius" 1.5 "float yradius" 1.5
    Sampler "sobol" "integer pixelsamples" 4
    Integrator "path" "integer maxdepth" 5
    WorldBegin
    LightSource "infinite" "rgb L" [ 0.5 0.25 1 ]
    LightSource "point" "rgb I" [ 3 3 3 ] "point3 from" [ 0 4 -2 ]
    AttributeBegin
        AreaLightSource "diffuse" "rgb L" [ 4 3 2 ] "bool twosided" true
        Translate 0 2.2 0
        Shape "disk" "float radius" 0.9
    AttributeEnd
    AttributeBegin
        AreaLightSource "diffuse" "rgb L" [ 2 3 4 ]
        Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ -4 -1 2  0 4 3  -4 3 2 ]
    AttributeEnd
    Texture "checks" "spectrum" "checkerboard" "float uscale" 8 "float vscale" 8 "rgb tex1" [ 0.7 0.1 0.1 ] "rgb tex2" [ 0.1 0.7 0.1 ]
    Texture "bumps" "float" "checkerboard" "float uscale" 20 "float vscale" 20 "float tex1" 0.01 "float tex2" 0
    Material "diffuse" "texture reflectance" "checks" "texture displacement" "bumps"
    Shape "bilinearmesh" "point3 P" [ -20 -1 -20  20 -1 -20  -20 -1 20  20 -1 20 ]
    AttributeBegin Translate -3 0 0 Material "conductor" "float uroughness" 0.1 "float vroughness" 0.4 Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate -1.8 0 0 Material "conductor" "float roughness" 0 Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate -0.6 0 0 Material "dielectric" "float roughness" 0.3 Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 0.6 0 0 Material "dielectric" Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 1.8 0 0 Material "thindielectric" Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 3 0 0 Material "diffusetransmission" Shape "sphere" "float radius" 0.6 "float zmin" -0.4 "float alpha" 0.8 AttributeEnd
    MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.8 0.1 0.1 ]
    MakeNamedMaterial "glass" "string type" "dielectric"
    AttributeBegin
        Material "mix" "string materials" [ "red" "glass" ] "float amount" 0.4
        ObjectBegin "ball" Shape "sphere" "float radius" 0.4 ObjectEnd
        AttributeBegin Translate -1.2 1.3 0 ObjectInstance "ball" AttributeEnd
        AttributeBegin Translate 1.2 1.3 0 ObjectInstance "ball" AttributeEnd
    AttributeEnd)";

const PackedScene& scene() {
    static const PackedScene packed = [] {
        PackedScene s = packText(everything);
        s.require(Feature::AOVS, "the test");
        return s;
    }();
    return packed;
}

/// A wave, one stage after the other, with what each left behind.
class StageTest : public testing::Test {
protected:
    StageBench bench{scene(), paths, true, side * side};

    void generate(unsigned count = paths, uint endX = side, uint endY = side) {
        for (const auto& [name, value] : {std::pair<const char*, uint>{"tile_x", 0}, {"tile_y", 0}, {"tile_log2_width", 4}, {"tile_log2_height", 4}, {"end_x", endX}, {"end_y", endY},
                                          {"first_sample", 0}, {"samples", samples}, {"tile_pixels", side * side}})
            bench.set(name, value);
        bench.run("generate_rays", count);
    }
    void intersect() { generate(); bench.run("intersect_rays", paths); }
    void classify() { intersect(); bench.resetCounters(); bench.run("classify_flights", paths); }
    void route() { classify(); bench.run("route_flights", paths); }

    /// First slot of a hop's segment of the hit queue, as the host finds it.
    unsigned segmentStart(uint hop) const {
        unsigned start = 0;
        for (uint h = 0; h < hop; ++h) start += (bench.counts()[h] + testGroup - 1) / testGroup * testGroup;
        return start;
    }
};

/// No word of item i of a queue is poison.
void expectClean(const QueueWords& q, size_t i, int words = -1) {
    for (const FieldLayout& f : q.layout().fields)
        for (int w = 0; w < f.words; ++w) ASSERT_NE(q.word(f.slot + w, i), poison) << "queue " << q.layout().name << " item " << i << " field " << f.name;
    for (int w = q.layout().fields.back().slot + q.layout().fields.back().words; w < words; ++w) ASSERT_NE(q.word(w, i), poison) << "item " << i << " parameter word " << w;
}

double lengthOf(vec3 v) { return std::sqrt(static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y + static_cast<double>(v.z) * v.z); }

TEST_F(StageTest, GenerateRaysFillsEverySlotOfTheImage) {
    generate();
    const QueueWords rays = bench.read("ray"), states = bench.read("path");
    std::set<std::pair<uint, uint>> places;
    for (size_t i = 0; i < paths; ++i) {
        expectClean(rays, i);
        expectClean(states, i);
        ASSERT_EQ(rays.get<uint>("path", i), i);
        ASSERT_EQ(rays.get<uint>("sample", i) & 3u, i / (side * side)) << "of the pixel's four";
        ASSERT_EQ(rays.get<float>("t_max", i), FAR_AWAY);
        ASSERT_NEAR(lengthOf(rays.get<vec3>("d", i)), 1, 1e-6);
        ASSERT_EQ(rays.get<spectrum>("beta", i).g, 1);
        ASSERT_EQ(states.get<spectrum>("L", i).g, 0);
        places.emplace(rays.get<uint>("seed", i), rays.get<uint>("sample", i));
    }
    EXPECT_EQ(places.size(), paths) << "each has its own place in the random sequences";
}

/// What a tile reaches beyond the image is dead and weighs nothing.
TEST_F(StageTest, GenerateRaysLeavesSlotsOutsideDead) {
    generate(paths, 10, 7);
    const QueueWords rays = bench.read("ray"), states = bench.read("path");
    for (size_t i = 0; i < paths; ++i) {
        const bool inside = i % side < 10 && i / side % side < 7;
        ASSERT_EQ(rays.get<float>("t_max", i) > 0, inside) << i;
        if (!inside) { ASSERT_EQ(states.get<float>("weight", i), 0); }
    }
}

TEST_F(StageTest, IntersectRaysEmptyOneAndFull) {
    generate();
    bench.run("intersect_rays", 0);
    QueueWords flights = bench.read("flight");
    EXPECT_EQ(flights.words(), bench.empty("flight").words()) << "nothing to do, yet something was written";

    bench.run("intersect_rays", 1);
    flights = bench.read("flight");
    expectClean(flights, 0);
    for (size_t i = 1; i < flights.capacity(); ++i) ASSERT_EQ(flights.get<uint>("t", i), poison) << i;

    bench.run("intersect_rays", paths);
    flights = bench.read("flight");
    size_t hit = 0;
    for (size_t i = 0; i < paths; ++i) {
        expectClean(flights, i);
        ASSERT_GT(flights.get<float>("t", i), 0);
        hit += flights.get<uint>("element", i) != NONE;
    }
    EXPECT_GT(hit, paths / 4);
    EXPECT_LT(hit, paths);
}

TEST_F(StageTest, IntersectRaysPassesOverDeadSlots) {
    generate(paths, 10, 7);
    bench.run("intersect_rays", paths);
    const QueueWords rays = bench.read("ray"), flights = bench.read("flight");
    for (size_t i = 0; i < paths; ++i) ASSERT_EQ(flights.get<float>("t", i) < 0, rays.get<float>("t_max", i) < 0) << i;
}

/// The counts are those of the hops that the flights were given; nothing is counted twice, and dead flights not at all.
TEST_F(StageTest, ClassifyFlightsCountsItsHops) {
    intersect();
    bench.resetCounters();
    bench.run("classify_flights", 0);
    for (uint n : bench.counts()) EXPECT_EQ(n, 0u);
    bench.run("classify_flights", 1);
    EXPECT_EQ(bench.tally()[tally_rays], 1u);

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
            const shape& s = scene().tables.shapes[scene().tables.element_shapes[element]];
            found[hop_emission] += s.first_light != NONE;
            ASSERT_LT(hop, static_cast<uint>(hop_miss)) << "a surface scatters";
            ASSERT_EQ(scene().tables.materials[flights.get<uint>("material", i)].hop, hop) << "mixes are resolved";
        }
    }
    EXPECT_EQ(bench.counts(), found);
    EXPECT_EQ(bench.tally()[tally_rays], paths);
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
        if (element != NONE && scene().tables.shapes[scene().tables.element_shapes[element]].first_light != NONE) wanted[hop_emission].insert(static_cast<uint>(i));
    }
    const std::vector<int> parameterWords{
#define WORDS_OF(q, type, name, FEATURE) +WORDS_##type
#define PARAMETER_WORDS(name, FEATURE, PARAMETERS) 0 PARAMETERS(WORDS_OF, name),
        BSDFS(PARAMETER_WORDS)
#undef PARAMETER_WORDS
#undef WORDS_OF
    };
    const int common = queueLayout("hit", scene().features).words;
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

/// A camera ray (pdf 0: no light could have sampled it) that leaves the scene brings the whole radiance of the environment.
TEST_F(StageTest, ShadeMissesAddsTheEnvironment) {
    route();
    const unsigned count = bench.counts()[hop_miss];
    const QueueWords misses = bench.read("miss");
    bench.run("shade_misses", count);
    const QueueWords states = bench.read("path");
    std::set<uint> missed;
    for (unsigned i = 0; i < count; ++i) missed.insert(misses.get<uint>("path", i));
    const color L = scene().tables.lights[scene().tables.environments.at(0)].L;
    for (uint i = 0; i < paths; ++i) {
        const spectrum got = states.get<spectrum>("L", i);
        ASSERT_FLOAT_EQ(got.r, missed.count(i) ? L.c0 : 0);
        ASSERT_FLOAT_EQ(got.b, missed.count(i) ? L.c2 : 0);
    }
    /* Once more with nothing: no path that somebody has is touched */
    bench.run("shade_misses", 0);
    const QueueWords again = bench.read("path");
    for (uint i = 0; i < paths; ++i) ASSERT_EQ(again.get<spectrum>("L", i).r, states.get<spectrum>("L", i).r);
}

TEST_F(StageTest, ShadeEmittersAddsWhatIsEmittedTowardsThePath) {
    route();
    const unsigned count = bench.counts()[hop_emission];
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
    const auto shade = [&](const std::string& bsdf, uint hop, Feature feature) {
        const std::string stage = "shade_hits " + bsdf;
        if (!scene().features.has(feature) || !hasKernelFile("bsdf/" + bsdf + ".clh")) return;
        const unsigned start = segmentStart(hop), count = counts[hop], end = (count + testGroup - 1) / testGroup * testGroup;
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
#define SHADE(bsdf, FEATURE, PARAMETERS) shade(#bsdf, hop_##bsdf, Feature::FEATURE);
    BSDFS(SHADE)
#undef SHADE
    EXPECT_GT(rays, 100u);
    EXPECT_GT(shadows, 50u);
}

/// A shadow ray adds Ld to its own path or nothing: nothing behind a sphere, all of it where the way is free; dead slots add nothing.
TEST_F(StageTest, TestShadowsAddsWhereTheWayIsFree) {
    const quadric& q = scene().tables.quadrics.at(0);
    const vec3 center{q.scene_from_object.xw, q.scene_from_object.yw, q.scene_from_object.zw};
    QueueWords shadow = bench.empty("shadow");
    for (unsigned i = 0; i < 96; ++i) {
        /* The first quadric is the lamp, a flat disk at height 0 of its own space: straight through it, past it (far outside), dead */
        const float aside = i % 3 == 1 ? 50.0f : 0.0f;
        const vec3 n{q.scene_from_object.xz, q.scene_from_object.yz, q.scene_from_object.zz};
        const float length = static_cast<float>(lengthOf(n));
        const vec3 d{n.x / length, n.y / length, n.z / length};
        shadow.set("path", i, 95 - i);
        shadow.set("o", i, vec3{center.x + aside - 0.01f * d.x + 0.003f, center.y + aside - 0.01f * d.y + 0.002f, center.z + aside - 0.01f * d.z});
        shadow.set("d", i, d);
        shadow.set("t_max", i, i % 3 == 2 ? -1.0f : 0.02f);
        shadow.set("Ld", i, spectrum{static_cast<float>(i + 1), 2, 3});
    }
    bench.write("shadow", shadow);
    bench.clear("path", 0);
    bench.resetCounters();
    bench.run("test_shadows", 0);
    EXPECT_EQ(bench.tally()[tally_shadow_rays], 0u);
    bench.run("test_shadows", 96);
    EXPECT_EQ(bench.tally()[tally_shadow_rays], 64u);
    const QueueWords states = bench.read("path");
    for (unsigned i = 0; i < 96; ++i) ASSERT_EQ(states.get<spectrum>("L", 95 - i).r, i % 3 == 1 ? static_cast<float>(i + 1) : 0) << i;
}

/// Sums over the samples of each pixel: weighted, counted, samples that are not finite counted apart and taken as black.
TEST_F(StageTest, ResolveFilmSumsUp) {
    generate();
    QueueWords states = bench.read("path");
    for (size_t i = 0; i < paths; ++i) {
        const size_t pixel = i % (side * side), sample = i / (side * side);
        states.set("L", i, spectrum{static_cast<float>(sample + 1), static_cast<float>(pixel), 1});
        states.set("weight", i, pixel == 5 ? -0.5f : 2.0f);
    }
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    states.set("L", 7, spectrum{nan, 1, 1});
    states.set("L", 7 + side * side, spectrum{1, infinity, 1});
    for (size_t s = 0; s < samples; ++s) { states.set("L", 9 + s * side * side, spectrum{0, 0, 0}); states.set("weight", 9 + s * side * side, 0.0f); }
    bench.write("path", states);
    bench.run("resolve_film", side * side);
    bench.run("resolve_film", side * side);   /* a second wave adds up */
    const QueueWords film = bench.read("film");
    for (size_t pixel = 0; pixel < side * side; ++pixel) {
        const spectrum sum = film.get<spectrum>("sum", pixel);
        const float w = pixel == 5 ? -0.5f : 2.0f;
        if (pixel == 9) { ASSERT_EQ(film.get<uint>("count", pixel), 0u) << "outside of the image"; continue; }
        ASSERT_EQ(film.get<uint>("count", pixel), 2 * samples);
        ASSERT_EQ(film.get<float>("weight", pixel), 2 * samples * w);
        ASSERT_EQ(film.get<uint>("invalid", pixel), pixel == 7 ? 4u : 0u);
        const float black = pixel == 7 ? 3.0f : 0.0f;   /* the samples of red 1 and 2 count as black */
        ASSERT_FLOAT_EQ(sum.r, 2 * w * (10 - black));
        ASSERT_FLOAT_EQ(sum.b, 2 * w * (pixel == 7 ? 2.0f : 4.0f));
        ASSERT_TRUE(std::isfinite(film.get<float>("spread", pixel)));
    }
}

/// The spread of luminances, 65536 of them, a wave of 256 after the other, is that of a calculation in double precision: of nearly equal ones,
/// where the difference of two sums of squares would be noise; with weights of either sign and of many sizes; and of one sample among
/// others that is brighter than any square may be.
TEST_F(StageTest, ResolveFilmKnowsTheSpreadOfNearlyEqualSamples) {
    constexpr unsigned pixels = 4, perWave = 256, waves = 256;
    StageBench bench(scene(), pixels * perWave, true, pixels);
    bench.set("tile_pixels", pixels);
    bench.set("samples", perWave);
    QueueWords states = bench.empty("path");
    std::fill(states.words().begin(), states.words().end(), 0);
    std::vector<double> y[pixels], a[pixels];
    uint random = 1;
    const auto next = [&] { random = random * 1664525u + 1013904223u; return static_cast<float>(random >> 8) * 0x1p-24f; };
    for (unsigned s = 0; s < perWave; ++s)
        for (unsigned pixel = 0; pixel < pixels; ++pixel) {
            float luminance = 1 + 1e-3f * next(), weight = 1;
            if (pixel == 1) luminance = 1000 + 1e-2f * next();
            if (pixel == 2) weight = next() - 0.25f;
            if (pixel == 3 && s == 100) luminance = 1e24f;
            states.set("L", s * pixels + pixel, spectrum{luminance, luminance, luminance});
            states.set("weight", s * pixels + pixel, weight);
            y[pixel].push_back(0.2126f * luminance + 0.7152f * luminance + 0.0722f * luminance);
            a[pixel].push_back(static_cast<double>(weight) * weight);
        }
    bench.write("path", states);
    for (unsigned wave = 0; wave < waves; ++wave) bench.run("resolve_film", pixels);
    const QueueWords film = bench.read("film");
    for (unsigned pixel = 0; pixel < pixels; ++pixel) {
        double weight = 0, mean = 0, spread = 0;
        for (unsigned s = 0; s < perWave; ++s) { weight += a[pixel][s]; mean += a[pixel][s] * y[pixel][s]; }
        mean /= weight;
        for (unsigned s = 0; s < perWave; ++s) spread += a[pixel][s] * (y[pixel][s] - mean) * (y[pixel][s] - mean);
        EXPECT_EQ(film.get<uint>("count", pixel), perWave * waves);
        if (pixel == 3) { EXPECT_EQ(film.get<float>("spread", pixel), MOST_SPREAD); continue; }
        EXPECT_NEAR(film.get<float>("square_weight", pixel) / (weight * waves), 1, 1e-4) << pixel;
        EXPECT_NEAR(film.get<float>("mean", pixel), mean, 0.05 * std::sqrt(spread / weight)) << pixel;
        EXPECT_NEAR(film.get<float>("spread", pixel) / (spread * waves), 1, 0.01) << pixel;
    }
}

/// Bounce after bounce until no ray is left, every stage over what the one before it left, with what each leaves checked for poison.
/// Returns how many items each queue had in all.
std::vector<uint> traceWave(StageBench& bench) {
    for (const auto& [name, value] : {std::pair<const char*, uint>{"tile_x", 0}, {"tile_y", 0}, {"tile_log2_width", 4}, {"tile_log2_height", 4}, {"end_x", side}, {"end_y", side},
                                      {"first_sample", 0}, {"samples", samples}})
        bench.set(name, value);
    bench.run("generate_rays", paths);
    const bool media = bench.scene().features.has(Feature::MEDIA);
    std::vector<uint> all(hops);
    unsigned rays = paths;
    for (int bounce = 0; bounce < 64 && rays > 0; ++bounce) {
        for (const char* queue : {"flight", "hit", "scatter", "miss", "emission", "next_ray", "shadow"}) bench.clear(queue);
        bench.run("intersect_rays", rays);
        if (media) bench.run("extinguish_rays", rays);
        bench.resetCounters();
        bench.run("classify_flights", rays);
        bench.run("route_flights", rays);
        const auto counts = bench.counts();
        for (uint h = 0; h < hops; ++h) all[h] += counts[h];
        if (counts[hop_miss]) bench.run("shade_misses", counts[hop_miss]);
        if (counts[hop_emission]) bench.run("shade_emitters", counts[hop_emission]);
        /* Segments of the hops in order; what passes straight on is in its own already */
        const QueueWords scatters = bench.read("scatter");
        unsigned first = 0;
        for (uint hop = 0; hop < hop_miss; ++hop) {
            std::string stage;
            if (hop == hop_scatter) stage = "shade_scatters";
#define NAME_STAGE(bsdf, FEATURE, PARAMETERS) if (hop == hop_##bsdf) stage = "shade_hits " #bsdf;
            BSDFS(NAME_STAGE)
#undef NAME_STAGE
            if (hop == hop_scatter) for (unsigned i = first; i < first + counts[hop]; ++i) expectClean(scatters, i);
            if (counts[hop] && !stage.empty()) bench.run(stage, counts[hop], first);
            first += (counts[hop] + testGroup - 1) / testGroup * testGroup;
        }
        rays = first;
        bench.run("test_shadows", rays);
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

TEST(Wave, EndsFiniteAndClean) {
    StageBench bench(scene(), paths);
    const auto items = traceWave(bench);
    for (int hop : {hop_diffuse, hop_conductor, hop_specular_conductor, hop_dielectric, hop_specular_dielectric, hop_thin_dielectric, hop_diffuse_transmission, hop_miss, hop_emission})
        EXPECT_GT(items[static_cast<size_t>(hop)], 0u) << "hop " << hop << " was not visited";
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
    for (int hop : {hop_diffuse, hop_specular_conductor, hop_conductor, hop_specular_dielectric, hop_dielectric, hop_coated_conductor, hop_hair})
        EXPECT_GT(items[static_cast<size_t>(hop)], 0u) << "hop " << hop << " was not visited";
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
        MakeNamedMedium "cloud" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 2 "float density" [ 0 1 2 1 0.5 1 3 1 ]
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
    for (uint hop : {static_cast<uint>(hop_passage), static_cast<uint>(hop_scatter), static_cast<uint>(hop_miss), static_cast<uint>(hop_emission)})
        EXPECT_GT(items[hop], 0u) << "hop " << hop << " was not visited";
}

}  // namespace
}  // namespace eikonal
