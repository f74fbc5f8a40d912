#include "rendering.h"

#include "kind_features.h"
#include "default_settings.h"
#include "device/cache.h"
#include "kinds/medium_kind.h"
#include "pack/color_mode.h"
#include "pack/environment_guide.h"
#include "render/path_loop.h"
#include "render/path_guide_pilot.h"
#include "render/roulette_pilot.h"
#include "render/survey.h"
#include "render/wave.h"
#include "read/pbrt/read_pbrt.h"
#include "test_paths.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace eikonal {

/// Beside the program, as for the tests that run it.
static std::string cacheFolder() { return std::filesystem::path(EIKONAL_BINARY).parent_path() / "test-cache"; }

const Context& device() {
    static const Context context([] {
        ::setenv("POCL_CACHE_DIR", (cacheFolder() + "/pocl").c_str(), 0);   // kept from test to test
        preparePocl(cacheFolder());
        if (const char* wanted = std::getenv("EIKONAL_TEST_DEVICE")) return chooseDevice(wanted);
        return chooseDevice("Portable Computing Language");
    }());
    return context;
}

Compiler& compiler() {
    static Compiler compiler(device(), findKernelFolders(), cacheFolder());
    return compiler;
}

std::string sceneText(const View& view, const std::string& world) {
    const std::string defaults = fmt::format(
        "LookAt {}\nCamera \"perspective\" \"float fov\" {}\nFilm \"rgb\" \"integer xresolution\" {} \"integer yresolution\" {}\n"
        "PixelFilter \"box\"\nSampler \"{}\" \"integer pixelsamples\" {}\nIntegrator \"volpath\" \"integer maxdepth\" {}\n",
        view.lookAt, view.fov, view.width, view.height, view.sampler, view.samples, view.maxDepth);
    return fmt::format("{}{}\nWorldBegin\n{}\n", defaultSettings(defaults, view.more), view.more, world);
}

PackedScene packScene(const std::string& text, ColorMode color, Warnings warnings) {
    Diagnostics diagnostics(LogLevel::silent, warnings == Warnings::refused);
    Scene scene = readPbrtText(text, "test.pbrt", ".", diagnostics);
    scene.colorMode = color == ColorMode::automatic && needOfWavelengths(scene).empty() ? ColorMode::rgb : color;
    PackedScene packed = packScene(scene, diagnostics);
    if (warnings == Warnings::refused && !diagnostics.warnings().empty())
        throw std::invalid_argument("the scene of a test gives a warning: " + diagnostics.warnings().front());
    return packed;
}

static Features mediumKindFeatures() {
    Features features;
    for (const MediumKind& e : mediumKindList()) features.require(e.feature);
    return features;
}

Features surfaceFeatures() {
    using enum Feature;
    const Features others = mediumKindFeatures()
                                .require(KindFeature::SHAPE_CURVE)
                                .require(STRIPS)
                                .require(KindFeature::SHAPE_IMPLICIT)
                                .require(KindFeature::LIGHT_IMPLICIT)
                                .require(SPECTRAL)
                                .require(SPECTRAL_FILM)
                                .require(DISPERSION)
                                .require(MEDIA)
                                .require(AOVS)
                                .require(MOTION_VECTORS)
                                .require(RENDER_PASSES)
                                .require(LIGHT_GROUPS)
                                .require(SOBOL)
                                .require(JOINT_PAIRS)
                                .require(AMBIENT_OCCLUSION)
                                .require(RAY_SPLITTING)
                                .require(UNIFORM_DIRECTIONS)
                                .require(FORCE_DIFFUSE)
                                .require(LIGHT_PATHS)
                                .require(CONNECTIONS)
                                .require(MERGING)
                                .require(LENS)
                                .require(FILTER)
                                .require(BUMP)
                                .require(NORMAL_MAP)
                                .require(KindFeature::CAMERA_ORTHOGRAPHIC)
                                .require(KindFeature::CAMERA_SPHERICAL)
                                .require(KindFeature::CAMERA_REALISTIC)
                                .require(APERTURE)
                                .require(CAMERA_MOTION)
                                .require(MOTION)
                                .require(KindFeature::LIGHT_IMAGE_INFINITE)
                                .require(KindFeature::TEXTURE_IMAGEMAP)
                                .require(KindFeature::TEXTURE_FBM)
                                .require(KindFeature::TEXTURE_WRINKLED)
                                .require(KindFeature::TEXTURE_WINDY)
                                .require(KindFeature::TEXTURE_MARBLE);
    Features features;
    for (size_t i = 0; i < featureCount(); ++i)
        if (!others.has(static_cast<Feature>(i))) features.require(static_cast<Feature>(i));
    return features;
}
Features mediumFeatures() {
    using enum Feature;
    return surfaceFeatures().require(MEDIA) | mediumKindFeatures();
}
static RenderSetup forcing(const Features& features) {
    RenderSetup setup;
    setup.forced = features;
    return setup;
}
RenderSetup surfaces() { return forcing(surfaceFeatures()); }
RenderSetup media() { return forcing(mediumFeatures()); }

/// Straight-line code for kinds that a scene has none of still reads a first element; what it makes of it is not used.
static void fillEmptyTables(SceneTables& tables) {
    constexpr size_t elements = 1024;
#define FILL_IF_EMPTY(type, name) if (tables.name.empty()) tables.name.resize(elements);
    SCENE_TABLES(FILL_IF_EMPTY)
#undef FILL_IF_EMPTY
}

Rendered render(PackedScene scene, const RenderSetup& setup) {
    if (setup.edit) setup.edit(scene);
    const Features built = scene.features | setup.forced;
    if (built.has(Feature::ENVIRONMENT_GUIDE) && scene.tables.guide_maps.empty()) packUnlearnedGuide(scene.tables);
    if (!(built == scene.features)) fillEmptyTables(scene.tables);
    if (setup.allStages) scene.features = built;

    BuildSettings settings;
    settings.features = setup.forced;
    settings.contraction = setup.contraction;
    DeviceScene onDevice(device(), scene);
    Profile profile;
    Stages stages(compiler(), scene, setup.shape, settings);
    Wave wave(device(), onDevice, scene, stages, setup.shape, profile);
    wave.warmUp();
    stages.keep(compiler());
    surveyEnvironment(device(), onDevice, scene, stages, setup.shape);
    const LearnedPathGuide guide = pilotPathGuide(device(), onDevice, scene, wave);
    if (!guide.isEmpty() && !scene.roulette) {
        scene.roulette = guidedRoulette;
        setRoulette(scene.frame(), guidedRoulette);
        onDevice.setFrame(device(), scene.frame());
    }
    const Roulette roulette = pilotRoulette(device(), onDevice, scene, wave).value_or(scene.roulette.value_or(Roulette()));

    Film film(scene, built);
    std::vector<unsigned> ends = setup.splits;
    ends.push_back(static_cast<unsigned>(scene.samples));
    RenderControl control;
    control.targetError = setup.targetError;
    if (setup.batches) control.stop = [left = *setup.batches]() mutable { return left-- == 0; };
    RenderResult result;
    for (unsigned end : ends) {
        control.endSample = end;
        result = render(std::vector{RenderDevice{&device(), &wave, &profile}}, film, control);
    }
    const FilmTotals totals = film.totals();
    return {totals.develop(scene),
            totals.invalid(),
            result,
            roulette,
            totals.error(ErrorMetric::mseRoot),
            totals.error(ErrorMetric::relmseRoot),
            guide.gain.value_or(1)};
}

FilmImage renderInLoop(const PackedScene& scene, const RenderSetup& setup) {
    BuildSettings settings;
    settings.contraction = setup.contraction;
    const DeviceScene onDevice(device(), scene);
    Profile profile;
    PathLoop loop(device(), compiler(), onDevice, scene, setup.shape, settings, profile);
    Film film(scene);
    RenderControl control;
    control.endSample = static_cast<unsigned>(scene.samples);
    control.targetError = setup.targetError;
    render(std::vector{RenderDevice{&device(), &loop, &profile}}, film, control);
    return film.totals().develop(scene);
}

Estimate estimate(const FilmImage& image) {
    glm::dvec3 sum(0), squares(0);
    const double n = static_cast<double>(image.color.size());
    for (const glm::vec3& c : image.color) sum += glm::dvec3(c);
    const glm::dvec3 mean = sum / n;
    for (const glm::vec3& c : image.color) squares += (glm::dvec3(c) - mean) * (glm::dvec3(c) - mean);
    return {mean, glm::sqrt(squares / (n * (n - 1)))};
}

static constexpr const char* channels = "RGB";
constexpr double rounding = 1e-5;

void expectRadiance(const Rendered& rendered, glm::dvec3 expected, double resolution) {
    const Estimate e = estimate(rendered.image);
    EXPECT_EQ(rendered.invalid.count, 0u);
    for (int c = 0; c < 3; ++c) {
        EXPECT_LE(std::abs(e.mean[c] - expected[c]), standardErrors * e.error[c] + rounding * expected[c])
            << channels[c] << " is " << e.mean[c] << " +- " << e.error[c] << ", not " << expected[c];
        EXPECT_LE(e.error[c], resolution * expected[c]) << "too few samples to tell";
    }
}

void expectEqualMeans(const Rendered& a, const Rendered& b, double resolution) {
    const Estimate x = estimate(a.image), y = estimate(b.image);
    EXPECT_EQ(a.invalid.count + b.invalid.count, 0u);
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(x.error[c], y.error[c]);
        EXPECT_LE(std::abs(x.mean[c] - y.mean[c]), standardErrors * error + rounding * x.mean[c])
            << channels[c] << " is " << x.mean[c] << " and " << y.mean[c] << ", +- " << error;
        EXPECT_LE(error, resolution * x.mean[c]) << "too few samples to tell";
    }
}

void expectSameBits(const FilmImage& a, const FilmImage& b, const std::string& what) {
    size_t compared = 0, different = 0;
    std::string first;
    for (int y = std::max(a.bounds.y0, b.bounds.y0); y < std::min(a.bounds.y1, b.bounds.y1); ++y)
        for (int x = std::max(a.bounds.x0, b.bounds.x0); x < std::min(a.bounds.x1, b.bounds.x1); ++x) {
            const size_t i = a.index(x, y), j = b.index(x, y);
            const auto bits = [](const FilmImage& f, size_t k) {
                return std::array{std::bit_cast<std::uint32_t>(f.color[k].r), std::bit_cast<std::uint32_t>(f.color[k].g),
                                  std::bit_cast<std::uint32_t>(f.color[k].b), std::bit_cast<std::uint32_t>(f.variance[k]),
                                  std::bit_cast<std::uint32_t>(f.sampleCount[k])};
            };
            ++compared;
            if (bits(a, i) == bits(b, j)) continue;
            if (!different++)
                first = fmt::format("({}, {}): {:.9g} {:.9g} {:.9g} and {:.9g} {:.9g} {:.9g}", x, y, a.color[i].r, a.color[i].g,
                                    a.color[i].b, b.color[j].r, b.color[j].g, b.color[j].b);
        }
    size_t otherChannels = 0;
    for (const auto& [x, y] :
         {std::pair(&a.albedo, &b.albedo), {&a.normal, &b.normal}, {&a.geometricNormal, &b.geometricNormal}, {&a.position, &b.position},
          {&a.emission, &b.emission}, {&a.direct, &b.direct}, {&a.indirect, &b.indirect}, {&a.volume, &b.volume}})
        for (size_t i = 0; x->size() == y->size() && i < x->size(); ++i) otherChannels += (*x)[i] != (*y)[i];
    for (const auto& [x, y] : {std::pair(&a.motion, &b.motion), {&a.uv, &b.uv}, {&a.depthSlope, &b.depthSlope}})
        for (size_t i = 0; x->size() == y->size() && i < x->size(); ++i) otherChannels += (*x)[i] != (*y)[i];
    for (const auto& [x, y] : {std::pair(&a.depth, &b.depth), {&a.object, &b.object}, {&a.material, &b.material}})
        for (size_t i = 0; x->size() == y->size() && i < x->size(); ++i) otherChannels += (*x)[i] != (*y)[i];
    for (size_t i = 0; a.pixelCount() == b.pixelCount() && i < std::min(a.spectrum.radiance.size(), b.spectrum.radiance.size()); ++i)
        otherChannels += std::bit_cast<std::uint32_t>(a.spectrum.radiance[i]) != std::bit_cast<std::uint32_t>(b.spectrum.radiance[i]);
    EXPECT_EQ(a.spectrum.wavelengths, b.spectrum.wavelengths) << what;
    for (size_t group = 0; group < std::min(a.lightGroups.size(), b.lightGroups.size()); ++group) {
        const auto &x = a.lightGroups[group].color, &y = b.lightGroups[group].color;
        for (size_t i = 0; x.size() == y.size() && i < x.size(); ++i) otherChannels += x[i] != y[i];
    }
    EXPECT_EQ(otherChannels, 0u) << what << ": values of other channels";
    EXPECT_GT(compared, 0u) << what;
    EXPECT_EQ(different, 0u) << what << ": of " << compared << " pixels; the first is " << first;
}

void expectSameBitsInWavesAndParts(const PackedScene& scene, const PixelRect& pixels) {
    const FilmImage whole = render(scene).image;
    RenderSetup smaller;
    smaller.shape.wavePaths = 4096;
    expectSameBits(whole, render(scene, smaller).image, "smaller waves");
    PackedScene part = scene;
    part.pixels = pixels;
    expectSameBits(whole, render(part).image, "a part of the image");
}

void expectFinite(const Rendered& rendered, const std::string& what) {
    EXPECT_EQ(rendered.invalid.count, 0u) << what << ": invalid samples, the first in pixel (" << rendered.invalid.x << ", "
                                          << rendered.invalid.y << ")";
    size_t bad = 0;
    for (const glm::vec3& c : rendered.image.color)
        for (int k = 0; k < 3; ++k) bad += !(c[k] >= 0 && std::isfinite(c[k]));
    EXPECT_EQ(bad, 0u) << what << ": values that are negative, infinite or not a number";
}

}  // namespace eikonal
