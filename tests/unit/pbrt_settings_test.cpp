// Cameras, films, filters, samplers and integrators. The defaults are those of pbrt-v4's source (cameras.cpp, film.cpp,
// filters.cpp, samplers.cpp, cpu/integrators.cpp).

#include "kinds/integrator_kind.h"
#include "kinds/filter_kind.h"
#include "kinds/camera_kind.h"
#include "pack/camera.h"
#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class PbrtSettings : public PbrtTest {
protected:
    Scene settings(const std::string& text) { return read(text + "\nWorldBegin"); }
    std::string errorOfSettings(const std::string& text) { return errorOf(text + "\nWorldBegin"); }
    FilterDescription filter(const std::string& kind) { return settings("PixelFilter \"" + kind + "\"").filter; }
    SamplerDescription sampler(const std::string& text) { return settings("Sampler " + text).sampler; }
};

TEST_F(PbrtSettings, aSceneThatSetsNothing) {
    const Scene scene = settings("");
    EXPECT_EQ(scene.name, "test");
    EXPECT_EQ(&kindOf(scene.camera), &kindOf(camera_perspective));
    EXPECT_EQ(scene.camera.fov, 90);
    EXPECT_EQ(scene.camera.lensRadius, 0);
    EXPECT_EQ(scene.film.width, 1280);
    EXPECT_EQ(scene.film.height, 720);
    EXPECT_EQ(scene.film.sensor, "cie1931");
    EXPECT_EQ(scene.film.exposureTime, 1);
    EXPECT_EQ(scene.filter.kind, &gaussian_filter);
    EXPECT_EQ(scene.filter.xRadius, 1.5);
    EXPECT_EQ(scene.sampler.kind, SamplerKind::zsobol);
    EXPECT_EQ(scene.sampler.pixelSamples, 16);
    EXPECT_EQ(scene.integrator.maxDepth, 5);
}

TEST_F(PbrtSettings, cameras) {
    const CameraDescription camera = settings(R"(Camera "perspective" "float fov" 40 "float frameaspectratio" 2 "float lensradius" .1
        "float focaldistance" 7 "float shutteropen" .25 "float shutterclose" .75)").camera;
    EXPECT_EQ(camera.fov, 40);
    EXPECT_EQ(camera.frameAspectRatio, 2);
    EXPECT_FALSE(camera.screenWindow.has_value());
    EXPECT_EQ(camera.lensRadius, .1);
    EXPECT_EQ(camera.focalDistance, 7);
    EXPECT_EQ(camera.shutterClose, .75);
    const CameraDescription flat = settings("Camera \"orthographic\" \"float screenwindow\" [-1 2 -3 4]").camera;
    EXPECT_EQ(&kindOf(flat), &kindOf(camera_orthographic));
    EXPECT_EQ(flat.screenWindow, (std::array<double, 4>{-1, 2, -3, 4}));
    EXPECT_EQ(flat.focalDistance, 1e6);
    EXPECT_THAT(errorOfSettings("Camera \"orthographic\" \"float screenwindow\" [-1 2]"), HasSubstr("has 2 values; 4 are expected"));
    EXPECT_THAT(errorOfSettings("Camera \"orthographic\" \"float shutteropen\" 1"), HasSubstr("the shutter closes when it opens, at 1"));
    const CameraDescription swapped = settings("Camera \"orthographic\" \"float shutteropen\" 2").camera;
    EXPECT_EQ(swapped.shutterOpen, 1);
    EXPECT_EQ(swapped.shutterClose, 2);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("the shutter closes at 1, before it opens at 2; the two are swapped")));
}

TEST_F(PbrtSettings, anEarlierOneIsNamed) {
    const Scene scene = settings("Film \"rgb\" \"integer xresolution\" 10\nFilm \"rgb\" \"integer xresolution\" 20");
    EXPECT_EQ(scene.film.width, 20);
    EXPECT_THAT(warnings_, ElementsAre("test.pbrt:2:1: warning: film \"rgb\" replaces film \"rgb\", given at test.pbrt:1:1"));
}

// In single precision, 0.55 of 100 is 55 and 0.28 of 100 is 28; in double precision both are a little more.
TEST_F(PbrtSettings, cropWindowsAreRoundedAsInPbrt) {
    Diagnostics diagnostics(LogLevel::silent, false);
    const FilmDescription film = settings(
        "Film \"rgb\" \"integer xresolution\" 100 \"integer yresolution\" 100 \"float cropwindow\" [0 .55 .28 1]").film;
    const PixelRect pixels = renderedPixels(film, diagnostics);
    EXPECT_EQ(pixels.x1, 55);
    EXPECT_EQ(pixels.y0, 28);
    EXPECT_EQ(pixels.y1, 100);
}

TEST_F(PbrtSettings, theCamerasMediumMayBeMadeLater) {
    const Scene scene =
        read("MediumInterface \"\" \"fog\" Camera \"perspective\" WorldBegin MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"");
    EXPECT_EQ(scene.camera.medium, 0);
}

TEST_F(PbrtSettings, films) {
    const FilmDescription film = settings(R"(ColorSpace "rec2020"
        Film "rgb" "integer xresolution" 200 "integer yresolution" [100] "string filename" "a.exr" "float iso" 400
            "string sensor" "nikon_d850"
        "float whitebalance" 5000 "float maxcomponentvalue" 10 "float diagonal" 20 "bool savefp16" false
        Camera "perspective" "float shutterclose" .5)")
                                     .film;
    EXPECT_EQ(film.width, 200);
    EXPECT_EQ(film.height, 100);
    EXPECT_EQ(film.filename, "a.exr");
    EXPECT_EQ(film.iso, 400);
    EXPECT_EQ(film.exposureTime, .5);
    EXPECT_EQ(film.whiteBalance, 5000);
    EXPECT_EQ(film.sensor, "nikon_d850");
    EXPECT_EQ(film.colorSpace, ColorSpace::rec2020);
    EXPECT_EQ(film.maxComponentValue, 10);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_EQ(film.gbuffer, GBuffer::none);
    EXPECT_EQ(settings("Film \"gbuffer\"").film.gbuffer, GBuffer::cameraSpace);
    EXPECT_EQ(settings("Film \"gbuffer\" \"string coordinatesystem\" \"world\"").film.gbuffer, GBuffer::worldSpace);
    EXPECT_THAT(errorOfSettings("Film \"gbuffer\" \"string coordinatesystem\" \"screen\""), HasSubstr("\"camera\" or \"world\""));
    EXPECT_THAT(errorOfSettings("Film \"rgb\" \"float whitebalance\" 32"),
                HasSubstr("a temperature in kelvin of at least 100, or 0 for none"));
    EXPECT_THAT(errorOfSettings("Film \"rgb\" \"string sensor\" \"leica\""), HasSubstr("it can be canon_eos_100d, "));
    EXPECT_THAT(errorOfSettings("Film \"rgb\" \"string sensor\" \"nikon_d85\""), HasSubstr("did you mean \"nikon_d850\"?"));
    EXPECT_THAT(errorOfSettings("Film \"rgb\" \"integer xresolution\" 0"), HasSubstr("it needs at least one"));
}

TEST_F(PbrtSettings, aFilmMayKeepASpectrum) {
    EXPECT_FALSE(settings("Film \"rgb\"").film.spectrum.has_value());
    const FilmDescription plain = settings("Film \"spectral\"").film;
    ASSERT_TRUE(plain.spectrum.has_value());
    EXPECT_EQ(plain.spectrum->buckets, 16);
    EXPECT_EQ(plain.spectrum->first, 360);
    EXPECT_EQ(plain.spectrum->last, 830);
    const FilmDescription film = settings(
                                     "Film \"spectral\" \"integer nbuckets\" 31 \"float lambdamin\" 400 \"float lambdamax\" 710 \"float "
                                     "iso\" 200 \"float maxcomponentvalue\" 9")
                                     .film;
    EXPECT_EQ(film.spectrum->buckets, 31);
    EXPECT_EQ(film.spectrum->first, 400);
    EXPECT_EQ(film.spectrum->last, 710);
    EXPECT_EQ(film.iso, 200);
    EXPECT_EQ(film.maxComponentValue, 9);
    EXPECT_EQ(film.gbuffer, GBuffer::none);
    EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(PbrtSettings, cropsAreSortedAndClamped) {
    const FilmDescription film = settings("Film \"rgb\" \"float cropwindow\" [.75 -1 .25 .5]").film;
    EXPECT_EQ(film.cropWindow, (std::array<double, 4>{0, .75, .25, .5}));
    const FilmDescription bounds = settings("Film \"rgb\" \"integer xresolution\" 100 \"integer pixelbounds\" [-5 500 10 20]").film;
    EXPECT_EQ(bounds.pixelBounds->x0, 0);
    EXPECT_EQ(bounds.pixelBounds->x1, 100);
    EXPECT_EQ(bounds.pixelBounds->y0, 10);
    EXPECT_EQ(bounds.pixelBounds->y1, 20);
    EXPECT_THAT(errorOfSettings("Film \"rgb\" \"integer pixelbounds\" [5 5 0 1]"), HasSubstr("has no pixel of the image"));
    // Both: the crop window counts, as in pbrt-v4.
    EXPECT_FALSE(settings("Film \"rgb\" \"integer pixelbounds\" [0 5 0 5] \"float cropwindow\" [0 1 0 1]").film.pixelBounds.has_value());
    EXPECT_EQ(warnings_.size(), 1u);
}

TEST_F(PbrtSettings, filtersHaveRadiiOfTheirOwn) {
    EXPECT_EQ(filter("box").xRadius, .5);
    EXPECT_EQ(filter("triangle").yRadius, 2);
    EXPECT_EQ(filter("gaussian").xRadius, 1.5);
    EXPECT_EQ(filter("gaussian").sigma, .5);
    EXPECT_EQ(filter("mitchell").xRadius, 2);
    EXPECT_NEAR(filter("mitchell").B, 1. / 3, 1e-7);
    EXPECT_NEAR(filter("mitchell").C, 1. / 3, 1e-7);
    EXPECT_EQ(filter("sinc").xRadius, 4);
    EXPECT_EQ(filter("sinc").tau, 3);
    EXPECT_THAT(errorOfSettings("PixelFilter \"box\" \"float xradius\" 0"), HasSubstr("must be in (0, inf)"));
}

TEST_F(PbrtSettings, samplers) {
    for (const char* kind : {"zsobol", "paddedsobol", "sobol", "halton", "pmj02bn", "stratified"}) {
        const bool blue = kind == std::string("zsobol") || kind == std::string("pmj02bn");
        const SamplerKind ofPixels = kind == std::string("paddedsobol") ? SamplerKind::paddedsobol : SamplerKind::sobol;
        EXPECT_EQ(sampler('"' + std::string(kind) + '"').pixelSamples, 16) << kind;
        EXPECT_EQ(sampler('"' + std::string(kind) + '"').kind, blue ? SamplerKind::zsobol : ofPixels) << kind;
    }
    EXPECT_EQ(sampler("\"independent\"").pixelSamples, 4);
    EXPECT_EQ(sampler("\"independent\"").kind, SamplerKind::independent);
    EXPECT_EQ(sampler("\"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5").pixelSamples, 15);
    EXPECT_EQ(sampler("\"zsobol\" \"integer pixelsamples\" 64 \"integer seed\" 5").seed, 5);
    EXPECT_THAT(errorOfSettings("Sampler \"halton\" \"integer pixelsamples\" 0"), HasSubstr("a pixel has 0 samples"));
    EXPECT_THAT(errorOfSettings("Sampler \"stratified\" \"integer xsamples\" 100000 \"integer ysamples\" 100000"),
                HasSubstr("10000000000 samples"));
}

TEST_F(PbrtSettings, integrators) {
    const auto read = [&](const std::string& directive) { return settings("Integrator " + directive).integrator; };
    EXPECT_EQ(settings("").integrator.kind, &volpath_integrator);
    EXPECT_EQ(read("\"volpath\" \"integer maxdepth\" 100").maxDepth, 100);
    EXPECT_EQ(read("\"path\" \"string lightsampler\" \"bvh\" \"bool regularize\" false").maxDepth, 5);
    EXPECT_TRUE(read("\"path\" \"bool regularize\" true").regularize);
    for (const IntegratorKind* kind : integratorKindList()) {
        EXPECT_EQ(read('"' + std::string(kind->name) + '"').kind, kind) << kind->name;
        EXPECT_EQ(read('"' + std::string(kind->name) + '"').standsFor.name, "") << kind->name;
    }
    EXPECT_EQ(read("\"simplevolpath\"").kind, &volpath_integrator);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(errorOfSettings("Integrator \"path\" \"integer maxdepth\" -1"), HasSubstr("it must be in [0, inf)"));
}

TEST_F(PbrtSettings, parametersOfIntegrators) {
    const auto read = [&](const std::string& directive) { return settings("Integrator " + directive).integrator; };
    EXPECT_TRUE(read("\"simplepath\"").sampleLights && read("\"simplepath\"").sampleBsdf);
    EXPECT_FALSE(read("\"simplepath\" \"bool samplelights\" false").sampleLights ||
                 read("\"simplepath\" \"bool samplebsdf\" false").sampleBsdf);
    EXPECT_TRUE(read("\"ambientocclusion\"").cosine);
    EXPECT_EQ(read("\"ambientocclusion\"").maxDistance, 0);
    EXPECT_FALSE(read("\"ambientocclusion\" \"bool cossample\" false").cosine);
    EXPECT_EQ(read("\"ambientocclusion\" \"float maxdistance\" 2.5").maxDistance, 2.5);
    EXPECT_EQ(settings("ColorSpace \"rec2020\" Integrator \"ambientocclusion\"").integrator.colorSpace, ColorSpace::rec2020);
    const IntegratorDescription tree = read("\"whitted\" \"integer rays\" 64 \"integer bundle\" 0 \"float threshold\" 0.1");
    EXPECT_EQ(tree.rays, 64);
    EXPECT_EQ(tree.bundle, 0);
    EXPECT_EQ(tree.threshold, 0.1);
    EXPECT_THAT(warnings_, IsEmpty());
    for (const char* rays : {"0", "3", "128", "-2"})
        EXPECT_THAT(errorOfSettings("Integrator \"whitted\" \"integer rays\" " + std::string(rays)),
                    HasSubstr("a power of two from 1 to 64"));
    EXPECT_THAT(errorOfSettings("Integrator \"whitted\" \"integer bundle\" 5"),
                HasSubstr("test.pbrt:1:22: \"integer bundle\" is 5; it must be 0 or a power of two from 1 to 64"));
    EXPECT_THAT(errorOfSettings("Integrator \"ambientocclusion\" \"float maxdistance\" 0"), HasSubstr("(0, inf)"));
    EXPECT_THAT(errorOfSettings("Integrator \"directlighting\""), HasSubstr("\"direct\""));
}

/// That another one is rendered is said when it is known that it is: tests/unit/pack_test.cpp.
TEST_F(PbrtSettings, integratorsThatAreNotRenderedAreRemembered) {
    for (const auto& [name, instead] :
         {std::pair("mlt", &vcm_integrator), {"lightpath", &bdpt_integrator}, {"function", &volpath_integrator}}) {
        const IntegratorDescription read = settings("Integrator \"" + std::string(name) + "\" \"integer maxdepth\" 7").integrator;
        EXPECT_EQ(read.standsFor.name, name);
        EXPECT_EQ(read.kind, instead);
        EXPECT_EQ(read.maxDepth, 7);
    }
    EXPECT_THAT(warnings_, IsEmpty());
}

/// In world units; 0: chosen for the scene. Photons are counted otherwise than in pbrt, which is said.
TEST_F(PbrtSettings, theRadiusOfMergingIsRead) {
    EXPECT_EQ(settings("Integrator \"sppm\" \"float radius\" .5").integrator.mergeRadius, .5);
    EXPECT_EQ(settings("Integrator \"vcm\" \"float radius\" 2").integrator.mergeRadius, 2);
    EXPECT_EQ(settings("Integrator \"sppm\"").integrator.mergeRadius, 0);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(errorOfSettings("Integrator \"sppm\" \"float radius\" 0"), HasSubstr("(0, inf)"));
    settings("Integrator \"sppm\" \"integer photonsperiteration\" 1000");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("one light path for each pixel and sample")));
}

TEST_F(PbrtSettings, theLastOfASortCounts) {
    const Scene scene =
        settings("PixelFilter \"sinc\" PixelFilter \"box\" Camera \"orthographic\" Camera \"perspective\" \"float fov\" 20");
    EXPECT_EQ(scene.filter.kind, &box_filter);
    EXPECT_EQ(scene.filter.xRadius, .5);
    EXPECT_EQ(&kindOf(scene.camera), &kindOf(camera_perspective));
    EXPECT_EQ(scene.camera.fov, 20);
}

}  // namespace
}  // namespace eikonal
