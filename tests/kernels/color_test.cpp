// Colours at wavelengths: what the device reads from tables is the spectrum that the scene gave, and the film makes its colour of it again.

#include "device_function.h"
#include "pack/colors.h"
#include "random_inputs.h"
#include "color/uplift_table.h"
#include "stage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

struct Four { float r, g, b, x; };

/// A scene with no more than tables of colours.
struct Colors {
    Scene scene;
    Diagnostics diagnostics{LogLevel::silent};
    PackedScene packed;
    PackContext context{.scene = scene, .diagnostics = diagnostics, .required = packed, .spectral = true};
    ColorPacker packer{context, packed.tables};
    Colors() {
        packed.tables.frame.emplace_back();
        packer.packSensor(packed.frame());
    }
};

/// Values of colours at wavelengths.
std::vector<Four> evaluate(const PackedScene& scene, const std::vector<color>& colors, const std::vector<Four>& lambda) {
    static const DeviceFunction<Four> function({.include = "shade/color.clh",
                                                .type = "spectrum",
                                                .body = R"(
        sampled_wavelengths p = {curves, uplift, lambda};
        result = eval_color(p, c);)",
                                                .inputs = {"color c", "spectrum lambda"},
                                                .tables = "COLOR_TABLES(TABLE)",
                                                .features = Features::allSpectral()});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, colors, lambda);
}

TEST(Color, IsTheSpectrumThatTheSceneGave) {
    Colors tables;
    const Spectrum copper = Spectrum::sampled(namedSpectrum("metal-Cu-k")), lamp = Spectrum::blackbody(3000) * 7,
                   fog = Spectrum::rgb({.2, 3, 1}), wall = Spectrum::rgb({.8, .3, .05}), grey = Spectrum::constant(.4);
    const DenseCurve k = copper.dense(), glow = lamp.dense(), density = fog.dense();
    const double luminance = integrateXyz(glow).y;
    const SmoothReflectance paint = upliftReflectance({.8, .3, .05}, ColorSpace::srgb);
    const std::vector<color> colors{tables.packer.coefficient(copper), tables.packer.emission(lamp, 2), tables.packer.coefficient(fog, .5),
                                    tables.packer.reflectance(wall), tables.packer.reflectance(grey)};
    for (float lambda : {360.f, 411.f, 500.f, 555.f, 640.f, 830.f}) {
        const int i = static_cast<int>(lambda) - shortestWavelength;
        const double expected[] = {k[i], glow[i] / luminance * 7 * 2, density[i] * .5, paint(lambda), .4};
        const auto values = evaluate(tables.packed, colors, std::vector<Four>(colors.size(), Four{700, 600, 500, lambda}));
        for (size_t c = 0; c < colors.size(); ++c)
            EXPECT_NEAR(values[c].x, expected[c], 2e-4 * std::abs(expected[c]) + 1e-6) << "color " << c << " at " << lambda;
    }
}

/// An image's texel is looked up in the same table as the host's.
TEST(Color, OfATexelIsThatOfTheTable) {
    Colors tables;
    tables.packer.addUplift();
    static const DeviceFunction<Four> function({.include = "shade/color.clh",
                                                .type = "spectrum",
                                                .body = R"(
        sampled_wavelengths p = {curves, uplift, lambda};
        result = uplift_albedo(p, c.x, c.y, c.z);)",
                                                .inputs = {"vec3 c", "spectrum lambda"},
                                                .tables = "COLOR_TABLES(TABLE)",
                                                .features = Features::allSpectral()});
    Random random(61);
    std::vector<vec3> colors = generate(500, [&] { return vec3{random.unit(), random.unit(), random.unit()}; });
    colors.insert(colors.end(), {{0, 0, 0},
                                 {1, 1, 1},
                                 {1, 0, 0},
                                 {0, 1, 1},
                                 {1e-6f, 0, 2e-6f},
                                 {.3f, .3f, .3f},
                                 {3, 2, 0},
                                 {-.2f, .6f, .1f},
                                 {.5f, -3, -1},
                                 {-1, -2, -3}});
    const DeviceScene onDevice(testContext(), tables.packed);
    const auto values = function.with(onDevice, colors, std::vector<Four>(colors.size(), Four{420, 500, 580, 660}));
    for (size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec3 c =
            glm::max(glm::dvec3(colors[i].x, colors[i].y, colors[i].z), 0.0);  // colours of wider spaces stop at the end of sRGB
        const double largest = std::max({c.x, c.y, c.z}), scale = largest > 1 ? 2 * largest : 1;
        const bool grey = c.x == c.y && c.y == c.z;
        const auto expected = [&](double lambda) { return grey ? c.x : scale * tabulatedReflectance(c / scale)(lambda); };
        EXPECT_NEAR(values[i].r, expected(420), 2e-4) << c.x << " " << c.y << " " << c.z;
        EXPECT_NEAR(values[i].x, expected(660), 2e-4) << c.x << " " << c.y << " " << c.z;
    }
}

/// Over the samples of a pixel, the film makes of light of a colour that colour; wavelengths have the density that they say, or white would
/// not be 1. Of paths that merge, and of those that do not.
class ColorOfWavelengths : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Color, ColorOfWavelengths, testing::Bool());

TEST_P(ColorOfWavelengths, ComesBack) {
    Colors tables;
    tables.packer.packPassWavelengths(tables.packed.frame());
    const DeviceFunction<vec3> function({.include = "shade/color.clh",
                                         .type = "rgb",
                                         .body = R"(
        color_tables set = BIND_COLORS;
        sampled_wavelengths p = path_wavelengths(set, 77u, sample);
        result = color_seen(p, from, eval_color(p, c));)",
                                         .inputs = {"color c", "uint sample", "uint from"},
                                         .tables = "COLOR_TABLES(TABLE)",
                                         .features = GetParam() ? Features::allSpectral()
                                                                : Features::allSpectral()
                                                                      .without(Feature::MERGING)
                                                                      .without(Feature::CONNECTIONS)});
    const uint light = tables.packed.frame().sensor_curves, surface = tables.packed.frame().albedo_curves;
    struct Case { color c; uint from; glm::dvec3 expected; };
    const Case cases[] = {{tables.packer.emission(Spectrum::rgb({1, 1, 1})), light, {1, 1, 1}},
                          {tables.packer.emission(Spectrum::rgb({3, .5, 8})), light, {3, .5, 8}},
                          {tables.packer.reflectance(Spectrum::rgb({.7, .1, .2})), surface, {.7, .1, .2}},
                          {tables.packer.emission(Spectrum::blackbody(4000)), light, Spectrum::blackbody(4000).illuminant()}};
    constexpr uint samples = 8192;
    const DeviceScene onDevice(testContext(), tables.packed);
    std::vector<uint> numbers(samples);
    for (uint i = 0; i < samples; ++i) numbers[i] = i;
    for (const Case& test : cases) {
        glm::dvec3 sum(0);
        for (const vec3& v : function.with(onDevice, std::vector<color>(samples, test.c), numbers, std::vector<uint>(samples, test.from)))
            sum += glm::dvec3(v.x, v.y, v.z) / static_cast<double>(samples);
        /* Stratified over the distribution: far less than the standard error of independent wavelengths, which is 0.6 / sqrt(8192) */
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(sum[channel], test.expected[channel], 2e-3 * std::max(1.0, test.expected[channel])) << channel;
    }
}

/// Where a film's wavelengths are: as many within its range as it says, evenly; and one over the density of each is such that their sum is
/// the width of whatever they are counted in, within the range and beside it. The four wavelengths of n Sobol' samples lie one in each of
/// 4n cells of the distribution, so an interval has their expected number but for less than one at each end.
TEST(Color, WavelengthsOfAFilmAreEven) {
    struct Sampled { Four lambda, inverse_pdf; };
    static const DeviceFunction<Sampled> function({.include = "shade/color.clh",
                                                   .type = "sampled",
                                                   .body = R"(
        color_tables set = BIND_COLORS;
        sampled_wavelengths p = path_wavelengths(set, 77u, sample);
        result.lambda = p.lambda;
        result.inverse_pdf = MAP_SPECTRUM(INVERSE_PDF_OF, p.lambda);)",
                                                   .inputs = {"uint sample"},
                                                   .declarations = "typedef struct { spectrum lambda, inverse_pdf; } sampled;",
                                                   .tables = "COLOR_TABLES(TABLE)",
                                                   .features = Features::everything()});
    struct Case { double first, last, share; uint samples = 4096; };
    for (const Case& c : {Case{360, 830, 1},
                          {400, 700, .75},
                          {500, 501, .75},
                          {360, 800, 440 / 470.},
                          {829, 830, .75},
                          {360, 830, 1, 16},
                          {400, 700, .75, 32},
                          {400, 700, .75, 64}}) {
        const uint samples = c.samples;
        std::vector<uint> numbers(samples);
        for (uint i = 0; i < samples; ++i) numbers[i] = i;
        Colors tables;
        tables.scene.film.spectrum = SpectrumKept{16, c.first, c.last};
        tables.packer.packFilmSpectrum(tables.packed.frame());
        const DeviceScene onDevice(testContext(), tables.packed);
        constexpr int buckets = 31;
        double count[buckets] = {}, widthWithin = 0, widthBefore = 0, widthAfter = 0, firstBelow = 0;
        for (const Sampled& s : function.with(onDevice, numbers)) {
            firstBelow += s.lambda.r >= c.first && s.lambda.r < (c.first + c.last) / 2;
            for (int channel = 0; channel < 4; ++channel) {
                const double lambda = (&s.lambda.r)[channel], width = (&s.inverse_pdf.r)[channel] / (4.0 * samples);
                ASSERT_TRUE(lambda >= 360 && lambda <= 830) << lambda;
                const bool is = lambda >= c.first && lambda <= c.last;
                (is ? widthWithin : lambda < c.first ? widthBefore : widthAfter) += width;
                if (is) ++count[std::min(static_cast<int>((lambda - c.first) / (c.last - c.first) * buckets), buckets - 1)];
            }
        }
        /* What rounding of wavelengths moves over an end: a part in 30 of a bucket of 1/31 nm */
        for (double n : count)
            EXPECT_LT(std::abs(n - c.share / buckets * 4 * samples), 2 + .03 * (c.last - c.first < 2) * n) << c.first << ", " << samples;
        EXPECT_NEAR(firstBelow, c.share / 2 * samples, 2.1) << c.first << ", " << samples;
        const double cell = 1 / (4.0 * samples);
        EXPECT_NEAR(widthWithin, c.last - c.first, 2 * cell * (c.last - c.first) / c.share + 1e-4) << c.first;
        EXPECT_NEAR(widthBefore + widthAfter, 470 - (c.last - c.first), 2 * cell * 470 / (1.0001 - c.share) + 1e-4) << c.first;
        EXPECT_NEAR(widthBefore, c.first - 360, 2 * cell * 470 / (1.0001 - c.share) + 1e-4) << c.first;
    }
}

}  // namespace
}  // namespace eikonal
