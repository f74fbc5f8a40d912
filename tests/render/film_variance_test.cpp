// The variance of a pixel is that of what the pixel shows: a mean over the weights of a filter, which may be negative.

#include "rendering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// Pixels that see much of a sky, and the edge of a black ball in it.
View wide(const std::string& filter, int seed, int size = 16) {
    View view;
    view.width = view.height = size;
    view.fov = 60;
    view.samples = 64;
    view.more = "PixelFilter \"" + filter + "\"\nOption \"seed\" " + std::to_string(seed) + "\n";
    return view;
}

// Under an even sky the sum of weighted samples is as uncertain as the sum of weights, and their quotient is not uncertain at all.
TEST(FilmVariance, OfAnEvenSkyIsZeroWhateverTheFilter) {
    for (const char* filter : {"box", "gaussian", "mitchell", "sinc"}) {
        const Rendered r = render(sceneText(wide(filter, 0), "LightSource \"infinite\" \"rgb L\" [.3 .3 .3]"), surfaces());
        EXPECT_LT(*std::max_element(r.image.variance.begin(), r.image.variance.end()), 1e-12) << filter;
    }
}

// The squared difference of two images with other seeds has the expectation of the sum of both variances. Some 250 pixels at the edge of
// the ball in each of two pairs: their mean is known to about 6 %.
TEST(FilmVariance, IsHowMuchSeedsDiffer) {
    for (const char* filter : {"box", "mitchell"}) {
        constexpr int pairs = 2;
        double expected = 0, found = 0;
        for (int i = 0; i < pairs; ++i) {
            const auto image = [&](int seed) {
                return render(sceneText(wide(filter, seed, 128),
                                        "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMaterial \"diffuse\" \"rgb reflectance\" [0 0 "
                                        "0]\nShape \"sphere\""),
                              surfaces())
                    .image;
            };
            const FilmImage a = image(2 * i), b = image(2 * i + 1);
            for (size_t p = 0; p < a.pixelCount(); ++p) {
                expected += a.variance[p] + b.variance[p];
                const double difference = a.color[p].g - b.color[p].g;
                found += difference * difference;
            }
        }
        EXPECT_NEAR(found / expected, 1, 0.25) << filter;
    }
}

/// A floor under a square lamp: smooth, so Sobol' samples have far less error than independent ones.
View floorUnderALamp(const char* sampler, int samples, int seed) {
    View view;
    view.width = view.height = 32;
    view.fov = 40;
    view.samples = samples;
    view.sampler = sampler;
    view.more = "Option \"seed\" " + std::to_string(seed) + "\n";
    return view;
}
constexpr const char* lamp = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] \"bool twosided\" true Translate 0 0 -5 "
                             "Shape \"bilinearmesh\" \"point3 P\" [-2 -2 0  -2 2 0  2 -2 0  2 2 0] AttributeEnd\n"
                             "Material \"diffuse\" Shape \"bilinearmesh\" \"point3 P\" [-9 -9 0  9 -9 0  -9 9 0  9 9 0]";

// Half the mean squared difference of two images with other seeds is their variance. Over 1024 pixels it is known to about 5 %, and
// so is its root to 3 %; the estimate's own interval is 14 %.
TEST(FilmError, IsThatOfSobolSamplesAndOfIndependentOnes) {
    double classical[2], found[2];
    for (const bool isSobol : {false, true}) {
        for (const int samples : {16, 256}) {
            const char* sampler = isSobol ? "zsobol" : "independent";
            const Rendered a = render(sceneText(floorUnderALamp(sampler, samples, 1), lamp), surfaces()),
                           b = render(sceneText(floorUnderALamp(sampler, samples, 2), lamp), surfaces());
            double squares = 0, variances = 0;
            for (size_t p = 0; p < a.image.pixelCount(); ++p) {
                const double difference = a.image.color[p].g - b.image.color[p].g;
                squares += difference * difference / 2;
                variances += a.image.variance[p];
            }
            const double pixels = static_cast<double>(a.image.pixelCount());
            found[isSobol] = std::sqrt(squares / pixels);
            classical[isSobol] = std::sqrt(variances / pixels);
            ASSERT_GT(found[isSobol], 0);
            EXPECT_NEAR(a.error.error / found[isSobol], 1, 0.2) << sampler << ", " << samples << " samples";
            EXPECT_EQ(a.error.doubt, "");
        }
    }
    EXPECT_NEAR(classical[0] / found[0], 1, 0.1);
    EXPECT_GT(classical[1] / found[1], 3) << "the scene is not smooth, so this test shows nothing";
}

// Slanted edges of lamps of 10 on 0.05, which cross each pixel elsewhere. Of 16 samples one may find a lamp in a pixel that has next to
// none of it: the squared errors of some such pixels, relative to what they should be, are a hundred times the others'. So the error of an
// image is uncertain, and the interval says how far: it holds at least 90 % of 40 images.
TEST(FilmError, IntervalHoldsWhereSingleSamplesFindABrightEdge) {
    std::string lamps = "LightSource \"infinite\" \"rgb L\" [.05 .05 .05]\n"
                        "AreaLightSource \"diffuse\" \"rgb L\" [10 10 10] \"bool twosided\" true\n";
    for (const double y : {-1.3, -0.6, 0.1, 0.8})
        lamps += fmt::format("Shape \"bilinearmesh\" \"point3 P\" [-9 {} 0  9 {} 0  -9 {} 0  9 {} 0]\n", y, y + 0.4, y + 0.1, y + 0.6);
    const auto edges = [&](int samples, int seed) {
        View view;
        view.width = view.height = 48;
        view.fov = 40;
        view.samples = samples;
        view.sampler = "zsobol";
        view.more = "Option \"seed\" " + std::to_string(seed) + "\n";
        return render(sceneText(view, lamps), surfaces());
    };
    const FilmImage truth = edges(4096, 100).image;
    constexpr int images = 40;
    int within = 0;
    for (int seed = 0; seed < images; ++seed) {
        const Rendered r = edges(16, seed);
        double sum = 0;
        for (size_t p = 0; p < truth.pixelCount(); ++p) {
            const double difference = r.image.color[p].g - truth.color[p].g;
            sum += difference * difference / (truth.color[p].g * truth.color[p].g + 0.01);
        }
        const double found = std::sqrt(sum / static_cast<double>(truth.pixelCount()));
        within += r.relativeError.low <= found && found <= r.relativeError.high;
        EXPECT_LT(r.relativeError.high / r.relativeError.low, 3);
    }
    EXPECT_GE(within, 0.9 * images);
}

/// The scene with parameters added to its film.
std::string withFilm(std::string scene, const std::string& parameters) {
    const std::string film = "Film \"rgb\" ";
    return scene.replace(scene.find(film), film.size(), film + parameters + " ");
}

// A film four times as sensitive shows four times the light, with four times the error: a power of two, so to the last bit.
TEST(FilmExposure, ScalesTheImageAndItsError) {
    const std::string scene = sceneText(floorUnderALamp("zsobol", 64, 0), lamp);
    const Rendered usual = render(scene), fast = render(withFilm(scene, "\"float iso\" 400"));
    for (size_t i = 0; i < usual.image.pixelCount(); ++i) {
        ASSERT_EQ(fast.image.color[i], 4.0f * usual.image.color[i]);
        ASSERT_EQ(fast.image.variance[i], 16 * usual.image.variance[i]);
    }
    EXPECT_GT(usual.error.error, 0);
    EXPECT_DOUBLE_EQ(fast.error.error, 4 * usual.error.error);
}

// The limit is that of the image: what is left of a sky of 3 is a colour whose largest component is the limit, in the ratios that the white
// balance makes, by wavelengths as in RGB.
TEST(FilmExposure, LimitsSamplesOfTheImage) {
    const std::string scene = sceneText({}, "LightSource \"infinite\" \"rgb L\" [3 3 3]");
    const std::string balance = "\"float whitebalance\" 3200 \"float iso\" 400 ";
    for (const ColorMode color : {ColorMode::rgb, ColorMode::spectral}) {
        const auto sky = [&](const std::string& film) { return estimate(render(packScene(withFilm(scene, film), color)).image).mean; };
        const glm::dvec3 free = sky(balance), limited = sky(balance + "\"float maxcomponentvalue\" 1");
        EXPECT_GT(free.b, 2 * free.r);
        /* By wavelengths, each sample has a colour of its own */
        const double most = std::max({limited.r, limited.g, limited.b});
        if (color == ColorMode::spectral) { EXPECT_LE(most, 1 + 1e-5); continue; }
        EXPECT_NEAR(most, 1, 1e-5);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(limited[c], free[c] / std::max({free.r, free.g, free.b}), 1e-5);
    }
}

}  // namespace
}  // namespace eikonal
