// The lens of a realistic camera on the host, against optics; and how it is read.

#include "pack/lens.h"
#include "image/image_data.h"
#include "unit/pbrt_reading.h"

#include <cmath>

namespace eikonal {
namespace {

/// A biconvex lens of radius 50 mm and glass of 1.5, then a stop 4 mm behind it: a focal length near 50 mm.
CameraDescription biconvex(double focusDistance = 2, double aperture = 10) {
    CameraDescription c;
    c.lens = {{50, 4, 1.5, 30}, {-50, 4, 1, 30}, {0, 46, 0, 20}};
    c.focusDistance = focusDistance;
    c.apertureDiameter = aperture;
    return c;
}

/// Rays near the axis from the middle of the film meet the axis again where the lens is focused, to a fraction of its depth of field.
TEST(Lens, IsSharpWhereItIsFocused) {
    for (double distance : {0.5, 2.0, 100.0}) {
        const LensSystem lens(biconvex(distance), 35);
        const auto out = lens.fromFilm({{0, 0, 0}, {1e-4, 0, lens.rearZ()}});
        ASSERT_TRUE(out);
        const double z = out->o.z - out->o.x / out->d.x * out->d.z;
        EXPECT_NEAR(1 / z, 1 / distance, 2e-3);
    }
}

/// The lens maker's equation, 1 / f = (n - 1) (2 / R - (n - 1) t / (n R^2)), and the thin-lens equation for a point far off the lens:
/// an image of a small thing at distance s from the lens is x' / x = (s' / s), s' = 1 / (1 / f - 1 / s).
TEST(Lens, HasTheFocalLengthOfItsGlass) {
    const double n = 1.5, R = 0.05, t = 0.004, f = 1 / ((n - 1) * (2 / R - (n - 1) * t / (n * R * R)));
    const LensSystem lens(biconvex(10), 35);
    const auto out = lens.fromScene({{1e-4, 0, lens.rearZ() + 1}, {0, 0, -1}});
    ASSERT_TRUE(out);
    const double back = -1e-4 / (out->d.x / out->d.z) ;   /* effective: height over slope */
    EXPECT_NEAR(std::abs(back), f, 1e-3 * f);
}

/// What goes through from the film comes back the same way.
TEST(Lens, IsReversible) {
    const LensSystem lens(biconvex(), 35);
    for (double x : {-0.01, 0.0, 0.005})
        for (double y : {0.0, 0.004}) {
            const auto out = lens.fromFilm({{x, y, 0}, {0.002 - x, 0.001 - y, lens.rearZ()}});
            ASSERT_TRUE(out);
            const auto back = lens.fromScene({out->o + out->d, -out->d});
            ASSERT_TRUE(back);
            const glm::dvec3 film = back->o - back->o.z / back->d.z * back->d;
            EXPECT_NEAR(film.x, x, 1e-12);
            EXPECT_NEAR(film.y, y, 1e-12);
        }
}

/// With the stop next to the film the exit pupil is the stop; how wide it is open is clamped to what there is.
TEST(Lens, TheExitPupilIsTheStop) {
    for (const auto& [wanted, radius] : {std::pair{10.0, 0.005}, {0.2, 0.0001}, {90.0, 0.01}}) {
        const LensSystem lens(biconvex(2, wanted), 35);
        EXPECT_EQ(lens.stopIsTooWide(), wanted > 20);
        const pupil_bounds b = lens.pupils().front();
        for (const float side : {-b.low_x, -b.low_y, b.high_x, b.high_y}) {
            EXPECT_GE(side, 0.999 * radius) << wanted;
            EXPECT_LE(side, 1.15 * radius) << wanted;
        }
    }
    /* From behind a film too large the lens cannot be seen at all */
    const pupil_bounds none = LensSystem(biconvex(), 2000).pupils().back();
    EXPECT_GT(none.low_x, none.high_x);
}

TEST(Lens, WhatCannotBeFocusedIsAnError) {
    EXPECT_THROW(LensSystem(biconvex(0.1), 35), SceneError);
    CameraDescription window = biconvex();
    window.lens = {{0, 40, 0, 20}};
    EXPECT_THROW(LensSystem(window, 35), SceneError);
}

/// Stops with a shape are as bright as round ones. The square covers a quarter, so it lets pi pass.
TEST(Lens, AperturesHaveTheMeanOfADisk) {
    ImageData image;
    image.width = 2; image.height = 1; image.floats = {0, 3};
    for (const auto shape :
         {ApertureShape::gaussian, ApertureShape::square, ApertureShape::pentagon, ApertureShape::star, ApertureShape::image}) {
        const ApertureTexels a = apertureTexels(shape, shape == ApertureShape::image ? &image : nullptr);
        double sum = 0;
        for (float v : a.values) sum += static_cast<double>(v);
        EXPECT_NEAR(sum / (a.width * a.height), M_PI / 4, 1e-5);
        if (shape == ApertureShape::square) { EXPECT_NEAR(a.values[static_cast<size_t>(128 * 256 + 128)], M_PI, 1e-5); }
        if (shape == ApertureShape::image) { EXPECT_NEAR(a.values[1], M_PI / 2, 1e-6); }
    }
    EXPECT_TRUE(apertureTexels(ApertureShape::round, nullptr).values.empty());
}

class LensFile : public PbrtTest {
protected:
    std::string camera(const std::string& text, const std::string& more = "") {
        write("lens.dat", text);
        return "Camera \"realistic\" \"string lensfile\" \"lens.dat\" " + more + "\nWorldBegin\n";
    }
};

TEST_F(LensFile, IsRead) {
    const Scene scene = read(camera("# radius thickness eta aperture\n35 4 1.5 20\n0 2 0 18 -40 30 1 20",
                                    "\"float aperturediameter\" 3 \"float focusdistance\" 7 \"string aperture\" \"star\""));
    EXPECT_TRUE(warnings_.empty());
    ASSERT_EQ(scene.camera.lens.size(), 3u);
    EXPECT_EQ(scene.camera.lens[2].curvatureRadius, -40);
    EXPECT_EQ(scene.camera.lens[1].apertureDiameter, 18);
    EXPECT_EQ(scene.camera.aperture, ApertureShape::star);
    EXPECT_EQ(scene.camera.focusDistance, 7);
}

TEST_F(LensFile, ErrorsSayWhere) {
    EXPECT_THAT(errorOf(camera("35 4 1.5 20\n0 2 0")), HasSubstr("lens.dat:2:1: the last element of this lens has 3 numbers"));
    EXPECT_THAT(errorOf(camera("35 4 glass 20")), HasSubstr("lens.dat:1:6: \"glass\" found where a number is expected"));
    EXPECT_THAT(errorOf(camera("35 4 1.5 -2")), HasSubstr("must be above 0"));
    EXPECT_THAT(errorOf(camera("# nothing")), HasSubstr("this lens file has no numbers"));
    EXPECT_THAT(errorOf(camera("35 4 1.5 20", "\"float focusdistance\" 0")), HasSubstr("must be in (0, inf)"));
    EXPECT_THAT(errorOf(camera("35 4 1.5 20", "\"string aperture\" \"hexagon.png\"")), HasSubstr("hexagon.png"));
    EXPECT_THAT(errorOf("Camera \"realistic\"\nWorldBegin"), HasSubstr("needs a \"string lensfile\""));
    EXPECT_THAT(errorOf("Camera \"spherical\" \"string mapping\" \"cubic\"\nWorldBegin"),
                HasSubstr("it can be \"equalarea\" or \"equirectangular\""));
}

}  // namespace
}  // namespace eikonal
