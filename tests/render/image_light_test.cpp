// Lights with an image, and portals.

#include "lit_floor.h"
#include "read/pbrt/read_pbrt.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace eikonal {
namespace {

/// Three times three texels, of which only the middle one is not black.
class ImageLights : public testing::Test {
protected:
    ImageLights() { std::ofstream(file_) << "P3\n3 3\n255\n0 0 0 0 0 0 0 0 0\n0 0 0 255 188 137 0 0 0\n0 0 0 0 0 0 0 0 0\n"; }
    ~ImageLights() override { std::filesystem::remove(file_); }
    /// At height 2, its +z turned by an angle from the floor's origin, in degrees.
    std::string slide(double angle) const {
        return fmt::format(
            "AttributeBegin Translate 0 2 0 Rotate {} 1 0 0 LightSource \"projection\" \"float fov\" 90 \"float scale\" 3 \"string "
            "filename\" \"{}\" AttributeEnd\n",
            90 + angle, file_.string());
    }
    /// The same with its +y.
    std::string lamp(double angle) const {
        return fmt::format(
            "AttributeBegin Translate 0 2 0 Rotate {} 1 0 0 LightSource \"goniometric\" \"rgb I\" [3 1 2] \"string filename\" \"{}\" "
            "AttributeEnd\n",
            180 + angle, file_.string());
    }
    static double linear(double byte) { return std::pow((byte / 255 + 0.055) / 1.055, 2.4); }
    static inline const glm::dvec3 texel{1, linear(188), linear(137)};
    static inline const glm::dvec3 fromSlide = rho / pi * 3. / 4 * texel,
                                   fromLamp = rho / pi / 4 * (texel.x + texel.y + texel.z) / 3 * glm::dvec3(3, 1, 2);

private:
    const std::filesystem::path file_ = std::filesystem::temp_directory_path() / fmt::format("eikonal_light_image_{}.ppm", ::getpid());
};

// E = I / d^2. The middle texel of the slide ends at atan(1/3) = 18.4 degrees. That of the lamp, a third of the square, is met in its
// middle: there z = 1 - (1/3)^2 in Clarberg's mapping, which is at 27.3 degrees.
TEST_F(ImageLights, SendAsTheirImageSays) {
    expectRadiance(onTheFloor(slide(0)), fromSlide);
    expectRadiance(onTheFloor(slide(17)), fromSlide);
    expectRadiance(onTheFloor(slide(20)), glm::dvec3(0));
    expectRadiance(onTheFloor(lamp(0)), fromLamp);
    expectRadiance(onTheFloor(lamp(26)), fromLamp);
    expectRadiance(onTheFloor(lamp(29)), glm::dvec3(0));
}

// Only turns and reflections of space count, of which shear has its nearest; what else there is, is said.
TEST_F(ImageLights, AreNotStretched) {
    const auto textOf = [&](const std::string& transform) {
        return sceneText(atTheOrigin(), "AttributeBegin " + transform + " " + slide(17) + "AttributeEnd\n" + floorShape);
    };
    const auto warnings = [&](const std::string& transform) {
        Diagnostics diagnostics(LogLevel::silent);
        packScene(readPbrtText(textOf(transform), "test.pbrt", ".", diagnostics), diagnostics);
        return diagnostics.warnings();
    };
    for (const char* kept : {"", "Scale -1 1 1", "Scale -1 -1 -1 Rotate 180 0 1 0 Scale 1 -1 1"})
        expectRadiance(render(textOf(kept), surfaces()), fromSlide);
    EXPECT_TRUE(warnings("Rotate 30 1 2 3 Scale -2 2 2").empty());
    ASSERT_EQ(warnings("Scale 3 1 1").size(), 1u);
    EXPECT_NE(warnings("Scale 3 1 1")[0].find("scales unequally or shears"), std::string::npos);
    expectRadiance(render(packScene(textOf("Scale 3 1 1"), ColorMode::automatic, Warnings::allowed), surfaces()), fromSlide);
}

// All of them at wavelengths, with a portal and a light tree.
TEST_F(ImageLights, AreTheSameAtWavelengths) {
    View view = atTheOrigin();
    view.sampler = "sobol";
    view.samples = 1024;
    view.more = "Integrator \"volpath\" \"integer maxdepth\" 1 \"string lightsampler\" \"bvh\"";
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [4 3 1] \"point3 portal\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7]\n";
    const glm::dvec3 seen =
        estimate(render(packScene(sceneText(view, slide(0) + lamp(0) + sky + floorShape), ColorMode::spectral)).image).mean;
    const glm::dvec3 expected = fromSlide + fromLamp + rho / pi * irradianceOfRectangle(1.2, .7) / Le * glm::dvec3(4, 3, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1, 0.01) << "channel " << c;
}

// A sky of radiance Le that comes in through a rectangle lights the floor as a rectangle of that radiance does, and is as bright.
TEST(Light, APortalIsARectangleOfSky) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [4 4 4] ";
    expectRadiance(onTheFloor(sky + "\"point3 portal\" [0 1 0  0 1 .7  1.2 1 .7  1.2 1 0]"), glm::dvec3(0));
    expectRadiance(onTheFloor(sky + "\"point3 portal\" [0 1 0  1.2 1 0  1.2 1 .7  0 1 .7]"), rho / pi * irradianceOfRectangle(1.2, .7));
    View view;
    view.maxDepth = 0;
    expectRadiance(render(sceneText(view, sky + "\"point3 portal\" [-1 -1 1  -1 1 1  1 1 1  1 -1 1]"), surfaces()), Le);
    expectRadiance(render(sceneText(view, sky + "\"point3 portal\" [1 -1 1  1 1 1  2 1 1  2 -1 1]"), surfaces()), glm::dvec3(0));
}

}  // namespace
}  // namespace eikonal
