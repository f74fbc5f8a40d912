// The stage that sums up samples, alone: a path's state in, the film out.

#include "device_function.h"
#include "stage_fixture.h"

#include "eikonal/film.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace eikonal {
namespace {

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
    for (size_t s = 0; s < samples; ++s) {
        states.set("L", 9 + s * side * side, spectrum{0, 0, 0});
        states.set("weight", 9 + s * side * side, 0.0f);
    }
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

/// Pixels of several blocks, some with fewer samples than others: each gets its own.
TEST(ResolveFilm, OfSeveralBlocks) {
    const Batch batch{{2, 3}, {{12, 8, 1, 2}, {0, 0, 0, 4}, {4, 8, 3, 1}}};
    StageBench bench(sceneOfEverything(), paths, true, batch.pixels());
    bench.set(batch, side, side);
    bench.run("generate_rays", batch.paths());
    QueueWords states = bench.read("path");
    for (size_t i = 0; i < batch.paths(); ++i) {
        states.set("L", i, spectrum{static_cast<float>(i / batch.size.pixels()), static_cast<float>(i % batch.size.pixels()), 1});
        states.set("weight", i, 1.0f);
    }
    bench.write("path", states);
    bench.run("resolve_film", batch.pixels());
    const QueueWords film = bench.read("film");
    size_t layer = 0, pixel = 0;
    for (const Block& b : batch.blocks) {
        float layers = 0;
        for (unsigned s = 0; s < b.samples; ++s) layers += static_cast<float>(layer++);
        for (size_t i = 0; i < batch.size.pixels(); ++i, ++pixel) {
            ASSERT_EQ(film.get<uint>("count", pixel), b.samples);
            ASSERT_EQ(film.get<spectrum>("sum", pixel).r, layers);
            ASSERT_EQ(film.get<spectrum>("sum", pixel).g, static_cast<float>(b.samples * i));
        }
    }
}

/// The spread of luminances, 65536 of them, a wave of 256 after the other, is that of a calculation in double precision: of nearly equal
/// ones, where the difference of two sums of squares would be noise; with weights of either sign and of many sizes; and of one sample among
/// others that is brighter than any square may be.
TEST_F(StageTest, ResolveFilmKnowsTheSpreadOfNearlyEqualSamples) {
    constexpr unsigned pixels = 4, perWave = 256, waves = 256;
    StageBench bench(sceneOfEverything(), pixels * perWave, true, pixels);
    bench.set(Batch{{1, 1}, {{0, 0, 0, perWave}}}, 2, 2);
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

struct Four { float r, g, b, x; };

/// Each of a sample's four wavelengths adds its radiance, times the sample's weight, to the bucket that it lies in, and to no other; those
/// beside the range add to none. A second wave adds up, and a sample that is brighter than it may be is scaled down in all buckets alike.
TEST(ResolveFilm, FillsBuckets) {
    const PackedScene scene = packText(
        "Film \"spectral\" \"integer xresolution\" 16 \"integer yresolution\" 16 \"integer nbuckets\" 7 \"float lambdamin\" 450 \"float "
        "lambdamax\" 700 \"float maxcomponentvalue\" 1e8\n"
        "Sampler \"sobol\"\nWorldBegin\nLightSource \"infinite\"\nShape \"sphere\"");
    static const DeviceFunction<Four> wavelengths({.include = "shade/color.clh",
                                                   .type = "spectrum",
                                                   .body = R"(
        color_tables set = BIND_COLORS;
        result = path_wavelengths(set, number).lambda;)",
                                                   .inputs = {"float number"},
                                                   .tables = "COLOR_TABLES(TABLE)",
                                                   .features = Features::everything()});
    StageBench bench(scene, paths, true, side * side);
    bench.set(wholeImage, side, side);
    bench.run("generate_rays", paths);
    QueueWords states = bench.read("path");
    std::vector<float> numbers;
    std::vector<double> expected(side * side * 7);
    for (size_t i = 0; i < paths; ++i) numbers.push_back(states.get<float>("wavelength", i));
    const std::vector<Four> lambda = wavelengths.with(DeviceScene(testContext(), scene), numbers);
    for (size_t i = 0; i < paths; ++i) {
        const size_t pixel = i % (side * side);
        const float value = static_cast<float>(i + 1), bright = pixel == 3 ? 1e9f : 1, weight = pixel == 5 ? -0.5f : 2.0f;
        states.set("L", i, Four{value * bright, 2 * value * bright, 3 * value * bright, 4 * value * bright});
        states.set("weight", i, weight);
        for (int channel = 0; channel < 4; ++channel) {
            const double place = ((&lambda[i].r)[channel] - 450.0) / 250 * 7;
            if (place >= 0 && place < 7) expected[pixel * 7 + static_cast<size_t>(place)] += 2 * weight * value * (channel + 1);
        }
    }
    bench.write("path", states);
    bench.run("resolve_film", side * side);
    bench.run("resolve_film", side * side);
    const QueueWords film = bench.read("film");
    const int first = film.layout().field("buckets").slot;
    ASSERT_EQ(film.layout().field("buckets").words, 14);
    const auto bucket = [&](size_t pixel, int b) {
        const uint word = film.word(first + BUCKET_WORDS * b, pixel);
        float x;
        std::memcpy(&x, &word, sizeof x);
        return static_cast<double>(x);
    };
    for (size_t pixel = 0; pixel < side * side; ++pixel) {
        if (pixel == 3) continue;
        for (int b = 0; b < 7; ++b)
            ASSERT_NEAR(bucket(pixel, b), expected[pixel * 7 + static_cast<size_t>(b)],
                        1e-6 * std::abs(expected[pixel * 7 + static_cast<size_t>(b)]))
                << pixel << " " << b;
    }
    /* Four samples, each of 1e8 in its brightest channel at most, while their light would be some 1e14 */
    const spectrum sum = film.get<spectrum>("sum", 3);
    EXPECT_GT(std::max({sum.r, sum.g, sum.b}), 0.5e8f);
    EXPECT_LE(std::max({sum.r, sum.g, sum.b}), 2 * 2 * 4 * 1.00001e8f);
    for (int b = 0; b < 7; ++b) EXPECT_LT(bucket(3, b), 1e10);
}

}  // namespace
}  // namespace eikonal
