// Every medium of the list MEDIA_KINDS: where a path's way ends, what is left of it, and what shines on it, against integrals along the way of what
// the medium says of itself. And the phase function.

#include "nanovdb_file.h"   // before include/eikonal

#include "device_function.h"
#include "random_inputs.h"
#include "stage.h"
#include "statistics.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include <unistd.h>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

std::string nanoVdbFile() {
    const std::string path = (fs::temp_directory_path() / fmt::format("eikonal-media-{}.nvdb", ::getpid())).string();
    const auto ball = [](int x, int y, int z) { return std::max(1 - std::sqrt(float(x * x + y * y + z * z)) / 13, 0.f); };
    const auto hot = [](int x, int y, int z) { return x * x + y * y + z * z < 100 ? 1500 + 50.f * float(x + y) : 0.f; };
    writeNanoVdb(path, {{"density", 16, 0.04, ball}, {"temperature", 16, 0.04, hot}});
    return path;
}

/// Values that vary, on a grid of 5 x 4 x 6.
std::string values(int each, double low, double high) {
    Random random(3);
    std::string text;
    for (int i = 0; i < 5 * 4 * 6 * each; ++i) text += fmt::format(" {}", random.below(4) ? random.between(float(low), float(high)) : 0.f);
    return "[" + text + " ]";
}

/// A medium of each kind, with colours that differ, around the origin; most shine.
std::string parametersOf(const std::string& kind) {
    const std::string colours = "\"rgb sigma_a\" [ 0.4 0.8 1.5 ] \"rgb sigma_s\" [ 0.5 2 1 ] ", size = "\"integer nx\" 5 \"integer ny\" 4 \"integer nz\" 6 ",
                      box = "\"point3 p0\" [ -0.5 -0.4 -0.5 ] \"point3 p1\" [ 0.5 0.6 0.4 ] ";
    const std::map<std::string, std::string> all = {
        {"homogeneous", colours + "\"rgb Le\" [ 1 2 0.5 ]"},
        {"uniformgrid", colours + size + box + "\"float scale\" 2 \"float density\" " + values(1, 0, 3) + " \"float Lescale\" " + values(1, 0, 1) + " \"rgb Le\" [ 1 2 0.5 ]"},
        {"rgbgrid", size + box + "\"float scale\" 2 \"rgb sigma_a\" " + values(3, 0, 2) + " \"rgb sigma_s\" " + values(3, 0, 3) + " \"rgb Le\" " + values(3, 0, 1)},
        {"cloud", colours + "\"point3 p0\" [ -0.5 0 -0.5 ] \"point3 p1\" [ 0.5 1 0.5 ] \"float density\" 2"},
        {"nanovdb", colours + "\"float scale\" 3 \"float temperaturescale\" 2 \"float temperatureoffset\" 100 \"float Lescale\" 0.1 \"string filename\" \"" + nanoVdbFile() + "\""}};
    const auto found = all.find(kind);
    return found == all.end() ? "" : found->second;
}

/// The sphere makes scene space what world space is.
PackedScene sceneWith(const std::string& kind, const std::string& parameters, const std::string& lights = "") {
    return packText("WorldBegin " + lights + " MakeNamedMedium \"m\" \"string type\" \"" + kind + "\" " + parameters + " MediumInterface \"m\" \"\" Material \"interface\" Shape \"sphere\" \"float radius\" 0.5");
}

using Channels = std::array<double, 3>;
Channels channelsOf(spectrum s) { return {s.r, s.g, s.b}; }

struct Ray { vec3 o, d; };
constexpr float wayLength = 2;
/// Through the media, along an axis and askew; the second starts inside.
const std::array<Ray, 3> rays = {Ray{{-0.9f, 0.3f, 0.1f}, {1, 0, 0}}, Ray{{0.1f, 0.25f, 0.05f}, {-0.48f, 0.6f, 0.64f}}, Ray{{0.05f, -0.7f, -0.3f}, {0, 0.8f, 0.6f}}};

struct Integrals { spectrum tau, absorbed, scattered, emitted; };   ///< up to a distance; the last three: of sigma * T, and sigma_a * Le * T
const DeviceFunction<Integrals>& integrate() {
    static const DeviceFunction<Integrals> function({.include = "medium/medium.clh", .type = "integrals", .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        color_tables color_set = BIND_COLORS;
        palette colors = path_palette(color_set, 0u, 0u);
        medium m = medium_set.media[0];
        medium_spectra c = eval_medium(colors, m);
        result.tau = result.absorbed = result.scattered = result.emitted = uniform_spectrum(0.0f);
        vec3 box_o = transform_point(m.box_from_scene, o), box_d = transform_vector(m.box_from_scene, d);
        for (int i = 0; i < 8192; ++i) {
            float step = t / 8192.0f;
            vec3 p = mul_add(box_d, ((float)i + 0.5f) * step, box_o);
            int inside = (p.x >= 0.0f) & (p.y >= 0.0f) & (p.z >= 0.0f) & (p.x <= 1.0f) & (p.y <= 1.0f) & (p.z <= 1.0f);
            medium_spectra at = c;
            if (m.kind != kind_homogeneous_medium) {
                if (!inside) continue;
                at = eval_medium_point(medium_set, colors, m, c, p);
            }
            spectrum half_tau = mul(add(at.sigma_a, at.sigma_s), 0.5f * step);
            spectrum T = mul(exp_spectrum(mul(add(result.tau, half_tau), -1.0f)), step);
            result.absorbed = add(result.absorbed, mul(at.sigma_a, T));
            result.scattered = add(result.scattered, mul(at.sigma_s, T));
            result.emitted = add(result.emitted, mul(mul(at.sigma_a, at.Le), T));
            result.tau = add(result.tau, mul(half_tau, 2.0f));
        })",
        .inputs = {"vec3 o", "vec3 d", "float t"},
        .declarations = "typedef struct { spectrum tau, absorbed, scattered, emitted; } integrals;", .tables = "MEDIUM_ARGUMENTS COLOR_ARGUMENTS"});
    return function;
}

struct Walked { uint end; float t; spectrum beta, r_u, r_l, L; };
FunctionText walkText(const std::string& body) {
    return {.include = "medium/medium.clh", .type = "walked",
            .body = "medium_tables medium_set = BIND_MEDIA; color_tables color_set = BIND_COLORS; palette colors = path_palette(color_set, 0u, 0u); random_stream more = make_stream(seed, 1u, 2u); spectrum zero = uniform_spectrum(0.0f), one = uniform_spectrum(1.0f); track end = {track_passes, t};" + body +
                    "result.end = end.end; result.t = end.t; result.beta = path.beta; result.r_u = path.r_u; result.r_l = path.r_l; result.L = path.L;",
            .inputs = {"vec3 o", "vec3 d", "float t", "uint hero", "uint seed"},
            .declarations = "typedef struct { uint end; float t; spectrum beta, r_u, r_l, L; } walked;", .tables = "MEDIUM_ARGUMENTS COLOR_ARGUMENTS"};
}
/// A path's way, and a shadow ray's to a light that nothing else could find.
const DeviceFunction<Walked>& track() {
    static const DeviceFunction<Walked> function(walkText("tracked_path path = {hero, one, one, one, zero}; float u = next_random(&more); end = sample_medium(medium_set, colors, 0u, o, d, t, u, &more, &path);"));
    return function;
}
const DeviceFunction<Walked>& attenuate() {
    static const DeviceFunction<Walked> function(walkText("tracked_path path = {hero, one, zero, one, zero}; attenuate_medium(medium_set, colors, 0u, o, d, t, &more, &path);"));
    return function;
}

/// n walks along a ray; heroes take turns, or are all the same.
std::vector<Walked> walk(const DeviceFunction<Walked>& function, const DeviceScene& scene, const Ray& ray, float t, size_t n, int hero = -1) {
    std::vector<uint> heroes(n), seeds(n);
    for (size_t i = 0; i < n; ++i) {
        heroes[i] = hero < 0 ? static_cast<uint>(i % 3) : static_cast<uint>(hero);
        seeds[i] = static_cast<uint>(i);
    }
    return function.with(scene, std::vector<vec3>(n, ray.o), std::vector<vec3>(n, ray.d), std::vector<float>(n, t), heroes, seeds);
}

double mean(spectrum s) { return (double(s.r) + s.g + s.b) / 3; }
bool finite(spectrum s) { return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b); }

/// Holds an estimate to what it estimates: within what chance does once in a hundred thousand times, and what quadrature gets wrong.
void expectMean(const Accumulator& a, double expected, const std::string& what) {
    const Estimate e = a.estimate();
    EXPECT_NEAR(e.mean, expected, 4.5 * e.error + 2e-3 * expected + 1e-6) << what << " +- " << e.error;
    EXPECT_LT(e.error, 0.03 * expected + 1e-3) << what << ": the estimate is too noisy to be tested";
}

/// Holds what becomes of paths along a ray to the integrals, and single paths to weighing no more than they can.
void expectWeights(const DeviceScene& scene, const Ray& ray) {
    const Integrals expected = integrate().with(scene, std::vector<vec3>{ray.o}, std::vector<vec3>{ray.d}, std::vector<float>{wayLength})[0];
    std::array<Accumulator, 3> passed, scattered, emitted;
    for (const Walked& w : walk(track(), scene, ray, wayLength, 60000)) {
        ASSERT_TRUE(finite(w.beta) && finite(w.r_u) && finite(w.r_l) && finite(w.L));
        for (int c = 0; c < 3; ++c) {
            const double weight = channelsOf(w.beta)[c] / mean(w.r_u);
            EXPECT_LE(weight, 3 / 0.75 * 1.001) << "a firefly";   // a third of all paths follow a channel, and at least three quarters of those the medium
            passed[c].add(w.end == 0 ? weight : 0);
            scattered[c].add(w.end == 2 ? weight : 0);
            emitted[c].add(channelsOf(w.L)[c]);
        }
    }
    for (int c = 0; c < 3; ++c) {
        expectMean(passed[c], std::exp(-channelsOf(expected.tau)[c]), fmt::format("passed, channel {}", c));
        expectMean(scattered[c], channelsOf(expected.scattered)[c], fmt::format("scattered, channel {}", c));
        expectMean(emitted[c], channelsOf(expected.emitted)[c], fmt::format("emitted, channel {}", c));
    }
}

class EveryMedium : public testing::TestWithParam<std::string> {
protected:
    static PackedScene scene() { return sceneWith(GetParam(), parametersOf(GetParam())); }
};

TEST_P(EveryMedium, HasAnExampleHere) { EXPECT_NE(parametersOf(GetParam()), ""); }

/// Ratio tracking, and whatever else shadow rays do, has the mean exp(-tau) in each channel.
TEST_P(EveryMedium, ShadowRaysLoseWhatTheyShould) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    for (const Ray& ray : rays) {
        const Channels tau = channelsOf(integrate().with(onDevice, std::vector<vec3>{ray.o}, std::vector<vec3>{ray.d}, std::vector<float>{wayLength})[0].tau);
        std::array<Accumulator, 3> T;
        for (const Walked& w : walk(attenuate(), onDevice, ray, wayLength, 30000)) {
            const double density = mean(w.r_u) + mean(w.r_l);
            for (int c = 0; c < 3; ++c) T[c].add(w.beta.r == 0 && w.beta.g == 0 && w.beta.b == 0 ? 0 : channelsOf(w.beta)[c] / density);
        }
        EXPECT_GT(tau[1], 0.3) << "the ray passes the medium by";
        for (int c = 0; c < 3; ++c) expectMean(T[c], std::exp(-tau[c]), fmt::format("channel {}, tau {}", c, tau[c]));
    }
}

/// Where the way of a path ends, and how: distances in bins of equal length, for each hero.
TEST_P(EveryMedium, PathsEndWhereTheyShould) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    constexpr size_t bins = 24, n = 20000;
    for (const Ray& ray : rays) {
        std::vector<float> ends(bins);
        for (size_t i = 0; i < bins; ++i) ends[i] = wayLength * static_cast<float>(i + 1) / bins;
        const auto integrals = integrate().with(onDevice, std::vector<vec3>(bins, ray.o), std::vector<vec3>(bins, ray.d), ends);
        for (int hero = 0; hero < 3; ++hero) {
            std::vector<double> expected, counts(2 * bins + 1);
            for (const auto of : {&Integrals::absorbed, &Integrals::scattered})
                for (size_t i = 0; i < bins; ++i)
                    expected.push_back(n * (channelsOf(integrals[i].*of)[hero] - (i ? channelsOf(integrals[i - 1].*of)[hero] : 0)));
            expected.push_back(n * std::exp(-channelsOf(integrals.back().tau)[hero]));
            for (const Walked& w : walk(track(), onDevice, ray, wayLength, n, hero)) {
                const size_t bin = std::min(static_cast<size_t>(w.t / wayLength * bins), bins - 1);
                ++counts[w.end == 0 ? 2 * bins : bin + (w.end == 2 ? bins : 0)];
            }
            const ChiSquare test = testChiSquare(counts, expected);
            EXPECT_GT(test.probability, significance) << "hero " << hero << ": " << test.describe();
        }
    }
}

/// Whatever the hero: passing, scattering and emission have the right means in all channels.
TEST_P(EveryMedium, WeightsAreRightInEveryChannel) {
    const PackedScene packed = scene();
    const DeviceScene onDevice(testContext(), packed);
    for (const Ray& ray : rays) expectWeights(onDevice, ray);
}

/// No point of the medium exceeds the bound of its cell.
TEST_P(EveryMedium, IsBounded) {
    const PackedScene packed = scene();
    if (packed.tables.media[0].kind == kind_homogeneous_medium) GTEST_SKIP() << "it needs no bounds";
    struct Both { spectrum sigma_t, bound; };
    const DeviceFunction<Both> function({.include = "medium/medium.clh", .type = "both", .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        color_tables color_set = BIND_COLORS;
        palette colors = path_palette(color_set, 0u, 0u);
        medium m = medium_set.media[0];
        medium_spectra c = eval_medium(colors, m);
        medium_spectra at = eval_medium_point(medium_set, colors, m, c, p);
        result.sigma_t = add(at.sigma_a, at.sigma_s);
        result.bound = mul(bounded_extinction(m, c), walk_majorant(medium_set, m, start_walk(m, p, make_vec3(0.0f, 0.0f, 1.0f), 1.0f)));)",
        .inputs = {"vec3 p"}, .declarations = "typedef struct { spectrum sigma_t, bound; } both;", .tables = "MEDIUM_ARGUMENTS COLOR_ARGUMENTS"});
    const DeviceScene onDevice(testContext(), packed);
    Random random(7);
    std::vector<vec3> points;
    for (int i = 0; i < 50000; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
    int full = 0;
    for (const Both& both : function.with(onDevice, points))
        for (int c = 0; c < 3; ++c) {
            ASSERT_LE(channelsOf(both.sigma_t)[c], channelsOf(both.bound)[c] * 1.00001);
            full += channelsOf(both.sigma_t)[c] > 0.5 * channelsOf(both.bound)[c];
        }
    EXPECT_GT(full, 1000) << "bounds are loose";
}

std::vector<std::string> kinds() {
    std::vector<std::string> names;
#define MEDIUM_NAME(name, FEATURE) names.push_back(#name);
    MEDIA_KINDS(MEDIUM_NAME)
#undef MEDIUM_NAME
    for (std::string& name : names) name.resize(name.size() - std::string("_medium").size());
    return names;
}
INSTANTIATE_TEST_SUITE_P(Media, EveryMedium, testing::ValuesIn(kinds()), [](const auto& info) { return info.param; });

/// Optical depths from nothing to beyond a million: nothing overflows, and shares are what Beer's law says.
TEST(ExtremeMedia, EveryOpticalDepthIsFiniteAndRight) {
    for (const std::string kind : {"homogeneous", "uniformgrid"})
        for (const double depth : {0., 1e-12, 1e-3, 1., 20., 1e3, 1e6, 1e9}) {
            const PackedScene packed = sceneWith(kind, fmt::format("\"rgb sigma_a\" [ {0} 0 {1} ] \"rgb sigma_s\" [ {0} {0} 0 ] \"rgb Le\" [ 1 1 1 ] ", depth, depth * 1e-3) +
                                                           (kind == "homogeneous" ? "" : "\"integer nx\" 2 \"point3 p0\" [ -1 -1 -1 ] \"point3 p1\" [ 1 1 1 ] \"float density\" [ 1 1 ]"));
            const DeviceScene onDevice(testContext(), packed);
            const Ray ray{{-0.5f, 0, 0}, {1, 0, 0}};
            std::array<Accumulator, 3> T, passed;
            for (const auto* function : {&track(), &attenuate()})
                for (const Walked& w : walk(*function, onDevice, ray, 1, 3000)) {
                    ASSERT_TRUE(finite(w.beta) && finite(w.r_u) && finite(w.r_l) && finite(w.L)) << kind << " of depth " << depth;
                    const double density = mean(w.r_u) + (function == &attenuate() ? mean(w.r_l) : 0);
                    for (int c = 0; c < 3; ++c)
                        (function == &attenuate() ? T : passed)[c].add(w.end != 0 || mean(w.beta) == 0 ? 0 : channelsOf(w.beta)[c] / density);
                }
            const Channels sigma{2 * depth, depth, depth * 1e-3};
            for (int c = 0; c < 3; ++c)
                for (const auto* estimates : {&T, &passed}) {
                    const Estimate e = (*estimates)[c].estimate();
                    EXPECT_NEAR(e.mean, std::exp(-sigma[c]), 4.5 * e.error + 1e-4) << kind << " of depth " << depth << " in channel " << c;
                }
        }
}

/// The brighter light has the larger share, and only what scatters has any, in RGB and at wavelengths.
TEST(Foci, ShareWaysByBrightness) {
    for (ColorMode color : {ColorMode::rgb, ColorMode::spectral}) {
        const auto pack = [&](const std::string& sigma) {
            return packText("WorldBegin\nLightSource \"point\" \"rgb I\" [ 1 .5 .2 ] LightSource \"point\" \"rgb I\" [ 3 1.5 .6 ] \"point3 from\" [ 1 0 0 ]\n"
                            "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" " + sigma + " MediumInterface \"fog\" \"\" Material \"interface\" Shape \"sphere\"", color);
        };
        const PackedScene fog = pack("\"rgb sigma_s\" [ 1 1 1 ]");
        ASSERT_EQ(fog.tables.foci.size(), 2u);
        EXPECT_NEAR(fog.tables.foci[0].share, 0.75, 1e-5);
        EXPECT_FALSE(pack("\"rgb sigma_a\" [ 1 1 1 ] \"rgb sigma_s\" [ 0 0 0 ]").features.has(Feature::FOCI));
    }
}

/// Ways that are sampled towards point lights: the density that they are weighted with is theirs, and means are right in every channel.
TEST(Foci, WaysTowardsThemAreWeightedRight) {
    const PackedScene packed = sceneWith("homogeneous", parametersOf("homogeneous"), R"(LightSource "point" "point3 from" [ 0 0.32 0.1 ] LightSource "spot" "rgb I" [ 3 3 3 ] "point3 from" [ 0.4 0.6 0.3 ])");
    ASSERT_TRUE(packed.features.has(Feature::FOCI));
    ASSERT_EQ(packed.tables.media[0].focus_count, 2u);
    const DeviceScene onDevice(testContext(), packed);

    /* Distances against their density, integrated over bins */
    const DeviceFunction<vec3> function({.include = "medium/medium.clh", .type = "vec3", .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        float sum = 0.0f, step = 2.0f / 40.0f / 64.0f;
        for (int i = 0; i < 64; ++i) sum += pdf_towards_foci(medium_set.foci, 2u, o, d, 2.0f, u.x * 2.0f + ((float)i + 0.5f) * step) * step;
        result = make_vec3(sample_towards_foci(medium_set.foci, 2u, o, d, 2.0f, u.x, u.y), sum, share_of_foci(medium_set.foci, 2u, o, d, 2.0f, 3.0f));)",
        .inputs = {"vec3 o", "vec3 d", "vec2 u"}, .tables = "MEDIUM_ARGUMENTS"});
    Random random(13);
    constexpr size_t n = 20000, bins = 40;
    for (const Ray& ray : rays) {
        std::vector<vec2> u;
        for (size_t i = 0; i < n; ++i) u.push_back(random.square());
        std::vector<double> counts(bins), expected;
        for (const vec3& r : function.with(onDevice, std::vector<vec3>(n, ray.o), std::vector<vec3>(n, ray.d), u)) {
            ++counts[std::min(static_cast<size_t>(r.x / wayLength * bins), bins - 1)];
            ASSERT_GE(r.z, 0);
            ASSERT_LE(r.z, 0.25f);
        }
        std::vector<vec2> starts;
        for (size_t i = 0; i < bins; ++i) starts.push_back({static_cast<float>(i) / bins, 0.5f});
        for (const vec3& r : function.with(onDevice, std::vector<vec3>(bins, ray.o), std::vector<vec3>(bins, ray.d), starts)) expected.push_back(n * double(r.y));
        const ChiSquare test = testChiSquare(counts, expected);
        EXPECT_GT(test.probability, significance) << test.describe();
        expectWeights(onDevice, ray);
    }
}

/// The phase function is a density, is what it is sampled with, and turns light by the cosine g on average.
TEST(Phase, IsTheDensityOfItsSamples) {
    struct Phase { vec3 wi; float value; };
    const DeviceFunction<Phase> function({.include = "medium/phase.clh", .type = "phase_sample", .body = "result.wi = sample_phase(g, wo, u); result.value = eval_phase(g, wo, result.wi);",
                                          .inputs = {"float g", "vec3 wo", "vec2 u"}, .declarations = "typedef struct { vec3 wi; float value; } phase_sample;"});
    Random random(5);
    constexpr size_t n = 20000, cosines = 20, turns = 8;
    for (const double g : {-0.99, -0.6, -1e-4, 0., 0.3, 0.9, 0.99}) {
        const vec3 wo = random.direction();
        std::vector<vec2> u;
        for (size_t i = 0; i < n; ++i) u.push_back(random.square());
        std::vector<double> counts(cosines * turns), expected;
        /* Any two directions that are perpendicular to wo and each other */
        const glm::dvec3 z = glm::normalize(glm::dvec3(wo.x, wo.y, wo.z)), x = glm::normalize(glm::cross(z, std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))), y = glm::cross(z, x);
        Accumulator turned;
        for (const Phase& s : function(std::vector<float>(n, float(g)), std::vector<vec3>(n, wo), u)) {
            const glm::dvec3 wi(s.wi.x, s.wi.y, s.wi.z);
            const double cosine = -glm::dot(wi, z), phi = std::atan2(glm::dot(wi, y), glm::dot(wi, x)) / (2 * M_PI) + 0.5;
            turned.add(cosine);
            const double closed = (1 - g * g) / (4 * M_PI * std::pow(std::max(1 + g * g - 2 * g * cosine, 1e-12), 1.5));
            EXPECT_NEAR(s.value, closed, 1e-3 * closed + 1e-2 * std::abs(g) * closed * closed) << "g " << g << " cosine " << cosine;
            ++counts[std::min(size_t((cosine + 1) / 2 * cosines), cosines - 1) * turns + std::min(size_t(phi * turns), turns - 1)];
        }
        /* The integral from cosine -1 on, in closed form */
        const auto below = [&](double cosine) { return std::abs(g) < 1e-3 ? (cosine + 1) / 2 : (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * cosine) - 1 / (1 + g)); };
        for (size_t i = 0; i < cosines; ++i)
            for (size_t j = 0; j < turns; ++j) expected.push_back(n / double(turns) * (below(-1 + 2. * double(i + 1) / cosines) - below(-1 + 2. * double(i) / cosines)));
        const ChiSquare test = testChiSquare(counts, expected);
        EXPECT_GT(test.probability, significance) << "g " << g << ": " << test.describe();
        EXPECT_NEAR(turned.estimate().mean, g, 4.5 * turned.estimate().error + 1e-3);
    }
}

/// Between voxels a packed NanoVDB grid gives what the library's own sampler gives.
TEST(SparseGrids, AreSampledAsTheLibraryDoes) {
    const PackedScene packed = sceneWith("nanovdb", parametersOf("nanovdb"));
    const DeviceScene onDevice(testContext(), packed);
    const DeviceFunction<vec2> lookup({.include = "medium/medium.clh", .type = "vec2", .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        vec3 p = transform_point(medium_set.media[0].box_from_scene, at);
        result = make_vec2(lookup_grid(medium_set, medium_set.media[0].density, p), lookup_grid(medium_set, medium_set.media[0].temperature, p));)",
        .inputs = {"vec3 at"}, .tables = "MEDIUM_ARGUMENTS COLOR_ARGUMENTS"});
    Random random(11);
    std::vector<vec3> points;
    for (int i = 0; i < 5000; ++i) points.push_back(random.box(0.7f));
    const auto found = lookup.with(onDevice, points);
    const std::string path = nanoVdbFile();
    for (const bool hot : {false, true}) {
        const auto handle = nanovdb::io::readGrid(path, std::string(hot ? "temperature" : "density"));
        const auto* grid = handle.grid<float>();
        const auto sampler = nanovdb::createSampler<1>(grid->tree());
        for (size_t i = 0; i < points.size(); ++i) {
            const float expected = sampler(grid->worldToIndexF(nanovdb::Vec3f(points[i].x, points[i].y, points[i].z)));
            EXPECT_NEAR(hot ? found[i].y : found[i].x, expected, hot ? 0.1 : 1e-4);
        }
    }
}

}  // namespace
}  // namespace eikonal
