// Integrators other than path tracing: values that can be derived, what must be the same image, and that no bit depends on how a tree of
// rays is laid over the device.

#include "rendering.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace eikonal {
namespace {

/// `integrator`: what follows the directive.
View view(const std::string& integrator) {
    View v;
    v.more = "Integrator " + integrator;
    return v;
}
/// With the same features in all tests of a group, kernels are compiled once.
RenderSetup with(const Features& features) {
    RenderSetup setup;
    setup.contraction = false;
    setup.forced = features;
    return setup;
}

/// A rectangle across the z axis, or beside it.
std::string across(double z, double size = 1000) {
    return fmt::format("Shape \"bilinearmesh\" \"point3 P\" [{0} {0} {2}  {1} {0} {2}  {0} {1} {2}  {1} {1} {2}]\n", -size, size, z);
}

// ---- ambient occlusion --------------------------------------------------------------------------------------------------

Rendered renderOcclusion(const std::string& parameters, const std::string& world) {
    return render(sceneText(view("\"ambientocclusion\" " + parameters), world));
}

/// Nothing is in the way of a plane. With directions by the cosine there is no noise either. What the plane is made of, what it emits and
/// which lights there are does not matter.
TEST(AmbientOcclusion, APlaneUnderTheSkyIsOpen) {
    for (const std::string material : {"Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]\n",
                                       "Material \"conductor\" AreaLightSource \"diffuse\" LightSource \"point\"\n"}) {
        const Rendered r = renderOcclusion("", material + across(0));
        expectRadiance(r, 1, 1e-6);
    }
    expectRadiance(renderOcclusion("\"bool cossample\" false", across(0)), 1);
}

/// A wall beside the point, one unit away and sqrt(3) high, hides what is less than 60 degrees above the plane on its side: by the form
/// factor of a strip, (1 - cos 60) / 2 of the light. Of a wall without end, what is less than 2 away is in directions within 60 degrees of
/// the wall's normal: by Nusselt's analogue a segment of the unit disk, (acos(1/2) - sqrt(3)/4) / pi.
TEST(AmbientOcclusion, AWallHidesItsFormFactor) {
    const auto wall = [](double height) {
        return across(0) + fmt::format("Shape \"bilinearmesh\" \"point3 P\" [1 -1000 {0}  1 1000 {0}  1 -1000 0  1 1000 0]\n", -height);
    };
    const double segment = (std::acos(0.5) - std::sqrt(3) / 4) / M_PI;
    for (const char* sampling : {"\"bool cossample\" true ", "\"bool cossample\" false "}) {
        expectRadiance(renderOcclusion(sampling, wall(std::sqrt(3))), 0.75);
        expectRadiance(renderOcclusion(std::string(sampling) + "\"float maxdistance\" 2", wall(1000)), 1 - segment);
        expectRadiance(renderOcclusion(std::string(sampling) + "\"float maxdistance\" .99", wall(1000)), 1);
    }
}

/// Where nothing is seen there is no light.
TEST(AmbientOcclusion, OnlySurfacesAreSeen) {
    expectRadiance(renderOcclusion("", "Translate 0 5 0 " + across(0, 1)), 0);
}

// ---- variants of path tracing -------------------------------------------------------------------------------------------

constexpr const char* room = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 3 2] Translate 0 2 -2 Rotate 60 1 0 0 Shape "disk" "float radius" 1.5 AttributeEnd
AttributeBegin Material "conductor" "float roughness" .4 Translate 1.5 0 -1 Shape "sphere" AttributeEnd
Material "diffuse" "rgb reflectance" [.6 .5 .4]
)";

/// One scattering event, as of "path" with a depth of 1: bit by bit; and whatever depth it is given.
TEST(Direct, IsAPathOfDepthOne) {
    const auto image = [](const std::string& integrator) { return render(sceneText(view(integrator), room + across(0))).image; };
    const FilmImage path = image("\"path\" \"integer maxdepth\" 1");
    expectSameBits(path, image("\"direct\""), "direct");
    expectSameBits(path, image("\"direct\" \"integer maxdepth\" 7"), "direct with a depth");
    EXPECT_LT(estimate(path).mean.x, estimate(image("\"path\"")).mean.x);
}

/// Worse means, the same end.
TEST(SimplePath, HasTheExpectationOfPath) {
    const auto rendered = [](const std::string& integrator) { return render(sceneText(view(integrator), room + across(0))); };
    const Rendered path = rendered("\"path\" \"integer maxdepth\" 3");
    expectEqualMeans(path, rendered("\"simplepath\" \"integer maxdepth\" 3 \"bool samplelights\" false"), 0.02);
    expectEqualMeans(path, rendered("\"simplepath\" \"integer maxdepth\" 3 \"bool samplebsdf\" false"), 0.02);
    expectEqualMeans(path, rendered("\"randomwalk\" \"integer maxdepth\" 3"), 0.02);
}

// ---- trees of rays ------------------------------------------------------------------------------------------------------

/// Panes, balls, a rough metal and lamps: rays of every kind leave.
const std::string cabinet = R"(LightSource "infinite" "rgb L" [.3 .4 .5]
LightSource "point" "rgb I" [5 5 5] "point3 from" [1 3 -3]
AttributeBegin AreaLightSource "diffuse" "rgb L" [3 2 1] Translate .2 .9 -1 Shape "sphere" "float radius" .3 AttributeEnd
AttributeBegin Material "dielectric" Translate -.9 -.2 0 Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Material "conductor" "float roughness" 0 Translate .9 -.2 0 Shape "sphere" "float radius" .7 AttributeEnd
AttributeBegin Material "conductor" "float roughness" .2 Translate 0 .8 .5 Shape "sphere" "float radius" .5 AttributeEnd
AttributeBegin Material "thindielectric" Translate 0 0 -1.5 Rotate 20 0 1 0 Shape "disk" "float radius" .6 AttributeEnd
Material "diffuse" Shape "bilinearmesh" "point3 P" [-3 -1 -3  3 -1 -3  -3 -1 3  3 -1 3])";

/// Whatever that requires, in a tree or not.
RenderSetup ofCabinet(bool inTrees) {
    static const Features features = packScene(sceneText(view("\"path\""), cabinet)).features | Features().require(Feature::AOVS);
    return with(inTrees ? features | Features().require(Feature::RAY_SPLITTING) : features);
}
RenderSetup tree() { return ofCabinet(true); }
Rendered renderTree(const std::string& parameters, const std::string& world, int samples = 16) {
    View v = view("\"whitted\" " + parameters);
    v.samples = samples;
    return render(sceneText(v, world), tree());
}

/// A pane of index 1.5 reflects r = 0.04 at each of its sides, 2 r / (1 + r) in all. Through it one sees a wall (0.5) with a lamp (2) half
/// a unit before it, and in it another wall (0.8) with a lamp (9) one and a half units before it: 0.5 / pi * 2 * 4, and 0.8 / pi * 9
/// / 1.5^2.
constexpr double reflected = 0.08 / 1.04, behind = 4 / M_PI, before = 3.2 / M_PI;
std::string pane() {
    return "LightSource \"point\" \"rgb I\" [2 2 2] \"point3 from\" [0 0 .5] LightSource \"point\" \"rgb I\" [9 9 9] \"point3 from\" [0 0 "
           "-6.5]\n"
           "Material \"thindielectric\"" +
           across(0, 10) + "Material \"diffuse\"" + across(1, 10) + "Material \"diffuse\" \"rgb reflectance\" [.8 .8 .8]" + across(-8, 10);
}

/// Both rays are followed, and light comes from both lamps: one sample has it all, but for the width of the pixels.
TEST(Whitted, FollowsReflectionAndTransmission) {
    const Rendered r = renderTree("", pane());
    const Estimate e = estimate(r.image);
    EXPECT_NEAR(e.mean.x, reflected * before + (1 - reflected) * behind, 1e-4);
    EXPECT_LT(e.error.x, 1e-6);
    for (float variance : r.image.variance) EXPECT_LT(variance, 1e-9f);
}

/// Where the weights decide by chance the noise comes back, but the expectation stays.
TEST(Whitted, GoesOnAsAPathWhereItMayForkNoMore) {
    expectRadiance(renderTree("\"integer rays\" 1", pane(), 4096), reflected * before + (1 - reflected) * behind, 1e-3);
}

/// A ray that would bring less than the threshold is left out, and nothing else.
TEST(Whitted, TheThresholdTakesAwayWhatIsBelowIt) {
    EXPECT_NEAR(estimate(renderTree("\"float threshold\" .0769", pane()).image).mean.x, reflected * before + (1 - reflected) * behind,
                1e-4);
    EXPECT_NEAR(estimate(renderTree("\"float threshold\" .077", pane()).image).mean.x, (1 - reflected) * behind, 1e-4);
    expectRadiance(renderTree("\"float threshold\" .95", pane()), 0);
}

/// Among mirrors and glass the image is that of path tracing, with less noise from the same samples: pixel by pixel, the differences have a
/// mean of 0.
TEST(Whitted, HasTheExpectationOfPathsWithLessNoise) {
    const std::string world = R"(LightSource "infinite" "rgb L" [.2 .2 .2]
AttributeBegin AreaLightSource "diffuse" "rgb L" [5 2 1] Translate -3 2 -3 Shape "sphere" "float radius" 2 AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [1 4 5] Translate 2 0 4 Shape "sphere" "float radius" 2 AttributeEnd
AttributeBegin Material "conductor" "float roughness" 0 Translate 1.3 0 0 Shape "sphere" AttributeEnd
AttributeBegin Material "dielectric" Translate -.7 0 -1 Shape "sphere" "float radius" .9 AttributeEnd
Material "thindielectric")" + across(2);
    View v = view("");
    v.fov = 40;
    v.width = v.height = 24;
    v.samples = 64;
    const auto rendered = [&](const std::string& integrator, const RenderSetup& setup) {
        v.more = "Integrator " + integrator;
        return render(sceneText(v, world), setup);
    };
    const Rendered path = rendered("\"path\" \"integer maxdepth\" 6", ofCabinet(false));
    const Rendered whole = rendered("\"whitted\" \"integer maxdepth\" 6 \"integer rays\" 64 \"float threshold\" 0", tree());
    const Rendered narrow = rendered("\"whitted\" \"integer maxdepth\" 6 \"integer rays\" 2 \"float threshold\" 0", tree());
    const auto varianceOf = [](const Rendered& r) { return std::accumulate(r.image.variance.begin(), r.image.variance.end(), 0.); };
    EXPECT_LT(varianceOf(narrow), varianceOf(path));
    EXPECT_LT(varianceOf(whole), varianceOf(path) / 2);
    for (const Rendered* other : {&whole, &narrow}) {
        double sum = 0, squares = 0;
        const double n = static_cast<double>(path.image.color.size());
        for (size_t i = 0; i < path.image.color.size(); ++i) {
            const double d = other->image.color[i].x - path.image.color[i].x;
            sum += d;
            squares += d * d;
        }
        const double error = std::sqrt(squares) / n;
        EXPECT_LE(std::abs(sum / n), standardErrors * error);
        EXPECT_LT(error, 0.02 * estimate(path.image).mean.x) << "too few samples to tell";
        EXPECT_EQ(other->invalid.count, 0u);
    }
}

/// Split rays see a uniform sky in a rough metal as a path of depth 1 does, and through rough glass with its internal reflections.
TEST(Whitted, BundlesSpreadAsTheSurfaceDoes) {
    const std::string lamps =
        "LightSource \"infinite\" \"rgb L\" [1 .8 .6]\nAttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [5 5 5] Translate 0 1 -3 Shape "
        "\"sphere\" \"float radius\" .5 AttributeEnd\n";
    for (const std::string material :
         {"Material \"conductor\" \"float roughness\" .3\n", "Material \"dielectric\" \"float roughness\" .3\n"}) {
        const std::string world = lamps + material + "Shape \"sphere\"";
        const Rendered path = render(sceneText(view("\"path\" \"integer maxdepth\" 4"), world), ofCabinet(false));
        for (const char* bundle : {"4", "16"})
            expectEqualMeans(
                path, renderTree(fmt::format("\"integer maxdepth\" 4 \"float threshold\" 0 \"integer bundle\" {}", bundle), world, 128));
    }
    /* Without one there is only what comes straight from lights */
    const Rendered direct =
        render(sceneText(view("\"direct\""), lamps + "Material \"conductor\" \"float roughness\" .3 Shape \"sphere\""), ofCabinet(false));
    expectEqualMeans(
        direct, renderTree("\"integer bundle\" 0", lamps + "Material \"conductor\" \"float roughness\" .3 Shape \"sphere\"", 256), 0.02);
}

/// Where there are more lights than it looks at, or one has a portal, one of them is chosen, as for paths.
TEST(Whitted, ChoosesAmongManyLightsAndWithPortals) {
    std::string points;
    for (int i = 0; i < 20; ++i)
        points += fmt::format("LightSource \"point\" \"rgb I\" [{0} {0} 1] \"point3 from\" [{1} .3 -1.5]\n", i % 3 + 1, .2 * i - 2);
    const std::string portal =
        "LightSource \"infinite\" \"rgb L\" [2 2 2] \"point3 portal\" [-1 -1 -1  1 -1 -1  1 1 -1  -1 1 -1] LightSource \"point\" \"point3 "
        "from\" [0 0 -1]\n";
    for (const std::string& lights : {points, portal}) {
        const std::string world = lights + "Material \"diffuse\"" + across(0);
        expectEqualMeans(render(sceneText(view("\"direct\""), world), surfaces()), renderTree("", world, 256), 0.02);
    }
}

/// Albedos are gathered by the same weights.
TEST(Whitted, AlbedoIsSeenByAllRays) {
    View v = view("\"whitted\"");
    v.samples = 4;
    PackedScene scene = packScene(sceneText(v, pane()));
    scene.require(Feature::AOVS, "the test");
    const Rendered r = render(std::move(scene), tree());
    EXPECT_NEAR(r.image.albedo[3].x, reflected * 0.8 + (1 - reflected) * 0.5, 1e-4);
    EXPECT_NEAR(r.image.depth[3], 4, 1e-4);
}

class Trees : public testing::Test {
protected:
    static View cabinetView(const std::string& integrator) {
        View v = view(integrator);
        v.lookAt = "0 1 -5  0 0 0  0 1 0";
        v.fov = 40;
        v.width = 24; v.height = 20;
        v.samples = 8;
        return v;
    }
    const std::string text = sceneText(cabinetView("\"whitted\" \"integer maxdepth\" 6"), cabinet);
    const Rendered reference = render(text, tree());
};
using SlowTrees = Trees;

TEST_F(Trees, DoNotDependOnHowTheyAreLaidOut) {
    EXPECT_EQ(reference.invalid.count, 0u);
    for (unsigned rays : {1u, 64u, 1000u, 65472u}) {
        RenderSetup setup = tree();
        setup.shape.wavePaths = rays;
        expectSameBits(reference.image, render(text, setup).image, fmt::format("{} rays in a wave", rays));
    }
    RenderSetup parts = tree();
    parts.splits = {3, 4, 7};
    expectSameBits(reference.image, render(text, parts).image, "in 4 parts");
    PackedScene scene = packScene(text);
    scene.pixels = {5, 3, 18, 16};
    expectSameBits(reference.image, render(scene, tree()).image, "a crop");
}

TEST_F(SlowTrees, AreTheSameInALoop) {
    for (const char* integrator : {"\"whitted\" \"integer maxdepth\" 6", "\"ambientocclusion\" \"float maxdistance\" .5"}) {
        PackedScene scene = packScene(sceneText(cabinetView(integrator), cabinet));
        scene.require(Feature::AOVS, "the test");
        RenderSetup setup;
        setup.contraction = false;
        expectSameBits(render(scene, setup).image, renderInLoop(scene, setup), integrator);
    }
}

}  // namespace
}  // namespace eikonal
