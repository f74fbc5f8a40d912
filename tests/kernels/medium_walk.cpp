#include "nanovdb_file.h"   // before include/eikonal

#include "medium_walk.h"

#include "random_inputs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include <unistd.h>

namespace eikonal {

namespace fs = std::filesystem;

std::string nanoVdbFile() {
    const std::string path = (fs::temp_directory_path() / fmt::format("eikonal-media-{}.nvdb", ::getpid())).string();
    const auto ball = [](int x, int y, int z) { return std::max(1 - std::sqrt(float(x * x + y * y + z * z)) / 13, 0.f); };
    const auto hot = [](int x, int y, int z) { return x * x + y * y + z * z < 100 ? 1500 + 50.f * float(x + y) : 0.f; };
    writeNanoVdb(path, {{"density", 16, 0.04, ball}, {"temperature", 16, 0.04, hot}});
    return path;
}

/// Values that vary, on a grid of 5 x 4 x 6.
static std::string values(int each, double low, double high) {
    Random random(3);
    std::string text;
    for (int i = 0; i < 5 * 4 * 6 * each; ++i) text += fmt::format(" {}", random.below(4) ? random.between(float(low), float(high)) : 0.f);
    return "[" + text + " ]";
}

std::string parametersOf(const std::string& kind) {
    const std::string colours = "\"rgb sigma_a\" [ 0.4 0.8 1.5 ] \"rgb sigma_s\" [ 0.5 2 1 ] ",
                      size = "\"integer nx\" 5 \"integer ny\" 4 \"integer nz\" 6 ",
                      box = "\"point3 p0\" [ -0.5 -0.4 -0.5 ] \"point3 p1\" [ 0.5 0.6 0.4 ] ";
    const std::map<std::string, std::string> all = {
        {"homogeneous", colours + "\"rgb Le\" [ 1 2 0.5 ]"},
        {"uniformgrid", colours + size + box + "\"float scale\" 2 \"float density\" " + values(1, 0, 3) + " \"float Lescale\" " +
                            values(1, 0, 1) + " \"rgb Le\" [ 1 2 0.5 ]"},
        {"rgbgrid", size + box + "\"float scale\" 2 \"rgb sigma_a\" " + values(3, 0, 2) + " \"rgb sigma_s\" " + values(3, 0, 3) +
                        " \"rgb Le\" " + values(3, 0, 1)},
        {"cloud", colours + "\"point3 p0\" [ -0.5 0 -0.5 ] \"point3 p1\" [ 0.5 1 0.5 ] \"float density\" 2"},
        {"nanovdb",
         colours +
             "\"float scale\" 3 \"float temperaturescale\" 2 \"float temperatureoffset\" 100 \"float Lescale\" 0.1 \"string filename\" \"" +
             nanoVdbFile() + "\""}};
    const auto found = all.find(kind);
    return found == all.end() ? "" : found->second;
}

PackedScene sceneWith(const std::string& kind, const std::string& parameters, const std::string& lights) {
    return packText("WorldBegin " + lights + " MakeNamedMedium \"m\" \"string type\" \"" + kind + "\" " + parameters +
                        " MediumInterface \"m\" \"\" Material \"interface\" Shape \"sphere\" \"float radius\" 0.5",
                    ColorMode::rgb);
}

const DeviceFunction<Integrals>& integrate() {
    static const DeviceFunction<Integrals> function(
        {.include = "medium/medium.clh",
         .type = "integrals",
         .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        color_tables color_set = BIND_COLORS;
        sampled_wavelengths colors = path_wavelengths(color_set, 0u, 0u);
        medium m = medium_set.media[0];
        medium_spectra c = eval_medium(colors, m);
        result.tau = result.absorbed = result.scattered = result.emitted = uniform_spectrum(0.0f);
        vec3 box_o = transform_point(m.box_from_scene, o), box_d = transform_vector(m.box_from_scene, d);
        for (int i = 0; i < 8192; ++i) {
            float step = t / 8192.0f;
            vec3 p = mul_add(box_d, ((float)i + 0.5f) * step, box_o);
            int inside = (p.x >= 0.0f) & (p.y >= 0.0f) & (p.z >= 0.0f) & (p.x <= 1.0f) & (p.y <= 1.0f) & (p.z <= 1.0f);
            medium_spectra at = c;
            if (is_heterogeneous(m)) {
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
         .declarations = "typedef struct { spectrum tau, absorbed, scattered, emitted; } integrals;",
         .tables = "MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    return function;
}

static FunctionText walkText(const std::string& body) {
    return {.include = "medium/medium.clh",
            .type = "walked",
            .body =
                "medium_tables medium_set = BIND_MEDIA; color_tables color_set = BIND_COLORS; sampled_wavelengths colors = "
                "path_wavelengths(color_set, 0u, 0u); random_stream more = make_stream(seed, 1u, 2u); spectrum zero = "
                "uniform_spectrum(0.0f), one = uniform_spectrum(1.0f); track end = {track_passes, t};" +
                body +
                "result.end = end.end; result.t = end.t; result.beta = path.beta; result.r_u = path.r_u; result.r_l = path.r_l; result.L = "
                "path.L;",
            .inputs = {"vec3 o", "vec3 d", "float t", "uint hero", "uint seed"},
            .declarations = "typedef struct { uint end; float t; spectrum beta, r_u, r_l, L; } walked;",
            .tables = "MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE)"};
}

const DeviceFunction<Walked>& track() {
    static const DeviceFunction<Walked> function(
        walkText("tracked_path path = {hero, one, one, one, zero, 0.5f}; float u = next_random(&more); "
                 "end = sample_medium(medium_set, colors, 0u, 0.0f, o, d, t, u, &more, &path);"));
    return function;
}
const DeviceFunction<Walked>& attenuate() {
    static const DeviceFunction<Walked> function(
        walkText("tracked_path path = {hero, one, zero, one, zero, 1.0f}; "
                 "attenuate_medium(medium_set, colors, 0u, 0.0f, o, d, t, &more, &path);"));
    return function;
}

std::vector<Walked> walk(const DeviceFunction<Walked>& function, const DeviceScene& scene, const MediumRay& ray, float t, size_t n,
                         int hero) {
    std::vector<uint> heroes(n), seeds(n);
    for (size_t i = 0; i < n; ++i) {
        heroes[i] = hero < 0 ? static_cast<uint>(i % 3) : static_cast<uint>(hero);
        seeds[i] = static_cast<uint>(i);
    }
    return function.with(scene, std::vector<vec3>(n, ray.o), std::vector<vec3>(n, ray.d), std::vector<float>(n, t), heroes, seeds);
}

void expectMean(const Accumulator& a, double expected, const std::string& what) {
    const Estimate e = a.estimate();
    EXPECT_NEAR(e.mean, expected, 4.5 * e.error + 2e-3 * expected + 1e-6) << what << " +- " << e.error;
    EXPECT_LT(e.error, 0.03 * expected + 1e-3) << what << ": the estimate is too noisy to be tested";
}

void expectWeights(const DeviceScene& scene, const MediumRay& ray) {
    const Integrals expected =
        integrate().with(scene, std::vector<vec3>{ray.o}, std::vector<vec3>{ray.d}, std::vector<float>{wayLength})[0];
    std::array<Accumulator, 3> passed, scattered, emitted;
    for (const Walked& w : walk(track(), scene, ray, wayLength, 60000)) {
        ASSERT_TRUE(finite(w.beta) && finite(w.r_u) && finite(w.r_l) && finite(w.L));
        for (int c = 0; c < 3; ++c) {
            const double weight = channelsOf(w.beta)[c] / mean(w.r_u);
            EXPECT_LE(weight, 3 / 0.75 * 1.001)
                << "a firefly";  // a third of all paths follow a channel, and at least three quarters of those the medium
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

}  // namespace eikonal
