// What the film makes of light.

#include "film/exposure.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

FilmImage onePixel(glm::vec3 color) {
    FilmImage image(1, 1);
    image.color[0] = color;
    image.variance = {.01f};
    return image;
}

TEST(Exposure, TheUsualFilmChangesNoBitInAnySpace) {
    FilmImage image = onePixel({.1f, .7f, -.2f});
    expose(image, {.colorSpace = ColorSpace::aces2065});
    EXPECT_EQ(image.color[0], glm::vec3(.1f, .7f, -.2f));
    EXPECT_EQ(image.variance[0], .01f);
}

// Brightness is time * ISO / 100: 0.5 * 4 = 2; its variance goes with the square.
TEST(Exposure, TimeAndSensitivityScaleTheLight) {
    FilmImage image = onePixel({.1f, .7f, .2f});
    expose(image, {.iso = 400, .exposureTime = .5});
    EXPECT_NEAR(image.color[0].x, .2f, 1e-6);
    EXPECT_NEAR(image.color[0].y, 1.4f, 1e-6);
    EXPECT_NEAR(image.variance[0], .04f, 1e-6);
}

// The light that a film is balanced for is white in the image, which is sRGB also if the film names another space with a white of D65.
TEST(Exposure, BalancedLightIsWhite) {
    const glm::dvec3 d50 = rgbFromXyz(ColorSpace::srgb) * glm::dvec3(.34567, .35850, 1 - .34567 - .35850) / .35850;
    for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::rec2020}) {
        FilmImage image = onePixel(d50);
        expose(image, {.whiteBalance = 5000, .colorSpace = space});
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.color[0][c], 1, 2e-3);
    }
}

// A camera's own white balance is daylight of 6500 K: grey stays grey, to the accuracy of the fit to the colour chart.
TEST(Exposure, ACameraKeepsGrey) {
    FilmImage image = onePixel(glm::vec3(.5f));
    expose(image, {.sensor = "canon_eos_100d"});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.color[0][c], .5, .02);
}

}  // namespace
}  // namespace eikonal
