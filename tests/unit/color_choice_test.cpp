// Whether a scene is rendered in RGB or at wavelengths, by how far RGB would be off.

#include "pack/color_mode.h"
#include "pack/pack.h"
#include "pack/rgb_error.h"
#include "pack/scene_bounds.h"
#include "read/formats/image.h"

#include "color/color_set.h"
#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string lamp =
    "AttributeBegin\nTranslate 0 1.9 0\nAreaLightSource \"diffuse\" \"rgb L\" [10 10 10]\nMaterial \"diffuse\" "
    "\"rgb reflectance\" [0 0 0]\nShape \"disk\" \"float radius\" .3\nAttributeEnd\n";

std::string surface(const std::string& color, const std::string& place) {
    return "AttributeBegin\nMaterial \"diffuse\" \"rgb reflectance\" " + color + "\nTranslate " + place +
           "\nShape \"sphere\" \"float radius\" .5\nAttributeEnd\n";
}

/// Five walls of a room, all of one colour.
std::string room(const std::string& color) {
    std::string text = "Material \"diffuse\" \"rgb reflectance\" " + color + "\n";
    for (const char* corners : {"-2 -2 -2 2 -2 -2 -2 -2 2 2 -2 2", "-2 2 -2 2 2 -2 -2 2 2 2 2 2", "-2 -2 2 2 -2 2 -2 2 2 2 2 2",
                                "-2 -2 -2 -2 -2 2 -2 2 -2 -2 2 2", "2 -2 -2 2 -2 2 2 2 -2 2 2 2"})
        text += std::string("Shape \"bilinearmesh\" \"point3 P\" [") + corners + "]\n";
    return text;
}

class ColorChoices : public PbrtTest {
protected:
    RgbError errorOf(const std::string& text) {
        const Scene scene = world(text);
        return predictRgbError(scene, loadImages(scene.images), boundsOf(scene).near);
    }
    ColorChoice choiceOf(const std::string& text) {
        const Scene scene = world(text);
        return chooseColor(scene, loadImages(scene.images), boundsOf(scene).near);
    }
};

// Grey times grey is the same in both, whatever the light; so is a single colour under white light.
TEST_F(ColorChoices, GreyAndLightlyColouredScenesStayRgb) {
    for (const std::string& scene : {lamp + room("[.7 .7 .7]"), lamp + room("[.62 .6 .57]"),
                                     "LightSource \"infinite\" \"rgb L\" [.3 .4 .5]\n" + surface("[.5 .5 .5]", "0 0 0"),
                                     "LightSource \"distant\" \"rgb L\" [3 2.9 2.7]\n" + surface("[.6 .5 .45]", "0 0 0")}) {
        const ColorChoice choice = choiceOf(scene);
        EXPECT_FALSE(choice.spectral) << choice.why << "\n" << scene;
        EXPECT_THAT(choice.why, HasSubstr("off by"));
    }
    EXPECT_LT(errorOf(lamp + room("[.7 .7 .7]")).worst, 0.002);
}

TEST_F(ColorChoices, SaturatedProductsNeedWavelengths) {
    const ColorChoice choice = choiceOf("LightSource \"point\" \"rgb I\" [9 1 .5]\n" + surface("[.05 .6 .1]", "0 0 0"));
    EXPECT_TRUE(choice.spectral) << choice.why;
    EXPECT_THAT(choice.why, AllOf(HasSubstr("test.pbrt:"), HasSubstr("material"), HasSubstr("in RGB a channel could be off by up to")));
    EXPECT_TRUE(choiceOf(lamp + room("[.7 .1 .05]")).spectral) << "light between walls of one colour";
    EXPECT_TRUE(choiceOf(lamp + room("[.6 .6 .6]") + surface("[.7 .6 0]", "0 0 0")).spectral) << "the dark channel of yellow";
}

// The colour of exp(-sigma d) departs from that of three numbers, the further the longer the path.
TEST_F(ColorChoices, ColouredMediaNeedWavelengths) {
    const auto inMedium = [&](const std::string& a, const std::string& s) {
        return "LightSource \"infinite\" \"rgb L\" [1 1 1]\nMakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" " + a +
               " \"rgb sigma_s\" " + s + "\nMediumInterface \"m\" \"\"\nMaterial \"dielectric\"\nShape \"sphere\"";
    };
    EXPECT_FALSE(choiceOf(inMedium("[1 1 1]", "[0 0 0]")).spectral) << "grey absorption";
    EXPECT_FALSE(choiceOf(inMedium("[0 0 0]", "[2 2 2]")).spectral) << "fog";
    const ColorChoice glass = choiceOf(inMedium("[.3 .8 1.5]", "[0 0 0]"));
    EXPECT_TRUE(glass.spectral);
    EXPECT_THAT(glass.why, HasSubstr("medium \"m\""));
    EXPECT_TRUE(choiceOf(inMedium("[.1 .5 2]", "[4 4 4]")).spectral) << "what scatters many times is absorbed as often";
    EXPECT_GT(errorOf(inMedium("[.3 .8 1.5]", "[0 0 0]")).worst, errorOf(inMedium("[.03 .08 .15]", "[0 0 0]")).worst);
}

TEST_F(ColorChoices, CoatsBodiesAndHairAreLookedInto) {
    const std::string sky = "LightSource \"infinite\" \"rgb L\" [1 1 1]\n", ball = "\nShape \"sphere\"";
    EXPECT_FALSE(choiceOf(sky + "Material \"coateddiffuse\" \"rgb reflectance\" [.5 .5 .5]" + ball).spectral);
    EXPECT_TRUE(choiceOf(sky + "Material \"coateddiffuse\" \"rgb reflectance\" [.8 .2 .02]" + ball).spectral);
    EXPECT_FALSE(choiceOf(sky + "Material \"subsurface\" \"rgb sigma_a\" [.1 .1 .1] \"rgb sigma_s\" [5 5 5]" + ball).spectral);
    EXPECT_TRUE(choiceOf(sky + "Material \"subsurface\" \"rgb sigma_a\" [.05 .3 1] \"rgb sigma_s\" [5 5 5]" + ball).spectral);
    EXPECT_TRUE(choiceOf(sky + "Material \"hair\" \"rgb sigma_a\" [.2 .6 1.4]" + ball).spectral);
    EXPECT_FALSE(choiceOf(sky + "Material \"hair\" \"rgb sigma_a\" [.6 .6 .6]" + ball).spectral);
}

// A blue light that fills an image needs wavelengths; one that adds a thousandth to white light does not.
TEST_F(ColorChoices, LightsCountByWhatTheyAdd) {
    const std::string blue = "LightSource \"point\" \"rgb I\" [0 .001 .01]\n", red = surface("[.7 .2 .1]", "0 0 0");
    EXPECT_TRUE(choiceOf(blue + red).spectral);
    EXPECT_FALSE(choiceOf(blue + "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" + red).spectral);
}

TEST_F(ColorChoices, TexturesCountByTheirColours) {
    const std::string light = "LightSource \"infinite\" \"rgb L\" [1 .8 .6]\n",
                      use = "Material \"diffuse\" \"texture reflectance\" \"t\"\nShape \"sphere\"";
    const auto checks = [&](const std::string& a, const std::string& b) {
        return light + "Texture \"t\" \"spectrum\" \"checkerboard\" \"rgb tex1\" " + a + " \"rgb tex2\" " + b + "\n" + use;
    };
    EXPECT_FALSE(choiceOf(checks("[.5 .5 .5]", "[.2 .2 .2]")).spectral);
    EXPECT_TRUE(choiceOf(checks("[.5 .5 .5]", "[.8 .7 0]")).spectral);
    const auto mix = [&](const std::string& amount) {
        return light + "Texture \"t\" \"spectrum\" \"mix\" \"rgb tex1\" [.5 .5 .5] \"rgb tex2\" [.8 .7 0] \"float amount\" " + amount +
               "\n" + use;
    };
    EXPECT_TRUE(choiceOf(mix(".5")).spectral);
    EXPECT_FALSE(choiceOf(mix("0")).spectral) << "the saturated colour has no share";
}

// Of an image, similar texels are one colour; shares of reflectances are numbers of texels, those of light its radiance.
TEST_F(ColorChoices, ImagesHaveFewColours) {
    std::vector<glm::dvec3> texels(90, glm::dvec3(.5, .5, .51));
    texels.resize(100, glm::dvec3(.8, .1, 0));
    for (const bool isLight : {false, true}) {
        const ColorSet set = colorsOf(texels, isLight);
        ASSERT_EQ(set.size(), 2u);
        EXPECT_NEAR(set[0].share, isLight ? .9 * 1.51 / (.9 * 1.51 + .1 * .9) : .9, 1e-9);
        EXPECT_NEAR(meanOf(set).rgb.x, .9 * .5 + .1 * .8, 1e-9);
    }
}

// The spectrum of a colour that nothing multiplies has that colour.
TEST_F(ColorChoices, OneColourIsTheSameInBoth) {
    const glm::dvec3 rgb(.6, .35, .2);
    for (const DualColor& seen : {DualColor::reflectance(Spectrum::rgb(rgb)) * DualColor::white(), DualColor::emission(Spectrum::rgb(rgb)),
                                  DualColor::texel(rgb, true) * DualColor::white()}) {
        EXPECT_LT(glm::length(seen.seen() - rgb), 0.006);
        EXPECT_LT(glm::length(seen.rgb - rgb), 1e-9);
    }
}

// --color and the integrator may decide before colours do.
TEST_F(ColorChoices, OptionsComeFirst) {
    Scene scene = world("LightSource \"point\" \"rgb I\" [9 1 .5]\n" + surface("[.05 .6 .1]", "0 0 0"));
    const auto isSpectral = [&] { return chooseColor(scene, {}, boundsOf(scene).near).spectral; };
    EXPECT_TRUE(isSpectral());
    scene.colorMode = ColorMode::rgb;
    EXPECT_FALSE(isSpectral());
    scene = world("LightSource \"infinite\"\nShape \"sphere\"");
    EXPECT_FALSE(isSpectral());
    scene.colorMode = ColorMode::spectral;
    EXPECT_TRUE(isSpectral());
}

}  // namespace
}  // namespace eikonal
