// What each camera sees where: world positions of pixels against the camera's own formula, and what a lens lets through.

#include "rendering.h"

#include "kind_features.h"
#include "lens_file.h"
#include "pack/space.h"
#include "film/projection.h"

#include <fmt/format.h>

#include <cmath>

namespace eikonal {
namespace {

constexpr int width = 512, height = 384;
/// From the middle of a ball, whose points are 9 away.
const std::string ballAround = "LightSource \"point\" Material \"diffuse\" Shape \"sphere\" \"float radius\" 9";

/// The 4 x 4 pixels from (x, y) on.
std::string throughCamera(const std::string& camera, int x, int y, const std::string& world = ballAround, const std::string& before = "") {
    return fmt::format(
        "{}\nLookAt 0 0 0  0 0 1  0 1 0\nCamera {}\nFilm \"rgb\" \"integer xresolution\" {} \"integer yresolution\" {} \"integer "
        "pixelbounds\" [{} {} {} {}]\n"
        "PixelFilter \"box\" Sampler \"sobol\" \"integer pixelsamples\" 256\nWorldBegin\n{}\n",
        before, camera, width, height, x, x + 4, y, y + 4, world);
}
/// The same kernels for all of them.
RenderSetup everyCamera() {
    using enum Feature;
    RenderSetup setup;
    setup.forced.require(KindFeature::CAMERA_PERSPECTIVE)
        .require(KindFeature::CAMERA_ORTHOGRAPHIC)
        .require(KindFeature::CAMERA_SPHERICAL)
        .require(KindFeature::CAMERA_REALISTIC)
        .require(IMPORTANCE)
        .require(LENS)
        .require(SOBOL)
        .require(AOVS);
    return setup;
}
/// A thin biconvex lens of focal length 50 mm with a stop of 1.6 mm behind it (its faces meet at a radius of 1 mm), focused 2 m from the
/// film.
std::string thinLens() {
    static const LensFile file("50 .02 1.5 20\n-50 .02 1 20\n0 50 0 20\n");
    return file.camera() + " \"float aperturediameter\" 1.6 \"float focusdistance\" 2";
}
/// From it to the film: s s' = 2 f and s + s' = 2.
const double imageDistance = 1 - std::sqrt(1 - 2 * 0.05);

struct Seen {
    const char* name;
    std::string before, camera;
    int x, y;
    std::function<glm::dvec2(glm::dvec3)> pixel;
    double tolerance = 0.02;
};

/// A point that pixels see on average lies, by the formula of the camera (which is pbrt-v4's), in their middle; and pixelOf knows that
/// formula.
TEST(Cameras, SeeAPointWhereItIs) {
    const std::string window = " \"float screenwindow\" [-1 .5 -.25 .75]";
    const auto onWindow = [](glm::dvec2 s) { return glm::dvec2((s.x + 1) / 1.5 * width, (.75 - s.y) * height); };
    const double film = .035 / std::hypot(1., .75), fov = std::tan(20 * M_PI / 180);
    const auto perspective = [=](glm::dvec3 p) {
        return glm::dvec2(width / 2., height / 2.) + glm::dvec2(p.x, -p.y) / p.z / fov * (height / 2.);
    };
    const std::vector<Seen> cases{
        {"perspective", "", "\"perspective\" \"float fov\" 40", 400, 30, perspective},
        {"mirrored", "Scale -1 1 1", "\"perspective\" \"float fov\" 40", 400, 30,
         [=](glm::dvec3 p) {
             return perspective({-p.x, p.y, p.z});
         }},
        {"perspective through a window", "", "\"perspective\" \"float fov\" 90" + window, 20, 350,
         [=](glm::dvec3 p) { return onWindow(glm::dvec2(p) / p.z); }},
        {"orthographic through a window", "", "\"orthographic\"" + window, 20, 350, [=](glm::dvec3 p) { return onWindow(glm::dvec2(p)); }},
        {"frameaspectratio", "", "\"orthographic\" \"float frameaspectratio\" 2", 20, 350,
         [=](glm::dvec3 p) { return glm::dvec2((p.x / 2 + 1) / 2 * width, (1 - p.y) / 2 * height); }},
        {"longitudes", "", "\"spherical\" \"string mapping\" \"equirectangular\"", 300, 100,
         [=](glm::dvec3 p) {
             return glm::dvec2(std::atan2(p.z, p.x) / (2 * M_PI) * width + (p.z < 0 ? width : 0),
                               std::acos(p.y / glm::length(p)) / M_PI * height);
         }},
        /* Clarberg's square in its upper half, near the middle, where y is: the distance from there is sqrt(1 - cos) */
        {"equal areas", "", "\"spherical\"", 300, 200,
         [=](glm::dvec3 p) {
             const glm::dvec3 d = p / glm::length(p);
             const double r = std::sqrt(1 - d.y), turn = std::atan2(std::abs(d.z), std::abs(d.x)) * 2 / M_PI;
             return glm::dvec2((std::copysign(r * (1 - turn), d.x) + 1) / 2 * width, (std::copysign(r * turn, d.z) + 1) / 2 * height);
         }},
        {"thin lens", "", thinLens(), 300, 170,
         [=](glm::dvec3 p) {
             return glm::dvec2(width / 2., height / 2.) +
                    glm::dvec2(p.x, -p.y) * imageDistance / (p.z - imageDistance) / film * double(width);
         },
         0.1},
    };
    for (const Seen& c : cases) {
        SCOPED_TRACE(c.name);
        PackedScene scene = packScene(throughCamera(c.camera, c.x, c.y, ballAround, c.before));
        scene.require(Feature::AOVS, "the test");
        const FilmImage image = render(scene, everyCamera()).image;
        for (int i = 0; i < 16; ++i) {
            const glm::dvec3 p(image.position[static_cast<size_t>(i)]);
            const glm::dvec2 expected = c.pixel(p);
            EXPECT_NEAR(expected.x, c.x + i % 4 + .5, c.tolerance);
            EXPECT_NEAR(expected.y, c.y + i / 4 + .5, c.tolerance);
            const auto known = pixelOf(scene, transformPoint(scene.cameraFromScene[0], (p - scene.worldCenter) / scene.worldScale));
            ASSERT_TRUE(known);
            EXPECT_NEAR(glm::distance(*known, expected), 0, c.tolerance);
        }
    }
    EXPECT_FALSE(pixelOf(packScene(throughCamera("\"perspective\"", 0, 0)), {1, 2, -3}));
}

/// In the middle of the film light of radiance L from everywhere arrives through the stop of radius r: L pi r^2 / s'^2, at an "iso" of 100
/// and 1 s.
TEST(Cameras, ALensIsAsBrightAsItsStopIsWide) {
    expectRadiance(
        render(throughCamera(thinLens(), width / 2 - 2, height / 2 - 2, "LightSource \"infinite\" \"rgb L\" [4 4 4]"), everyCamera()),
        4 * M_PI * std::pow(0.0008 / imageDistance, 2), 0.02);
}

/// In the camera's own space the point in the middle of the image is as far along z as it is away, and what is looked at straight on looks
/// back.
TEST(Cameras, HaveASpaceOfTheirOwn) {
    View view;
    view.lookAt = "6 1 0  1 1 5  0 1 0";
    PackedScene scene = packScene(
        sceneText(view, "LightSource \"point\" Material \"diffuse\" Translate 1 1 5 Rotate -45 0 1 0 Shape \"disk\" \"float radius\" 2"));
    scene.require(Feature::AOVS, "the test");
    FilmImage image = render(scene).image;
    EXPECT_NEAR(image.position[5].z, 5, 1e-2);
    toCameraSpace(image, scene);
    EXPECT_NEAR(glm::distance(image.position[5], glm::vec3(0, 0, std::sqrt(50.f))), 0, 5e-3);
    EXPECT_NEAR(std::abs(image.normal[5].z), 1, 1e-4);
}

}  // namespace
}  // namespace eikonal
