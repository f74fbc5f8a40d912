// A film that keeps a spectrum of each pixel: its buckets hold what light there is between their wavelengths, and are as reproducible as
// the rest.

#include "rendering.h"

#include "read/pbrt/read_pbrt.h"
#include "color/observer.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <unistd.h>

namespace eikonal {
namespace {

struct Range { int buckets; double first, last; double width() const { return (last - first) / buckets; } };

/// A view of 64 x 64 pixels, whose film keeps a spectrum.
View view(const Range& range, const std::string& more = "", const std::string& film = "") {
    View v;
    v.width = v.height = 64;
    v.samples = 64;
    v.more = fmt::format(
        "Film \"spectral\" \"integer xresolution\" 64 \"integer yresolution\" 64 \"integer nbuckets\" {} \"float lambdamin\" {} \"float "
        "lambdamax\" {} {}\n{}",
        range.buckets, range.first, range.last, film, more);
    return v;
}

double sumOf(const DenseCurve& curve) { return integrateXyz(curve).y; }
DenseCurve one() { DenseCurve c; c.fill(1); return c; }

/// The mean between two wavelengths of a curve that, as the device's, has the value of the nearest nm.
double meanOf(const DenseCurve& curve, double from, double to) {
    double sum = 0;
    for (int i = 0; i < wavelengthCount; ++i)
        sum += curve[i] * std::max(0.0, std::min(to, shortestWavelength + i + 0.5) - std::max(from, shortestWavelength + i - 0.5));
    return sum / (to - from);
}

/// The mean over the pixels of each bucket, and its standard error.
std::vector<std::pair<double, double>> bucketsOf(const FilmImage& image) {
    const size_t buckets = image.spectrum.wavelengths.size(), n = image.pixelCount();
    std::vector<std::pair<double, double>> found;
    for (size_t b = 0; b < buckets; ++b) {
        double sum = 0, squares = 0;
        for (size_t i = 0; i < n; ++i) sum += image.spectrum.radiance[i * buckets + b];
        for (size_t i = 0; i < n; ++i) squares += std::pow(image.spectrum.radiance[i * buckets + b] - sum / static_cast<double>(n), 2);
        found.push_back({sum / static_cast<double>(n), std::sqrt(squares / static_cast<double>(n * (n - 1)))});
    }
    return found;
}

/// Holds every bucket to the mean of a spectrum in it, within 4 standard errors and what floats round, which are to be at most 2 % of it.
void expectSpectrum(const Rendered& r, const Range& range, const DenseCurve& expected, const std::string& what) {
    const auto found = bucketsOf(r.image);
    ASSERT_EQ(found.size(), static_cast<size_t>(range.buckets));
    EXPECT_EQ(r.invalid.count, 0u);
    for (int b = 0; b < range.buckets; ++b) {
        const double from = range.first + b * range.width(), mean = meanOf(expected, from, from + range.width());
        const auto [seen, error] = found[static_cast<size_t>(b)];
        EXPECT_NEAR(r.image.spectrum.wavelengths[static_cast<size_t>(b)], from + range.width() / 2, 1e-3) << what;
        EXPECT_NEAR(seen, mean, standardErrors * error + 3e-5 * mean) << what << ": " << from << " nm to " << from + range.width();
        EXPECT_LE(error, 0.02 * mean) << what << ": too few samples to tell";
    }
}

/// A sky of a spectrum s is one of s, in units in which its luminance is that of 1 at all wavelengths: whatever the sampler, and whatever
/// the range.
TEST(SpectralFilm, ASkyHasItsSpectrum) {
    const SampledCurve steps{{360, 450, 500, 501, 620, 830}, {1, 4, 2, .5, 3, .2}};
    const DenseCurve pairs = densify(steps), glow = Spectrum::blackbody(4000).dense();
    struct Sky { std::string light; const DenseCurve& curve; };
    for (const Sky& sky : {Sky{"\"spectrum L\" [360 1  450 4  500 2  501 .5  620 3  830 .2]", pairs}, {"\"blackbody L\" 4000", glow}})
        for (const Range& range : {Range{16, 360, 830}, {31, 400, 700}, {5, 499.25, 502}, {1, 360, 830}, {3, 700, 830}})
            for (const char* sampler : {"independent", "zsobol"}) {
                View v = view(range);
                v.sampler = sampler;
                DenseCurve expected = sky.curve;
                for (double& x : expected) x *= sumOf(one()) / sumOf(sky.curve);
                expectSpectrum(render(sceneText(v, "LightSource \"infinite\" " + sky.light)), range, expected,
                               fmt::format("{} in {}, {}", sky.light, range.buckets, sampler));
            }
}

/// Under a sky of 1, white glass that disperses cannot be seen at any wavelength, though most of its paths have one wavelength left; and a
/// filter with negative weights does not show either.
TEST(SpectralFilm, DispersionKeepsTheSpectrum) {
    const Range range{10, 400, 700};
    View v = view(range, "PixelFilter \"mitchell\"");
    v.samples = 256;
    v.maxDepth = 60;
    expectSpectrum(render(sceneText(v,
                                    "LightSource \"infinite\" \"spectrum L\" [360 1 830 1]\nMaterial \"dielectric\" \"spectrum eta\" "
                                    "\"glass-F11\"\nShape \"sphere\"")),
                   range, one(), "glass");
}

/// A ball of glass that disperses, with a coloured medium in it, has at each wavelength the radiance of a ball with the index of that
/// wavelength: what chose a path while it had all its wavelengths does not count once a single one is left.
TEST(SpectralFilm, DispersionInAColoredMediumKeepsTheSpectrum) {
    const Range range{4, 420, 660};
    const auto ball = [&](const std::string& eta) {
        View v = view(range);
        v.fov = 20;
        v.samples = 128;
        v.maxDepth = 40;
        return render(sceneText(v, fmt::format(R"(LightSource "infinite" "spectrum L" [360 1 830 1]
MakeNamedMedium "juice" "string type" "homogeneous" "spectrum sigma_a" [400 .1 700 .9] "spectrum sigma_s" [400 3 700 .3] "float g" .3
MediumInterface "juice" ""
Material "dielectric" {}
Shape "sphere")", eta)));
    };
    const double least = 1.3, most = 2.1;   // at the ends of the spectrum's pairs
    const auto found = bucketsOf(ball(fmt::format("\"spectrum eta\" [360 {} 760 {}]", least, most)).image);
    for (int b = 0; b < range.buckets; ++b) {
        const double middle = range.first + (b + 0.5) * range.width();
        const auto [expected, error] = bucketsOf(ball(fmt::format("\"float eta\" {}", least + (most - least) * (middle - 360) / 400)).image)
            [static_cast<size_t>(b)];
        const auto [seen, ownError] = found[static_cast<size_t>(b)];
        /* Across a bucket of 60 nm the radiance is not quite linear in the wavelength */
        EXPECT_NEAR(seen, expected, standardErrors * std::hypot(error, ownError) + 3e-3 * expected) << middle << " nm";
        EXPECT_LT(ownError, 0.01 * expected) << "too few samples to tell";
    }
}

/// Coloured things under a lamp and a sky, with fog.
const std::string room = R"(LightSource "infinite" "rgb L" [.2 .3 .5]
AttributeBegin AreaLightSource "diffuse" "blackbody L" 3000 "float scale" 5 Translate 0 3 0 Rotate 90 1 0 0 Shape "disk" AttributeEnd
Material "diffuse" "rgb reflectance" [.8 .4 .1] Shape "bilinearmesh" "point3 P" [-5 -1 -5  5 -1 -5  -5 -1 5  5 -1 5]
AttributeBegin Translate -1 0 0 Material "dielectric" "spectrum eta" "glass-F11" Shape "sphere" "float radius" .8 AttributeEnd
AttributeBegin Translate 1 0 0 Material "coateddiffuse" "rgb reflectance" [.1 .3 .7] Shape "sphere" "float radius" .8 AttributeEnd
)";
constexpr const char* lookAtRoom = "0 1 -5  0 0 0  0 1 0";

View viewOfRoom(const Range& range, const std::string& more = "", const std::string& film = "") {
    View v = view(range, more, film);
    v.lookAt = lookAtRoom;
    v.fov = 40;
    v.samples = 32;
    v.sampler = "zsobol";
    return v;
}

std::string thinLens() {
    static const std::string file = (std::filesystem::temp_directory_path() / fmt::format("eikonal-spectra-{}.dat", ::getpid())).string();
    std::ofstream(file) << "50 .02 1.5 20\n-50 .02 1 20\n0 50 0 20\n";
    return fmt::format("Camera \"realistic\" \"string lensfile\" \"{}\" \"float aperturediameter\" 1.6 \"float focusdistance\" 2\n", file);
}

/// The colour of a pixel is its spectrum, seen through the eye's matching functions: the same samples make both, so buckets of 1 nm leave
/// but what the functions change within one, which is no more than 0.5 % of a sample. Samples that are brighter than they may be are held
/// down in both; iso counts in the colour alone.
TEST(SpectralFilm, AColorIsThatOfItsSpectrum) {
    const Range range{470, 360, 830};
    struct Case { const char* what; std::string more, film; double exposure; };
    for (const Case& c : {Case{"plain", "", "", 1},
                          {"held down", "PixelFilter \"gaussian\"", "\"float maxcomponentvalue\" .5 \"float iso\" 200", 2},
                          {"through a lens", thinLens(), "", 1}}) {
        const Rendered r = render(sceneText(viewOfRoom(range, c.more, c.film), room));
        glm::dvec3 seen(0), fromSpectrum(0);
        double worst = 0;
        const glm::dmat3 rgbFromSpectrum = c.exposure / sumOf(one()) * rgbFromXyz(ColorSpace::srgb);
        for (size_t i = 0; i < r.image.pixelCount(); ++i) {
            glm::dvec3 xyz(0);
            for (size_t b = 0; b < 470; ++b)
                xyz += 0.5 * (matchingFunctions()[b] + matchingFunctions()[b + 1]) * double(r.image.spectrum.radiance[i * 470 + b]);
            const glm::dvec3 color = rgbFromSpectrum * xyz, own(r.image.color[i]);
            seen += own;
            fromSpectrum += color;
            worst = std::max(worst, glm::length(color - own) / glm::length(own));
        }
        for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(fromSpectrum[channel] / seen[channel], 1, 1e-3) << c.what;
        EXPECT_LT(worst, 0.05) << c.what;
        EXPECT_GT(seen.g, 0) << c.what;
    }
}

/// Whatever range a film keeps, colours and albedos are those of all light.
TEST(SpectralFilm, ColorsAreAsUsual) {
    const auto rendered = [](const std::string& text) {
        PackedScene scene = packScene(text, ColorMode::spectral);
        scene.require(Feature::AOVS, "the test");
        return render(std::move(scene));
    };
    const auto meanAlbedo = [](const FilmImage& image) {
        glm::dvec3 sum(0);
        for (const glm::vec3& a : image.albedo) sum += glm::dvec3(a) / static_cast<double>(image.pixelCount());
        return sum;
    };
    /* A million paths, most of whose noise is the glass's: 0.3 % of the mean */
    const auto many = [](View v) { v.samples = 256; return v; };
    View usual = many(viewOfRoom({}));
    usual.more.clear();
    const Rendered expected = rendered(sceneText(usual, room));
    for (const Range& range : {Range{16, 360, 830}, {4, 500, 600}}) {
        const Rendered found = rendered(sceneText(many(viewOfRoom(range)), room));
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(estimate(found.image).mean[c] / estimate(expected.image).mean[c], 1, 0.01) << range.first;
            EXPECT_NEAR(meanAlbedo(found.image)[c] / meanAlbedo(expected.image)[c], 1, 0.005) << range.first;
        }
    }
}

/// Of a small image, for many renders of it.
PackedScene smallRoom(int samples = 8) {
    View v = viewOfRoom({31, 400, 710});
    v.more =
        "PixelFilter \"sinc\"\nFilm \"spectral\" \"integer xresolution\" 24 \"integer yresolution\" 20 \"integer nbuckets\" 31 "
        "\"float lambdamin\" 400 \"float lambdamax\" 710\n";
    v.samples = samples;
    PackedScene scene = packScene(sceneText(v, room));
    scene.require(Feature::AOVS, "the test");
    return scene;
}

TEST(SpectralFilm, HowTheWorkIsCutDoesNotShow) {
    RenderSetup setup;
    setup.contraction = false;
    const PackedScene scene = smallRoom();
    const FilmImage reference = render(scene, setup).image;
    ASSERT_EQ(reference.spectrum.radiance.size(), 24u * 20u * 31u);
    for (unsigned paths : {64u, 1000u, 65472u}) {
        RenderSetup other = setup;
        other.shape.wavePaths = paths;
        expectSameBits(reference, render(scene, other).image, fmt::format("{} paths in a wave", paths));
    }
    RenderSetup parts = setup;
    parts.splits = {1, 3, 4};
    expectSameBits(reference, render(scene, parts).image, "in parts");

    PackedScene crop = scene;
    crop.pixels = {5, 3, 18, 16};
    const FilmImage part = render(crop, setup).image;
    expectSameBits(reference, part, "the crop");
    for (int y = 3; y < 16; ++y)
        for (int x = 5; x < 18; ++x)
            for (size_t b = 0; b < 31; ++b)
                ASSERT_EQ(part.spectrum.radiance[part.index(x, y) * 31 + b], reference.spectrum.radiance[reference.index(x, y) * 31 + b])
                    << x << " " << y;
}

/// The same of adaptive sampling; and each pixel has the spectrum of a render of as many samples as it got.
TEST(SpectralFilm, AdaptiveSamplingKeepsSpectra) {
    RenderSetup setup;
    setup.contraction = false;
    setup.targetError = 0.2;
    PackedScene scene = smallRoom(128);
    const FilmImage adaptive = render(scene, setup).image;
    RenderSetup other = setup;
    other.shape.wavePaths = 1000;
    expectSameBits(adaptive, render(scene, other).image, "waves of 1000");
    setup.targetError.reset();
    size_t compared = 0;
    for (int n = 16; n <= 128; n *= 2) {
        scene.samples = n;
        const FilmImage uniform = render(scene, setup).image;
        for (size_t i = 0; i < uniform.pixelCount(); ++i) {
            if (adaptive.sampleCount[i] != static_cast<float>(n)) continue;
            for (size_t b = 0; b < 31; ++b, ++compared)
                ASSERT_EQ(adaptive.spectrum.radiance[i * 31 + b], uniform.spectrum.radiance[i * 31 + b]) << n << " samples, pixel " << i;
        }
    }
    EXPECT_GT(compared, 0u);
}

/// One kernel that loops, path by path, is the reference for the stages.
TEST(SpectralFilm, TheLoopGivesTheSameBits) {
    const PackedScene scene = smallRoom();
    RenderSetup setup;
    setup.contraction = false;
    expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), "loop");
}

}  // namespace
}  // namespace eikonal
