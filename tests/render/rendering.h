#pragma once
// Scenes given as text, rendered in the test's own process, and what can be said about the images.

#include "image/film_image.h"
#include "pack/pack.h"
#include "render/render.h"
#include "render/stages.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// What a test's scene looks like before WorldBegin. Filter: a box of one pixel.
struct View {
    std::string lookAt = "0 0 -4  0 0 0  0 1 0";  ///< eye, what it looks at, what is up
    double fov = 0.02;                            ///< degrees; so narrow that every pixel sees the same point
    int width = 16, height = 16, samples = 256, maxDepth = 5;
    std::string sampler = "independent";
    std::string more;                             ///< directives between LookAt and WorldBegin
};
std::string sceneText(const View& view, const std::string& world);

/// How a scene is rendered. Nothing here changes what the image is to be.
struct RenderSetup {
    Features forced;                   ///< kernels are built with these as well ...
    bool allStages = false;            ///< ... and stages that only they ask for are built and run
    bool contraction = true;
    StageShape shape = smallWaves();
    std::optional<double> targetError; ///< adaptive sampling, the scene's samples being the most
    std::optional<unsigned> batches;   ///< after so many batches of paths the render is ended
    std::vector<unsigned> splits;      ///< rendered in ranges of samples that end at these, then at the last one
    std::function<void(PackedScene&)> edit;   ///< changes the tables before they go to the device

    static StageShape smallWaves() { StageShape s; s.wavePaths = 16384; return s; }
};

/// Features of all that tests of derived values use but participating media, and with them. With the same features forced everywhere,
/// these tests share their kernels: each is compiled once.
Features surfaceFeatures();
Features mediumFeatures();
RenderSetup surfaces();
RenderSetup media();

struct Rendered {
    FilmImage image;
    FilmTotals::Invalid invalid;
    RenderResult result;
    Roulette roulette;
    ErrorEstimate error;           ///< absolute: ErrorMetric::mseRoot
    ErrorEstimate relativeError;   ///< ErrorMetric::relmseRoot
    double guideGain = 1;  ///< of an optional path guide (LearnedPathGuide::gain)
};

enum class Warnings { refused, allowed };

/// The scene of a pbrt text; throws for whatever the reader or the packer complains about, of warnings where they are refused. automatic:
/// in RGB, unless spectra are given: tests often use colours as saturated as can be.
PackedScene packScene(const std::string& text, ColorMode color = ColorMode::automatic, Warnings warnings = Warnings::refused);
/// Renders on the tests' device (device(), below).
Rendered render(PackedScene scene, const RenderSetup& setup = {});
inline Rendered render(const std::string& text, const RenderSetup& setup = {}) { return render(packScene(text), setup); }
/// The same samples, each path followed by one kernel that loops (kernels/stages/loop.cl): the reference for the stages. Heeds contraction,
/// shape and targetError alone.
FilmImage renderInLoop(const PackedScene& scene, const RenderSetup& setup);

/// Mean over all pixels and its standard error, by channel, from how the pixels differ: they are independent estimates.
struct Estimate { glm::dvec3 mean{0}, error{0}; };
Estimate estimate(const FilmImage& image);

/// Significance of all statistical tests here: a right program fails one in 16,000 channels, and with its fixed seeds always or never.
constexpr double standardErrors = 4;

/// Holds an image whose pixels all have the expectation `expected` to it: within 4 standard errors and what floats round (1e-5 of it).
/// The test has to have a chance to see an error of `resolution`: standard errors above that fail as well. No sample may be invalid.
void expectRadiance(const Rendered& rendered, glm::dvec3 expected, double resolution = 0.01);
inline void expectRadiance(const Rendered& rendered, double expected, double resolution = 0.01) {
    expectRadiance(rendered, glm::dvec3(expected), resolution);
}
/// The same of two images with the same unknown expectation.
void expectEqualMeans(const Rendered& a, const Rendered& b, double resolution = 0.01);
/// Holds two images to the same bits in colour, variance and number of samples, in all pixels that both have; and those of the same
/// size in what further channels both have.
void expectSameBits(const FilmImage& a, const FilmImage& b, const std::string& what);
/// The image in smaller waves, and a part of it rendered alone, have the bits of the whole.
void expectSameBitsInWavesAndParts(const PackedScene& scene, const PixelRect& part);
/// No pixel is negative, infinite or not a number, and no sample was.
void expectFinite(const Rendered& rendered, const std::string& what);

/// The device of all render tests: PoCL's first, or $EIKONAL_TEST_DEVICE.
const Context& device();
/// Builds programs for it, with a cache that tests share.
Compiler& compiler();

}  // namespace eikonal
