// Numbers that mean nothing are errors, with their place, what they are and what they may be; those that pbrt-v4 takes for another are
// taken for the same one, with a warning.

#include "unit/pbrt_reading.h"

#include "pack/alias_table.h"
#include "pack/pack.h"

namespace eikonal {
namespace {

using PbrtRanges = PbrtTest;

struct BadNumber { const char *text, *error; };
void PrintTo(const BadNumber& b, std::ostream* out) { *out << b.text; }

class BadSettings : public PbrtTest, public testing::WithParamInterface<BadNumber> {};
class BadWorlds : public PbrtTest, public testing::WithParamInterface<BadNumber> {};

TEST_P(BadSettings, AreErrors) {
    EXPECT_THAT(errorOf(std::string(GetParam().text) + "\nWorldBegin"), HasSubstr(std::string("test.pbrt:1:") + GetParam().error));
}
TEST_P(BadWorlds, AreErrors) { EXPECT_THAT(errorOfWorld(GetParam().text), HasSubstr(std::string("test.pbrt:2:") + GetParam().error)); }

INSTANTIATE_TEST_SUITE_P(
    Pbrt, BadSettings,
    testing::Values(
        BadNumber{"Camera \"perspective\" \"float fov\" 200", "22: camera \"perspective\": \"float fov\" is 200; it must be in (0, 180)"},
        BadNumber{"Camera \"perspective\" \"float fov\" 180", "22: camera \"perspective\": \"float fov\" is 180; it must be in (0, 180)"},
        BadNumber{"Camera \"perspective\" \"float fov\" 0", "22: camera \"perspective\": \"float fov\" is 0"},
        BadNumber{"Camera \"orthographic\" \"float frameaspectratio\" 0", "23: "},
        BadNumber{"Camera \"perspective\" \"float screenwindow\" [1 1 -1 1]", "22: \"float screenwindow\" is empty"},
        BadNumber{"Camera \"perspective\" \"float lensradius\" 1 \"float focaldistance\" 0",
                  "43: camera \"perspective\": \"float focaldistance\" is 0; with a lens it must be in (0, inf)"},
        BadNumber{"PixelFilter \"gaussian\" \"float sigma\" 0",
                  "24: pixel filter \"gaussian\": \"float sigma\" is 0; it must be in (0, inf)"},
        BadNumber{"PixelFilter \"sinc\" \"float tau\" -1", "20: "},
        BadNumber{"PixelFilter \"box\" \"float yradius\" 0", "19: pixel filter \"box\": \"float yradius\" is 0; it must be in (0, inf)"},
        BadNumber{"Film \"rgb\" \"float iso\" 0", "12: film \"rgb\": \"float iso\" is 0; it must be in (0, inf)"},
        BadNumber{"Film \"rgb\" \"float maxcomponentvalue\" -1", "12: "},
        BadNumber{"Film \"spectral\" \"integer nbuckets\" 0", "17: film \"spectral\": \"integer nbuckets\" is 0; it must be in [1, 512]"},
        BadNumber{"Film \"spectral\" \"integer nbuckets\" 100000",
                  "17: film \"spectral\": \"integer nbuckets\" is 100000; it must be in [1, 512]"},
        BadNumber{"Film \"spectral\" \"float lambdamin\" 300",
                  "17: film \"spectral\": \"float lambdamin\" is 300; it must be in [360, 830]"},
        BadNumber{"Film \"spectral\" \"float lambdamax\" 900",
                  "17: film \"spectral\": \"float lambdamax\" is 900; it must be in [360, 830]"},
        BadNumber{"Film \"spectral\" \"float lambdamin\" 830",
                  "17: film \"spectral\": its wavelengths are from 830 to 830 nm; \"float lambdamax\" must be greater"},
        BadNumber{"Film \"spectral\" \"float lambdamin\" 600 \"float lambdamax\" 500",
                  "39: film \"spectral\": its wavelengths are from 600 to 500 nm; \"float lambdamax\" must be greater than \"float "
                  "lambdamin\", by 1 nm at least"}));

INSTANTIATE_TEST_SUITE_P(
    Pbrt, BadWorlds,
    testing::Values(
        BadNumber{"Material \"dielectric\" \"float eta\" -1", "23: material \"dielectric\": \"float eta\" is -1; it must be in [0, inf)"},
        BadNumber{"Material \"coateddiffuse\" \"integer nsamples\" 0",
                  "26: material \"coateddiffuse\": \"integer nsamples\" is 0; it must be in [1, inf)"},
        BadNumber{"Attribute \"material\" \"float eta\" -1 Material \"thindielectric\"",
                  "22: material \"thindielectric\": \"float eta\" is -1"},
        BadNumber{"Material \"coatedconductor\" \"integer nsamples\" 0", "28: "},
        BadNumber{"Material \"hair\" \"float eta\" 0", "17: material \"hair\": \"float eta\" is 0; it must be in (0, inf)"},
        BadNumber{"MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"float scale\" -3",
                  "49: medium \"homogeneous\": \"float scale\" is -3; it must be in [0, inf)"},
        BadNumber{"MakeNamedMedium \"m\" \"string type\" \"cloud\" \"float density\" -1", "43: "},
        BadNumber{"LightSource \"spot\" \"float coneangle\" 500", "20: light \"spot\": \"float coneangle\" is 500; it must be in (0, 180]"},
        BadNumber{"LightSource \"point\" \"float scale\" -1", "21: light \"point\": \"float scale\" is -1; it must be in [0, inf)"},
        BadNumber{"AreaLightSource \"diffuse\" \"float scale\" -1", "27: "},
        BadNumber{"LightSource \"distant\" \"point3 from\" [1 2 3] \"point3 to\" [1 2 3]",
                  "45: light \"distant\": \"from\" and \"to\" are the same point, (1, 2, 3)"},
        BadNumber{"LightSource \"spot\" \"point3 from\" [0 0 1]", "20: light \"spot\": \"from\" and \"to\" are the same point"},
        BadNumber{"Scale 0 1 1 LightSource \"infinite\"", "13: light \"infinite\": its transform cannot be inverted"}));

// What pbrt-v4 does with these: no lens; a smooth surface; no coat at all; no inner bounces; an index of 1; Henyey-Greenstein at its limit.
TEST_F(PbrtRanges, AreKeptToWherePbrtKeepsToThem) {
    EXPECT_EQ(read("Camera \"perspective\" \"float lensradius\" -1\nWorldBegin").camera.lensRadius, 0);
    EXPECT_THAT(
        warnings_,
        ElementsAre(HasSubstr(
            "test.pbrt:1:22: warning: camera \"perspective\": \"float lensradius\" is -1; it counts as 0, since it must be in [0, inf)")));

    const auto input = [&](const std::string& material, const std::string& name) {
        return world(material + "\nShape \"sphere\"").materials.at(0).inputs.at(name).value.albedo().g;
    };
    EXPECT_EQ(input("Material \"dielectric\" \"float roughness\" -2", "uroughness"), 0);
    EXPECT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(input("Attribute \"material\" \"float roughness\" -2 Material \"dielectric\"", "vroughness"), 0);
    EXPECT_EQ(warnings_.size(), 1u);
    EXPECT_EQ(input("Material \"coateddiffuse\" \"float thickness\" -1", "thickness"), 0);
    EXPECT_EQ(input("Material \"coateddiffuse\" \"integer maxdepth\" -1", "maxdepth"), 0);
    EXPECT_EQ(input("Material \"coateddiffuse\" \"float g\" 3", "g"), 1);
    EXPECT_EQ(input("Material \"dielectric\" \"float eta\" 0", "eta"), 1);
    EXPECT_THAT(
        warnings_,
        ElementsAre(HasSubstr("test.pbrt:2:23: warning: material \"dielectric\": \"float eta\" is 0; it counts as 1, as in pbrt-v4")));
    EXPECT_EQ(world("LightSource \"spot\" \"float coneangle\" 2").lights.at(0).coneDeltaAngle, 2) << "its default is 5";
    EXPECT_EQ(warnings_.size(), 1u);
}

// pbrt-v4 renders these, and so do we: rougher than rough, a mirrored window, a narrow cone with the default falloff, a distance that
// nothing focuses at.
TEST_F(PbrtRanges, HoldWhatIsOnlyUnusual) {
    read(R"(Camera "perspective" "float focaldistance" 0 "float screenwindow" [1 -1 -1 1] "float fov" 179.9
        WorldBegin
        Material "conductor" "float roughness" 7 "bool remaproughness" false Shape "sphere"
        LightSource "spot" "float coneangle" 3
        LightSource "point" "float scale" 0
        LightSource "distant" "float illuminance" -1)");
    EXPECT_THAT(warnings_, IsEmpty());
}

// pbrt-v4 finds nothing there to hit; of a mesh, what is flat can still be seen.
TEST_F(PbrtRanges, WhatAScaleOfZeroLeavesNothingOfIsLeftOut) {
    EXPECT_THAT(world("Scale 0 1 1 Shape \"sphere\" Shape \"sphere\"").shapes, IsEmpty());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("test.pbrt:2:13: warning: shape \"sphere\": its transform cannot be inverted")));
    EXPECT_THAT(world("ObjectBegin \"a\" Shape \"sphere\" ObjectEnd Scale 0 0 0 ObjectInstance \"a\"").instances, IsEmpty());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("the instance's transform cannot be inverted")));
    EXPECT_EQ(world("Scale 0 1 1 Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0 1 1 0 0 1 1]").shapes.size(), 1u);
    EXPECT_THAT(warnings_, IsEmpty());
}

// However a light comes to take light away, it does not change how others are chosen.
TEST_F(PbrtRanges, ALightOfNegativePowerLeavesTheOthersAlone) {
    EXPECT_THROW(makeAliasTable(std::vector{1, -0.5}), std::logic_error);
    EXPECT_THROW(makeAliasTable(std::vector{1, std::nan("")}), std::logic_error);
    Scene scene = world("LightSource \"point\" LightSource \"point\"");
    scene.lights.at(1).scale = -1;
    Diagnostics diagnostics(LogLevel::silent);
    const PackedScene packed = packScene(scene, diagnostics);
    EXPECT_EQ(packed.tables.lights.at(0).pmf, 1);
    EXPECT_EQ(packed.tables.lights.at(1).pmf, 0);
}

}  // namespace
}  // namespace eikonal
