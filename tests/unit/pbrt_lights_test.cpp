// Lights. Defaults and photometric scales are those of pbrt-v4's source (lights.cpp).

#include "unit/pbrt_reading.h"

#include <glm/gtc/constants.hpp>

namespace eikonal {
namespace {

class PbrtLights : public PbrtTest {
protected:
    Light light(const std::string& text) { return world("LightSource " + text).lights.at(0); }
    AreaLight area(const std::string& text) { return world("AreaLightSource \"diffuse\" " + text + " Shape \"sphere\"").areaLights.at(0); }
};

constexpr double pi = glm::pi<double>();

TEST_F(PbrtLights, pointLights) {
    const Light l = light("\"point\" \"rgb I\" [1 2 3] \"float scale\" 4 \"point3 from\" [5 6 7]");
    expectNear(l.spectrum.illuminant(), {1, 2, 3});
    expectNear(l.from, {5, 6, 7});
    EXPECT_EQ(l.scale, 4);
    expectNear(light("\"point\"").spectrum.illuminant(), {1, 1, 1});
}

// A point light of intensity I emits 4 pi I.
TEST_F(PbrtLights, powerOfAPointLight) {
    EXPECT_NEAR(light("\"point\" \"float power\" 100 \"float scale\" 2").scale, 2 * 100 / (4 * pi), 1e-9);
}

// A spot light of intensity I emits I times its cone's solid angle, the part that falls off counting half.
TEST_F(PbrtLights, spotLights) {
    const auto spot = light("\"spot\"");
    EXPECT_EQ(spot.coneAngle, 30);
    EXPECT_EQ(spot.coneDeltaAngle, 5);
    expectNear(spot.to, {0, 0, 1});
    const double end = std::cos(glm::radians(60.)), start = std::cos(glm::radians(50.));
    EXPECT_NEAR(light("\"spot\" \"float power\" 10 \"float coneangle\" 60 \"float conedeltaangle\" 10").scale,
                10 / (2 * pi * (1 - start) + pi * (start - end)), 1e-9);
}

TEST_F(PbrtLights, distantLights) {
    const Light l = light("\"distant\" \"rgb L\" [1 1 1] \"float illuminance\" 500 \"point3 from\" [0 1 0] \"point3 to\" [0 0 0]");
    EXPECT_EQ(l.scale, 500);
    expectNear(l.from, {0, 1, 0});
    expectNear(light("\"distant\"").to, {0, 0, 1});
}

// A strength in all that is not above 0 has no effect, as in pbrt-v4; but -1 is the default.
TEST_F(PbrtLights, aStrengthThatHasNoEffectIsNamed) {
    for (const std::string text : {"LightSource \"point\" \"float power\" ", "LightSource \"spot\" \"float power\" ",
                                   "LightSource \"distant\" \"float illuminance\" ", "LightSource \"infinite\" \"float illuminance\" ",
                                   "AreaLightSource \"diffuse\" \"float power\" "}) {
        for (const char* strength : {"0", "-3"}) {
            const std::vector<std::string> warnings = warningsOfWorld(text + strength);
            ASSERT_EQ(warnings.size(), 1u) << text << strength;
            EXPECT_NE(warnings[0].find(std::string("\" ") + strength + " has no effect"), std::string::npos) << warnings[0];
        }
        EXPECT_TRUE(warningsOfWorld(text + "-1").empty()) << text;
        EXPECT_TRUE(warningsOfWorld(text + "2").empty()) << text;
    }
    EXPECT_EQ(light("\"point\" \"float power\" 0").scale, 1);
}

// A sky of radiance L puts pi L on a level surface.
TEST_F(PbrtLights, infiniteLights) {
    expectNear(light("\"infinite\"").spectrum.illuminant(), {1, 1, 1});
    EXPECT_NEAR(light("\"infinite\" \"rgb L\" [1 1 1] \"float illuminance\" 10").scale, 10 / pi, 1e-9);
    write("sky.exr", "an image");
    const Scene scene =
        world("Rotate 90 1 0 0 LightSource \"infinite\" \"string filename\" \"sky.exr\" \"float scale\" 3 \"float illuminance\" 10");
    const Light& sky = scene.lights.at(0);
    EXPECT_EQ(scene.images[sky.image].wrap, wrap_octahedral);
    EXPECT_EQ(sky.scale, 3);
    EXPECT_EQ(sky.illuminance, 10);
    expectNear(apply(sky.worldFromLight, {0, 1, 0}), {0, 0, 1});
    EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"rgb L\" [1 1 1] \"string filename\" \"sky.exr\""),
                HasSubstr("either \"L\" or \"filename\""));
}

TEST_F(PbrtLights, theWhiteOfALightIsThatOfItsColorSpace) {
    // Both spaces have the white D65, so the defaults agree; ACES has a warmer one.
    expectNear(world("ColorSpace \"rec2020\" LightSource \"point\"").lights[0].spectrum.illuminant(), {1, 1, 1}, 1e-3);
    const glm::dvec3 aces = world("ColorSpace \"aces2065-1\" LightSource \"point\"").lights[0].spectrum.illuminant();
    EXPECT_GT(aces.x, aces.z);
}

TEST_F(PbrtLights, areaLights) {
    write("lamp.png", "an image");
    const Scene lamp = world("AreaLightSource \"diffuse\" \"string filename\" \"lamp.png\" \"float scale\" 3 Shape \"sphere\"");
    EXPECT_EQ(lamp.areaLights.at(0).image, 0);
    EXPECT_EQ(lamp.images.at(0).wrap, wrap_clamp);
    EXPECT_TRUE(warnings_.empty());
    const AreaLight l = area("\"rgb L\" [1 2 3] \"float scale\" 2 \"bool twosided\" true");
    expectNear(l.L.illuminant(), {1, 2, 3});
    EXPECT_EQ(l.scale, 2);
    EXPECT_TRUE(l.twoSided);
    EXPECT_FALSE(l.power.has_value());
    EXPECT_FALSE(area("").twoSided);
    EXPECT_EQ(area("\"float power\" 60").power, 60);
}

// A measured spectrum says how the light is distributed; how much there is of it, the scale says: its luminance is 1.
TEST_F(PbrtLights, measuredSpectraHaveLuminanceOne) {
    const glm::dvec3 L = area("\"spectrum L\" \"stdillum-A\"").L.illuminant();
    EXPECT_NEAR(glm::dot(L, glm::dvec3(0.2126, 0.7152, 0.0722)), 1, 1e-3);
    EXPECT_GT(L.x, L.z);
}

TEST_F(PbrtLights, anAreaLightHoldsForTheShapesAfterIt) {
    const Scene scene = world("AttributeBegin AreaLightSource \"diffuse\" Shape \"sphere\" Shape \"disk\" AttributeEnd Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].areaLight, scene.shapes[1].areaLight);
    EXPECT_EQ(scene.shapes[2].areaLight, none);
}

TEST_F(PbrtLights, whatCannotEmit) {
    EXPECT_EQ(world("AreaLightSource \"diffuse\" Material \"interface\" Shape \"sphere\"").shapes[0].areaLight, none);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("cannot emit")));
    EXPECT_EQ(world("AreaLightSource \"diffuse\" ObjectBegin \"o\" Shape \"sphere\" ObjectEnd").objects[0].shapes[0].areaLight, none);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("a shape inside an object cannot emit")));
}

TEST_F(PbrtLights, lightsWithAnImage) {
    write("slide.png", "an image");
    const Light lamp = light("\"goniometric\" \"string filename\" \"slide.png\" \"rgb I\" [1 2 3] \"float power\" 7");
    expectNear(lamp.spectrum.illuminant(), {1, 2, 3});
    EXPECT_EQ(lamp.power, 7);
    const Light slide = light("\"projection\" \"string filename\" \"slide.png\"");
    EXPECT_EQ(slide.fov, 90);
    EXPECT_FALSE(slide.power.has_value());
    EXPECT_THAT(errorOfWorld("LightSource \"projection\""), HasSubstr("test.pbrt:2:1: light \"projection\" needs an image"));
    EXPECT_THAT(errorOfWorld("LightSource \"projection\" \"string filename\" \"slide.png\" \"float fov\" 180"),
                HasSubstr("it must be in (0, 180)"));
}

TEST_F(PbrtLights, portals) {
    const Light l = light("\"infinite\" \"rgb L\" [1 2 3] \"float illuminance\" 10 \"point3 portal\" [0 0 0  0 1 0  2 1 0  2 0 0]");
    EXPECT_EQ(l.image, none);
    expectNear(l.spectrum.illuminant(), {1, 2, 3});
    expectNear(l.portal[2], {2, 1, 0});
    EXPECT_NEAR(l.scale, 10 / pi, 1e-9);
    EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"point3 portal\" [0 0 0  1 0 0  1 1 0]"),
                HasSubstr("a portal has 4 corners; here are 3"));
    for (const char* crooked :
         {"0 0 0  1 0 0  1 2 0  0 1 0", "0 0 0  1 0 0  1 1 0  0 1 1", "0 0 0  0 0 0  1 1 0  1 1 0", "0 0 0  1 .2 0  1 1.2 0  0 1 0"})
        EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"point3 portal\" [" + std::string(crooked) + "]"), HasSubstr("a rectangle"));
}

}  // namespace
}  // namespace eikonal
