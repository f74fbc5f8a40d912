// Participating media. The defaults are those of pbrt-v4's source (media.cpp).

#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class PbrtMedia : public PbrtTest {
protected:
    Medium medium(const std::string& text) { return world("MakeNamedMedium \"m\" \"string type\" " + text).media.at(0); }
    std::string errorOfMedium(const std::string& text) { return errorOfWorld("MakeNamedMedium \"m\" \"string type\" " + text); }
};

const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" ";

TEST_F(PbrtMedia, homogeneous) {
    const Medium plain = medium("\"homogeneous\"");
    EXPECT_EQ(plain.name, "m");
    EXPECT_EQ(plain.sigmaA.value(), 1);
    EXPECT_EQ(plain.sigmaS.value(), 1);
    EXPECT_EQ(plain.Le.value(), 0);
    EXPECT_EQ(plain.g, 0);
    const Medium m = medium("\"homogeneous\" \"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [4 5 6] \"float scale\" 2 \"rgb Le\" [1 1 0] \"float Lescale\" 3 \"float g\" -.5");
    expectNear(m.sigmaA.albedo(), {2, 4, 6});
    expectNear(m.sigmaS.albedo(), {8, 10, 12});
    expectNear(m.Le.illuminant(), {3, 3, 0});
    EXPECT_EQ(m.g, -.5);
}

TEST_F(PbrtMedia, presetsAreMeasurements) {
    expectNear(medium("\"homogeneous\" \"string preset\" \"Skin1\" \"float scale\" 10").sigmaA.albedo(), {.32, 1.7, 4.8});
    EXPECT_EQ(medium("\"homogeneous\" \"string preset\" \"Skin3\"").sigmaS.value(), 1);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("there is no preset \"Skin3\"; did you mean \"Skin")));
}

TEST_F(PbrtMedia, uniformGrids) {
    const Scene scene = world("Scale 2 2 2 MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 2 \"integer ny\" 3 "
                              "\"float density\" [0 1 2 3 4 5] \"float Lescale\" [1 1 1 1 1 1] \"rgb Le\" [1 1 1] \"point3 p1\" [1 2 3] \"float scale\" 4");
    const Medium& m = scene.media[0];
    EXPECT_EQ(m.kind, MediumKind::uniformGrid);
    EXPECT_EQ(m.density.nx, 2);
    EXPECT_EQ(m.density.nz, 1);
    EXPECT_EQ(m.density.values.size(), 6u);
    EXPECT_EQ(m.LeScale.values.size(), 6u);
    EXPECT_EQ(m.sigmaA.value(), 4);
    expectNear(m.p0, {0, 0, 0});
    expectNear(m.p1, {1, 2, 3});
    expectNear(apply(m.worldFromMedium, {1, 0, 0}), {2, 0, 0});
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"integer nx\" 2 \"float density\" [1]"), HasSubstr("has 1 values; nx * ny * nz = 2 * 1 * 1 = 2 are expected"));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\""), HasSubstr("needs \"float density\""));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"integer nx\" 0 \"float density\" 1"), HasSubstr("must be at least 1"));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"integer nx\" 2000000000 \"integer ny\" 2000000000 \"integer nz\" 2000000000 \"float density\" 1"),
                HasSubstr("are expected"));
}

TEST_F(PbrtMedia, interfacesAreWhereMediaChange) {
    const Scene scene = world(fog + "MediumInterface \"fog\" \"\" Shape \"sphere\" MediumInterface \"\" \"fog\" Shape \"sphere\" "
                                    "MediumInterface \"fog\" Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].interface->inside, 0);
    EXPECT_EQ(scene.shapes[0].interface->outside, none);
    EXPECT_EQ(scene.shapes[1].interface->inside, none);
    EXPECT_EQ(scene.shapes[1].interface->outside, 0);
    EXPECT_FALSE(scene.shapes[2].interface.has_value());  // the same on both sides: a ray keeps its medium
}

TEST_F(PbrtMedia, names) {
    EXPECT_EQ(world("MediumInterface \"fog\" \"\" Shape \"sphere\" " + fog).shapes[0].interface->inside, 0);
    EXPECT_THAT(errorOfWorld(fog + "MediumInterface \"frog\" \"\" Shape \"sphere\" Shape \"disk\""), HasSubstr("there is no medium \"frog\"; did you mean \"fog\"?"));
    EXPECT_THAT(errorOfWorld(fog + fog), HasSubstr("there is already a medium \"fog\", at test.pbrt:2:1"));
    EXPECT_THAT(errorOfWorld("MakeNamedMedium \"m\""), HasSubstr("MakeNamedMedium needs a \"string type\""));
    EXPECT_EQ(world("MediumInterface \"never made\" \"\"").media.size(), 0u);  // nothing uses it
}

TEST_F(PbrtMedia, whatIsNotRenderedIsVacuum) {
    const Scene scene = world("MakeNamedMedium \"c\" \"string type\" \"cloud\" MediumInterface \"c\" \"\" Shape \"sphere\"");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("medium \"cloud\" is not rendered yet; it is empty")));
    EXPECT_FALSE(scene.shapes[0].interface.has_value());
    world("MakeNamedMedium \"c\" \"string type\" \"rgbgrid\" \"rgb sigma_s\" [1 1 1 2 2 2] \"integer nx\" 2");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("rgbgrid")));
}

}  // namespace
}  // namespace eikonal
